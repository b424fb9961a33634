// The commands of a farm: suffuse-cli farm COMMAND.
#pragma once

#include "app/cli/farm/farm_plan.h"

namespace suffuse::cli {

/// Each takes program, the command's name and its arguments, and returns an ExitCode.
int farmPlanCommand(const QStringList &arguments);
int farmRunCommand(const QStringList &arguments);
int farmStatusCommand(const QStringList &arguments);
int farmVerifyCommand(const QStringList &arguments);
int farmJoinCommand(const QStringList &arguments);
int farmSlurmCommand(const QStringList &arguments);
int farmOpenJdCommand(const QStringList &arguments);
int farmFlamencoCommand(const QStringList &arguments);

} // namespace suffuse::cli
