#include "undo/lettering/module_api.h"
#include "undo/lettering/shaped_line.h"

#include <QGuiApplication>

#include <vector>

extern "C" {
__attribute__((visibility("default"))) int suffuse_lettering_version()
{
    return suffuse::letteringModuleVersion;
}

__attribute__((visibility("default"))) QCoreApplication *suffuse_lettering_application(int &argc, char **argv)
{
    // Programs that this one starts may well use a display, so the environment stays what it is.
    static char option[] = "-platform", platform[] = "offscreen";
    static std::vector<char *> arguments;
    arguments.assign(argv, argv + argc);
    arguments.insert(arguments.end(), {option, platform, nullptr});
    argc += 2; // Qt takes them away again.
    // What a desktop's session would have is missed in vain, and a command line must not tell of it.
    const QtMessageHandler before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext &, const QString &) {});
    auto *application = new QGuiApplication(argc, arguments.data());
    qInstallMessageHandler(before);
    return application;
}

__attribute__((visibility("default"))) suffuse::LetterShaper *suffuse_lettering_shaper()
{
    return new suffuse::LineShaper;
}
}
