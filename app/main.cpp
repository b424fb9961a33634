// The editor.
#include "app/canvas/presenters/presenter.h"
#include "app/session/files/journal.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/theme.h"
#include "app/window/files/recovery.h"
#include "app/window/files/running_program.h"
#include "app/window/layout/window_layout.h"
#include "app/window/main_window.h"
#include "model/environment.h"
#include "undo/lettering/shaped_line.h"

#include <QApplication>
#include <QScreen>
#include <QTimer>

#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace {

constexpr const char *usage = "Usage: suffuse [OPTIONS] [FILE...]\n"
                              "\n"
                              "Opens the editor, each FILE in a window of its own: paintings (.suffuse, or their text\n"
                              "form .json), pen recordings (.csv, .json, .excalidraw, .dat, .xopp)\n"
                              "and SVG drawings.\n"
                              "\n"
                              "  --new-painting  begin a new painting, in the Suffuse that runs already if there is one\n"
                              "  --new-instance  start anew even if Suffuse runs already; so do the next three,\n"
                              "                  and options of Qt\n"
                              "  --backend=NAME  draw with auto, cpu or cuda, whatever the settings say\n"
                              "  --reset-layout  forget where windows and docks were\n"
                              "  --safe-mode     start with the usual settings, drawing on the CPU; nothing is kept\n"
                              "  --service       wait for the desktop to say what is to be opened (D-Bus activation)\n"
                              "  --version       print the version\n"
                              "  --help          print this\n"
                              "\n"
                              "Where Suffuse runs already, files are opened in that one, and this one ends.\n"
                              "Options of Qt (such as -platform) are taken too. suffuse-cli needs no display.\n";

struct Options {
    bool resetLayout = false;
    bool safeMode = false;
    bool newPainting = false;
    bool newInstance = false;
    bool service = false;
    int exitCode = -1; ///< 0 or more: nothing is left to do
};

/// What can be answered without a display is answered here; Qt's own options have one dash.
Options readOptions(int argc, char **argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string_view arg = argv[i];
        if (arg == "--")
            break;
        if (arg == "--version") {
            std::printf("suffuse %s\n", SUFFUSE_VERSION);
            options.exitCode = 0;
        } else if (arg == "--help" || arg == "-h") {
            std::fputs(usage, stdout);
            options.exitCode = 0;
        } else if (arg == "--reset-layout") {
            options.resetLayout = options.newInstance = true;
        } else if (arg == "--safe-mode") {
            options.safeMode = options.newInstance = true;
        } else if (arg == "--new-painting") {
            options.newPainting = true;
        } else if (arg == "--new-instance") {
            options.newInstance = true;
        } else if (arg == "--service") {
            options.service = true;
        } else if (arg == "--backend=auto" || arg == "--backend=cpu" || arg == "--backend=cuda") {
            suffuse::environment::set(suffuse::environment::Variable::Backend, argv[i] + arg.find('=') + 1);
            options.newInstance = true;
        } else if (arg.starts_with("--") && arg != "--platform" && arg != "--style") {
            std::fprintf(stderr, "suffuse: unknown option %s. suffuse --help lists the options.\n", argv[i]);
            options.exitCode = 2;
        } else if (arg.starts_with("-")) { // one of Qt's
            options.newInstance = true;
        }
        if (options.exitCode >= 0)
            break;
    }
    return options;
}

/// Qt aborts without a display; a message is better.
bool hasDisplay(int argc, char **argv)
{
#ifdef Q_OS_LINUX
    for (int i = 1; i < argc; ++i)
        if (std::string_view(argv[i]) == "-platform" || std::string_view(argv[i]) == "--platform")
            return true;
    namespace environment = suffuse::environment;
    using enum environment::Variable;
    return environment::isSet(QtPlatform) || !environment::value(Display).empty() ||
           !environment::value(WaylandDisplay).empty();
#else
    (void)argc, (void)argv;
    return true;
#endif
}

QStringList filesOf(const QStringList &arguments)
{
    QStringList files;
    bool onlyFiles = false;
    for (const QString &argument : arguments) {
        if (!onlyFiles && argument == "--")
            onlyFiles = true;
        else if (onlyFiles || !argument.startsWith("--"))
            files << argument;
    }
    return files;
}

