#include "model/environment.h"
#include "undo/lettering/module_api.h"
#include "undo/lettering/shaped_line.h"

#include <QGuiApplication>

extern "C" {
__attribute__((visibility("default"))) int suffuse_lettering_version()
{
    return suffuse::letteringModuleVersion;
}

__attribute__((visibility("default"))) QCoreApplication *suffuse_lettering_application(int &argc, char **argv)
{
    suffuse::environment::set(suffuse::environment::Variable::QtPlatform, "offscreen");
    // What a desktop's session would have is missed in vain, and a command line must not tell of it.
    const QtMessageHandler before =
        qInstallMessageHandler([](QtMsgType, const QMessageLogContext &, const QString &) {});
    auto *application = new QGuiApplication(argc, argv);
    qInstallMessageHandler(before);
    return application;
}

__attribute__((visibility("default"))) suffuse::LetterShaper *suffuse_lettering_shaper()
{
    return new suffuse::LineShaper;
}
}
