// suffuse-cli: paintings without a window, and without a display.
#include "app/cli/application.h"
#include "app/cli/options.h"
#include "app/cli/pictures/bench_command.h"

#include <QCoreApplication>
#include <QTextStream>

#include <array>
#include <csignal>

namespace suffuse::cli {

namespace {

struct Command {
    const char *name;
    int (*run)(const QStringList &);
    const char *summary;
};

constexpr std::array commands = {
    Command{"render", renderCommand, QT_TRANSLATE_NOOP("Cli", "draw a painting into an image file")},
    Command{"info", infoCommand, QT_TRANSLATE_NOOP("Cli", "what a file holds; the backends there are")},
    Command{"convert", convertCommand, QT_TRANSLATE_NOOP("Cli", "between documents, the text form and recordings")},
    Command{"diff", diffCommand, QT_TRANSLATE_NOOP("Cli", "what differs between two paintings, and where")},
    Command{"probe", probeCommand, QT_TRANSLATE_NOOP("Cli", "what lies at a point of the canvas")},
    Command{"verify", verifyCommand, QT_TRANSLATE_NOOP("Cli", "compare the backends with the reference")},
    Command{"timelapse", timelapseCommand, QT_TRANSLATE_NOOP("Cli", "draw a painting while it is painted, as frames")},
    Command{"thumbnail", thumbnailCommand, QT_TRANSLATE_NOOP("Cli", "a small picture of a painting, for file managers")},
    Command{"farm", farmCommand, QT_TRANSLATE_NOOP("Cli", "let many machines draw pictures in tiles, and films")},
    Command{"fit", fitCommand, QT_TRANSLATE_NOOP("Cli", "make a painting of a picture")},
    Command{"refit", refitCommand, QT_TRANSLATE_NOOP("Cli", "make fewer strokes that look like those of a painting")},
    Command{"extension", extensionCommand, QT_TRANSLATE_NOOP("Cli", "run programs of others on a painting")},
    Command{"recover", recoverCommand, QT_TRANSLATE_NOOP("Cli", "what was not saved when the editor ended")},
    Command{"bench", benchCommand, QT_TRANSLATE_NOOP("Cli", "measure how fast this machine draws")},
};

QString help()
{
    QString text = QCoreApplication::translate("Cli", "Usage: suffuse-cli COMMAND [options] …") + "\n\n";
    for (const Command &c : commands)
        text += QStringLiteral("  %1%2\n")
                    .arg(QLatin1String(c.name), -10)
                    .arg(QCoreApplication::translate("Cli", c.summary));
    text +=
        '\n' +
        QCoreApplication::translate(
            "Cli", "suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help "
                   "COMMAND. An input of - is standard input.\nExit codes: 0 done, 1 the work failed, 2 wrong usage.") +
        '\n';
    return text;
}

int run(const QStringList &given)
{
    QStringList arguments = given;
    if (arguments.value(1) == "help" && arguments.size() == 3) // "help render" is "render --help"
        arguments = {arguments[0], arguments[2], QStringLiteral("--help")};
    const QString name = arguments.value(1);
    if (name == "--help" || name == "-h" || name == "help")
        return print(help());
    if (name == "--version" || name == "-v")
        return print(QStringLiteral("suffuse-cli " SUFFUSE_VERSION "\n"));
    for (const Command &c : commands)
        if (name == QLatin1String(c.name))
            return c.run(arguments);
    if (name.isEmpty()) {
        QTextStream(stderr) << help();
        return WrongUsage;
    }
    return fail(QCoreApplication::translate("Cli", "%1: there is no such command. See suffuse-cli --help.").arg(name),
                WrongUsage);
}

} // namespace

} // namespace suffuse::cli

int main(int argc, char *argv[])
{
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe is a failed write, not a silent end
    const suffuse::cli::Application app(argc, argv);
    suffuse::cli::interrupted(); // from now on an interrupt leaves no half file
    return suffuse::cli::run(QCoreApplication::arguments());
}
