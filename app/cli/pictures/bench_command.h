// suffuse-cli bench: the figures of docs/performance.md on this machine.
#pragma once

#include <QStringList>

namespace suffuse::cli {

/// `arguments` as QCoreApplication::arguments(); returns an ExitCode.
int benchCommand(const QStringList &arguments);

} // namespace suffuse::cli