/// Before anything is drawn or read. Returns where settings are that were put aside, or nothing.
QString takeSettings(const Options &options)
{
    if (options.safeMode) {
        suffuse::settings::forgetEverything();
        suffuse::environment::set(suffuse::environment::Variable::Backend, "cpu");
        suffuse::environment::set(suffuse::environment::Variable::Presenter, "raster");
    }
    return suffuse::settings::beginStart();
}

/// Whether a program that runs already does what this start asks for. It takes neither settings nor a display.
bool handedOver(int argc, char **argv, bool newPainting)
{
    const QCoreApplication application(argc, argv);
    return suffuse::handOver({filesOf(QCoreApplication::arguments().mid(1)), newPainting});
}

/// A window with a new painting.
suffuse::MainWindow *showWindow()
{
    auto *window = new suffuse::MainWindow;
    window->setAttribute(Qt::WA_DeleteOnClose);
    window->resize(window->size().boundedTo(window->screen()->availableSize()));
    if (suffuse::window_layout::isStored())
        window->show();
    else // the first start: as much of the picture as there can be, as other painting programs do
        window->showMaximized();
    return window;
}

/// What comes after the first window: whoever waits for it must not wait for this. `greets`: the welcome page, too.
void offerAfterStart(suffuse::MainWindow *first, const QString &putAside, bool greets)
{
    constexpr int upMs = 500; // shown, and drawn
    QTimer::singleShot(upMs, first, [] { suffuse::settings::startSucceeded(); });
    QTimer::singleShot(0, first, [first, putAside, greets] {
        if (!putAside.isEmpty())
            suffuse::showNotice(first, QCoreApplication::translate("Messages",
                                                                   "Suffuse did not come up the last times, so "
                                                                   "it has started with the usual settings. Yours are "
                                                                   "kept in %1.")
                                           .arg(putAside));
        suffuse::offerRecovery(*first, suffuse::journalFolder());
        if (greets) // once the window is up: the first picture comes first
            QTimer::singleShot(upMs, first, [first] { first->greet(); });
    });
}

} // namespace

int main(int argc, char **argv)
{
    const Options options = readOptions(argc, argv);
    if (options.exitCode >= 0)
        return options.exitCode;
    if (options.resetLayout && !hasDisplay(argc, argv)) {
        QCoreApplication::setApplicationName("suffuse");
        suffuse::window_layout::reset();
        return 0;
    }
    if (!hasDisplay(argc, argv)) {
        std::fputs("suffuse: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set). Start it in a desktop "
                   "session, or use suffuse-cli, which needs none.\n",
                   stderr);
        return 1;
    }
    if (!options.newInstance && !options.service && handedOver(argc, argv, options.newPainting))
        return 0;
    const QString putAside = takeSettings(options);
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    suffuse::prepareOpenGl();
    QApplication app(argc, argv);
    QCoreApplication::setApplicationName("suffuse");
    QCoreApplication::setApplicationVersion(SUFFUSE_VERSION);
    QGuiApplication::setApplicationDisplayName({}); // titles name the program themselves
    QGuiApplication::setDesktopFileName("org.suffuse.Suffuse");
    QGuiApplication::setWindowIcon(suffuse::applicationIcon());
    suffuse::installTranslators();
    suffuse::applyTheme();
    suffuse::LineShaper shaper; // of texts in drawings
    suffuse::setLetterShaper(&shaper);
    if (options.resetLayout)
        suffuse::window_layout::reset();

    suffuse::Journal::setFolder(suffuse::journalFolder());
    bool isFirst = true;
    const bool greets = !options.service && !options.newPainting && filesOf(app.arguments().mid(1)).isEmpty();
    suffuse::RunningProgram program([&] {
        suffuse::MainWindow *window = showWindow();
        if (std::exchange(isFirst, false))
            offerAfterStart(window, putAside, greets);
        return window;
    });
    if (!options.newInstance)
        program.begin();
    if (!options.service) {
        program.carryOut({filesOf(app.arguments().mid(1)), options.newPainting});
    } else { // A desktop that starts a program and then asks for nothing has changed its mind.
        constexpr int patienceMs = 20'000;
        QTimer::singleShot(patienceMs, &app, [&] {
            if (isFirst)
                QApplication::quit();
        });
    }
    return QApplication::exec();
}
