#include "app/window/main_window.h"

#include "app/canvas/canvas_rows.h"
#include "app/canvas/canvas_widget.h"
#include "app/canvas/reading/canvas_reading.h"
#include "app/dialogs/about_dialog.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/session/commands/keys.h"
#include "app/session/commands/session_rows.h"
#include "app/session/commands/underlay_commands.h"
#include "app/session/settings/kept_brush.h"
#include "app/session/settings/settings.h"
#include "app/tools/tool_options.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/habits/house_rules.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/habits/spoken_names.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/reduced_motion.h"
#include "app/widgets/numbers/length_units.h"
#include "app/window/dialog_rows.h"
#include "app/window/extending.h"
#include "app/window/files/exporting.h"
#include "app/window/files/file_opening.h"
#include "app/window/files/file_restoring.h"
#include "app/window/files/file_saving.h"
#include "app/window/files/importing.h"
#include "app/window/files/pasting.h"
#include "app/window/free_hand.h"
#include "app/window/helping.h"
#include "app/window/layout/docks.h"
#include "app/window/layout/proofing.h"
#include "app/window/layout/side_windows.h"
#include "app/window/layout/status_line.h"
#include "app/window/layout/tool_rack.h"
#include "app/window/layout/view_windows.h"
#include "app/window/layout/window_layout.h"
#include "app/window/layout/workspace_view.h"
#include "app/window/layout/workspaces.h"
#include "app/window/menus.h"
#include "app/window/palette_entries.h"
#include "app/window/pointer/at_pointer.h"
#include "app/window/rebuilt_windows.h"
#include "app/window/welcome/welcoming.h"
#include "model/journal/recovery.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QStringList>
#include <QToolBar>

#include <map>

