#include "app/cli/farm/farm_commands.h"

#include <QCoreApplication>
#include <QTextStream>

#include <array>

namespace suffuse::cli {

namespace {

struct FarmCommand {
    const char *name;
    int (*run)(const QStringList &);
    const char *summary;
};

constexpr std::array farmCommands = {
    FarmCommand{"plan", farmPlanCommand, QT_TRANSLATE_NOOP("Cli", "say what is to be drawn, in a shared folder")},
    FarmCommand{"run", farmRunCommand, QT_TRANSLATE_NOOP("Cli", "draw a part of it, on any machine")},
    FarmCommand{"status", farmStatusCommand, QT_TRANSLATE_NOOP("Cli", "what is missing")},
    FarmCommand{"verify", farmVerifyCommand,
                QT_TRANSLATE_NOOP("Cli", "read all that is there, and compare the hashes")},
    FarmCommand{"join", farmJoinCommand, QT_TRANSLATE_NOOP("Cli", "put the pictures together")},
    FarmCommand{"slurm", farmSlurmCommand, QT_TRANSLATE_NOOP("Cli", "submit the work as a job array of Slurm")},
    FarmCommand{"openjd", farmOpenJdCommand, QT_TRANSLATE_NOOP("Cli", "print the work as an Open Job Description")},
    FarmCommand{"flamenco", farmFlamencoCommand, QT_TRANSLATE_NOOP("Cli", "print the work as a job type of Flamenco")},
};

QString farmHelp()
{
    QString text = QCoreApplication::translate("Cli", "Usage: suffuse-cli farm COMMAND [options] …") + "\n\n";
    for (const FarmCommand &c : farmCommands)
        text += QStringLiteral("  %1%2\n")
                    .arg(QLatin1String(c.name), -10)
                    .arg(QCoreApplication::translate("Cli", c.summary));
    return text;
}

} // namespace

int farmCommand(const QStringList &arguments)
{
    const QString name = arguments.value(2);
    if (name == "--help" || name == "-h")
        return print(farmHelp());
    QStringList own = arguments;
    own.removeAt(1);
    for (const FarmCommand &c : farmCommands)
        if (name == QLatin1String(c.name))
            return c.run(own);
    if (name.isEmpty()) {
        QTextStream(stderr) << farmHelp();
        return WrongUsage;
    }
    return fail(
        QCoreApplication::translate("Cli", "farm %1: there is no such command. See suffuse-cli farm --help.").arg(name),
        WrongUsage);
}

} // namespace suffuse::cli