namespace suffuse {

namespace {

QStringList localFiles(const QMimeData *data)
{
    QStringList files;
    for (const QUrl &url : data->urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

/// What the user has switched on and off, by the rows' ids. Full screen is the window's own state, hidden docks need
/// their layout first.
std::map<QString, bool> switchesOf(const Commands &table)
{
    std::map<QString, bool> switches;
    for (const QAction *action : table.all())
        if (action->isCheckable() && action != &table[Command::FullScreen] && action != &table[Command::HideDocks])
            switches[action->objectName()] = action->isChecked();
    return switches;
}

void setSwitches(const Commands &table, const std::map<QString, bool> &switches)
{
    for (QAction *action : table.all())
        if (const auto it = switches.find(action->objectName()); it != switches.end())
            action->setChecked(it->second);
}

/// What is searched for in the docks, by the names of the fields.
std::map<QString, QString> searchesOf(const QWidget &window)
{
    std::map<QString, QString> searches;
    for (const QLineEdit *field : window.findChildren<QLineEdit *>())
        if (field->objectName().endsWith(QLatin1String("Search")))
            searches[field->objectName()] = field->text();
    return searches;
}

void setSearches(const QWidget &window, const std::map<QString, QString> &searches)
{
    for (const auto &[name, text] : searches)
        if (auto *field = window.findChild<QLineEdit *>(name))
            field->setText(text);
}

/// In all windows: they share the shortcuts.
void changeShortcuts(QWidget &window)
{
    if (ShortcutsDialog(window.findChild<Commands *>()->all(), fixedKeys(), &window).exec() != QDialog::Accepted)
        return;
    for (const QWidget *other : QApplication::topLevelWidgets())
        if (const auto *table = other->findChild<Commands *>(QString(), Qt::FindDirectChildrenOnly))
            applyStoredShortcuts(table->all());
}

std::unique_ptr<OpenPainting> newPainting()
{
    auto open = std::make_unique<OpenPainting>();
    open->editor.newPainting(Editor::usualCanvas());
    open->editor.setBrush(settings::brush());
    return open;
}

} // namespace

MainWindow::MainWindow(QWidget *parent, MakeRenderer make) : MainWindow(newPainting(), std::move(make), parent) {}

MainWindow::MainWindow(std::unique_ptr<OpenPainting> open, MakeRenderer make, QWidget *parent)
    : MainWindow(std::move(open), std::move(make), parent, Places::Stored)
{}

MainWindow::MainWindow(std::unique_ptr<OpenPainting> open, MakeRenderer make, QWidget *parent, Places places)
    : QMainWindow(parent), m_open(std::move(open)), m_editor(m_open->editor), m_makeRenderer(std::move(make))
{
    installHouseRules();
    installSpokenNames();
    applyMotion();
    setAnimated(!motionIsReduced());
    installCanvasReading();
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    resize(1280, 800);
    new LengthUnits(*this, m_editor);
    m_canvas = new CanvasWidget(m_editor, this, m_makeRenderer);
    m_canvas->setPenSettings(settings::penSettings());
    setCentralWidget(m_canvas);
    m_commands = new Commands(icon, this);
    addSessionRows(*m_commands, *m_open);
    addCanvasRows(*m_commands, *m_canvas);
    makeParts({*this, *m_open, *m_canvas, *m_commands});
    addRows();
    showRows();
    connect(&m_editor, &Editor::fileChanged, m_parts, [this] { updateTitle(); });
    updateTitle();
    m_commands->update();
    if (places == Places::Stored)
        window_layout::restore(*this);
    action(Command::FullScreen).setChecked(isFullScreen());
    m_canvas->setFocus();
}

MainWindow::~MainWindow()
{
    if (m_open)
        release();
}

QAction &MainWindow::action(Command command)
{
    m_editor.laterChanges().flush(); // it may be asked whether it is enabled
    return (*m_commands)[command];
}

void MainWindow::makeParts(const Workplace &place)
{
    m_parts = new QObject(this);
    auto *keyboard = new KeyboardFocus(*this, *m_canvas);
    connect(keyboard, &KeyboardFocus::acting, this, [this] { m_editor.laterChanges().flush(); });
    m_toolOptions = new ToolOptionsBar(tr("Tool Options"), this);
    new ToolRack(place, *m_toolOptions, m_parts);
    auto *status = new StatusLine(place, m_parts);
    connect(keyboard, &KeyboardFocus::framed, status, &StatusLine::sayWhoHasKeyboard);
    new Proofing(place, m_parts);
    m_brush = new KeptBrush(m_editor, m_parts);
    m_saving = new FileSaving(place, m_parts);
    auto *restoring = new FileRestoring(place, *m_saving, m_parts);
    const auto makeWindow = [](std::unique_ptr<OpenPainting> open) {
        return (new MainWindow(std::move(open)))->m_opening;
    };
    m_opening = new FileOpening(place, *restoring, *m_brush, makeWindow, m_parts);
    m_importing = new Importing(place, m_parts);
    new Exporting(place, m_parts);
    new Pasting(place, m_parts);
    m_extending = new Extending(place, m_parts);
    addDialogRows(place);
    m_docks = new Docks(place, *keyboard, m_parts);
    m_workspaces = new Workspaces(
        place, [this](DockSet set) { resetLayout(set); }, m_parts);
    new AtPointer(place, m_parts);
    new SideWindows(place, m_parts);
    new ViewWindows(place, m_makeRenderer, m_parts);
    new Helping(place, m_parts);
    m_welcoming = new Welcoming(place, *m_opening, m_parts);
}

void MainWindow::addRows()
{
    using enum Command;
    m_commands->add(Close, "close", Commands::tr("&Close Window"), "", QKeySequence::keyBindings(QKeySequence::Close))
        .runs([this] { close(); });
    m_commands->add(Quit, "quit", Commands::tr("&Quit"), "", {QKeySequence(Commands::tr("Ctrl+Q"))}).runs([] {
        QWidgetList windows = QApplication::topLevelWidgets();
        for (const QWidget *window : std::as_const(windows))
            EntryField::takeTypedIn(*window); // It may be what makes a painting unsaved work.
        // Who is asked about unsaved work and cancels keeps all windows, not only those that come later.
        std::stable_partition(windows.begin(), windows.end(), [](const QWidget *w) { return w->isWindowModified(); });
        for (QWidget *window : windows)
            if (window->isWindowModified() && window->isVisible() && !window->close())
                return;
        QApplication::closeAllWindows();
    });
    action(Quit).setMenuRole(QAction::QuitRole);
    m_commands->add(Settings, "settings", Commands::tr("Settin&gs…"), "", {QKeySequence(Commands::tr("Ctrl+,"))})
        .runs([this] { changeSettings(); });
    action(Settings).setMenuRole(QAction::PreferencesRole);
    m_commands->add(FullScreen, "fullScreen", Commands::tr("Full S&creen"), "", {QKeySequence(Qt::Key_F11)})
        .checkable()
        .runs([this] {
            whenHandIsFree(*m_canvas, *this, [this] {
                const bool full = action(FullScreen).isChecked();
                setWindowState(full ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
            });
        });
    m_commands
        ->add(ResetLayout, "resetLayout", Commands::tr("Reset La&yout"), "", {},
              Commands::tr("Docks and tool bars go back to where they stand at the first start"))
        .runs([this] { whenHandIsFree(*m_canvas, *this, [this] { resetLayout(DockSet::Usual); }); });
    m_commands
        ->add(FindCommand, "findCommand", Commands::tr("&Find a Command…"), "", {QKeySequence(Commands::tr("Ctrl+K"))},
              Commands::tr("Commands, brushes, docks and recent files by their names"))
        .runs([this] { CommandPalette::ask(paletteEntries(), *m_canvas); });
    m_commands
        ->add(Shortcuts, "shortcuts", Commands::tr("&Keyboard Shortcuts…"), "", {QKeySequence(Commands::tr("Ctrl+F1"))})
        .runs([this] { changeShortcuts(*this); });
    m_commands->add(About, "about", Commands::tr("&About Suffuse…"), "", {}).runs([this] { AboutDialog(this).exec(); });
    action(About).setMenuRole(QAction::AboutRole);
}

void MainWindow::showRows()
{
    addActions(m_commands->all()); // keys work with the menu bar hidden, too
    applyStoredShortcuts(m_commands->all());
    m_tools = makeToolBar(*m_commands, this);
    placeToolBars();
    const OpenMenus menus = fillMenus(*menuBar(), *m_commands);
    connect(menus.recent, &QMenu::aboutToShow, m_opening,
            [this, menu = menus.recent] { m_opening->fillRecentMenu(*menu); });
    connect(menus.workspaces, &QMenu::aboutToShow, m_workspaces,
            [this, menu = menus.workspaces] { m_workspaces->fillMenu(*menu); });
    m_extending->fill(*menus.extensions);
    m_docksMenu = menus.docks;
    for (QDockWidget *dock : m_docks->all())
        m_docksMenu->addAction(dock->toggleViewAction());
    m_docksMenu->addSeparator();
    m_docksMenu->addAction(m_tools->toggleViewAction());
    m_docksMenu->addAction(m_toolOptions->toggleViewAction());
}

void MainWindow::placeToolBars()
{
    addToolBar(Qt::LeftToolBarArea, m_tools);
    addToolBar(Qt::TopToolBarArea, m_toolOptions);
}

void MainWindow::resetLayout(DockSet set)
{
    m_docks->arrangeAnew(set);
    placeToolBars();
    for (QToolBar *bar : {m_tools, static_cast<QToolBar *>(m_toolOptions)})
        bar->show();
}

std::vector<PaletteEntry> MainWindow::paletteEntries()
{
    return suffuse::paletteEntries(
        m_editor, *m_commands, m_docksMenu->actions(), m_extending->actions(),
        [this](QAction &toggle) { m_docks->toggle(toggle); }, [this](const QString &path) { openFile(path); });
}

MainWindow *MainWindow::openFile(const QString &path)
{
    const FileOpening *shown = m_opening->open(path);
    return shown ? static_cast<MainWindow *>(&shown->window()) : nullptr;
}

MainWindow *MainWindow::openRecovered(LostDocument document)
{
    return static_cast<MainWindow *>(&m_opening->openRecovered(std::move(document))->window());
}

void MainWindow::importStrokes(const QString &path)
{
    m_importing->importStrokes(path);
}

void MainWindow::greet()
{
    m_welcoming->greet();
}

bool MainWindow::save()
{
    return m_saving->save();
}

bool MainWindow::saveTo(const QString &path)
{
    return m_saving->saveTo(path);
}

void MainWindow::changeSettings()
{
    SettingsDialog dialog(this, m_editor.brush());
    if (dialog.exec() != QDialog::Accepted)
        return;
    m_canvas->setPenSettings(settings::penSettings());
    recolourWindows();
    if (dialog.needsOtherWindows())
        rebuildWindowsSoon(*this); // this is an action of one of them
}

void MainWindow::updateTitle()
{
    setWindowTitle(QStringLiteral("%1[*] — Suffuse").arg(m_editor.displayName()));
    setWindowFilePath(m_editor.filePath());
    setWindowModified(m_editor.isModified());
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::WindowStateChange && m_commands) // the window manager has keys for it, too
        action(Command::FullScreen).setChecked(isFullScreen());
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    EntryField::takeTypedIn(*this); // What is typed or in hand is part of the work that is asked about.
    const QList<QDialog *> beside = findChildren<QDialog *>();
    for (const QDialog *dialog : beside)
        EntryField::takeTypedIn(*dialog);
    m_canvas->finishGesture();
    m_canvas->settleTool();
    if (!m_saving->maySwitch()) {
        event->ignore();
        return;
    }
    for (QDialog *dialog : beside)
        if (dialog->isVisible() && !dialog->isModal())
            dialog->accept(); // Closed later it would take back what it shows, and the journal would begin anew.
    if (action(Command::HideDocks).isChecked()) // they are to come back next time
        action(Command::HideDocks).trigger();
    window_layout::save(*this);
    m_brush->finish();
    m_open->journal.remove();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    MainWindow *window = this;
    QStringList pictures;
    for (const QString &file : localFiles(event->mimeData())) {
        if (underlay::isPicture(file))
            pictures << file;
        else if (MainWindow *opened = window->openFile(file))
            window = opened;
    }
    if (!pictures.isEmpty())
        window->m_importing->offer(pictures, mapToGlobal(event->position().toPoint()));
}

std::unique_ptr<OpenPainting> MainWindow::release()
{
    if (m_canvas->tool())
        m_canvas->tool()->cancel();
    m_editor.commit(); // no widget that goes puts anything back
    for (QObject *follower : std::initializer_list<QObject *>{m_commands, m_parts, m_canvas})
        delete follower; // of a painting that goes
    m_commands = nullptr;
    m_parts = nullptr;
    m_canvas = nullptr;
    return std::move(m_open);
}

MainWindow *MainWindow::replace()
{
    if (m_canvas->tool())
        m_canvas->tool()->cancel();
    const bool hidesDocks = action(Command::HideDocks).isChecked();
    if (hidesDocks)
        action(Command::HideDocks).trigger();
    const QByteArray geometry = saveGeometry(), layout = saveState();
    const std::optional<WorkspaceState> view = workspaceOf(canvas(), m_editor);
    const std::map<QString, bool> switches = switchesOf(*m_commands);
    const std::map<QString, QString> searches = searchesOf(*this);
    auto *successor = new MainWindow(release(), m_makeRenderer, nullptr, Places::Given);
    setSwitches(*successor->m_commands, switches);
    setSearches(*successor, searches);
    successor->setAttribute(Qt::WA_DeleteOnClose, testAttribute(Qt::WA_DeleteOnClose));
    successor->restoreGeometry(geometry);
    successor->restoreState(layout);
    successor->m_commands->update();
    successor->show();
    if (view)
        showWorkspace(*view, *successor->m_canvas, successor->m_editor);
    if (hidesDocks)
        successor->action(Command::HideDocks).trigger();
    return successor;
}

} // namespace suffuse
