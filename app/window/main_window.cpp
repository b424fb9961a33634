#include "app/window/main_window.h"

#include "app/canvas/canvas_rows.h"
#include "app/canvas/canvas_widget.h"
#include "app/dialogs/about_dialog.h"
#include "app/dialogs/command_palette.h"
#include "app/dialogs/export_settings.h"
#include "app/dialogs/new_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/history/history_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/probe/probe_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/session/commands/keys.h"
#include "app/session/commands/session_rows.h"
#include "app/session/settings/settings.h"
#include "app/tools/attribute_brush_tool.h"
#include "app/tools/brush_tool.h"
#include "app/tools/eraser_tool.h"
#include "app/tools/eyedropper_tool.h"
#include "app/tools/knife_tool.h"
#include "app/tools/node_tool.h"
#include "app/tools/pan_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/tool_options.h"
#include "app/widgets/at_next_change.h"
#include "app/widgets/choose_picture.h"
#include "app/widgets/house_rules.h"
#include "app/widgets/icons.h"
#include "app/widgets/keyboard_focus.h"
#include "app/widgets/place_beside.h"
#include "app/widgets/section.h"
#include "app/window/menus.h"
#include "app/window/palette_entries.h"
#include "app/window/window_layout.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QToolBar>

namespace suffuse {

namespace {

/// Logical pixels that every screen has for a panel.
constexpr int lowPanel = 110;
/// Of a screen, from which on the inspector and the strokes have room below each other.
constexpr int highScreen = 950;

/// Gives a panel as much room as it wants, and lets it scroll where the window is low.
class LowScroll : public PanelScroll {
public:
    explicit LowScroll(QWidget *panel) { setWidget(panel); }
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override { return {PanelScroll::minimumSizeHint().width(), lowPanel}; }
};

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
    : QMainWindow(parent), m_open(std::move(open)), m_editor(m_open->editor), m_playback(&m_open->playback),
      m_selectionOrder(&m_open->selectionOrder), m_journal(&m_open->journal), m_makeRenderer(std::move(make))
{
    installHouseRules();
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    resize(1280, 800);
    m_canvas = new CanvasWidget(m_editor, this, m_makeRenderer);
    setCentralWidget(m_canvas);
    m_keyboard = new KeyboardFocus(*this, *m_canvas);
    m_commands = new Commands(icon, this);
    addSessionRows(*m_commands, *m_open);
    addCanvasRows(*m_commands, *m_canvas);
    m_toolOptions = new ToolOptionsBar(tr("Tool Options"), this);
    makeStatusBar();
    addToolRows();
    addFileRows();
    addSavingRows();
    addExportRows();
    addClipboardRows();
    addObjectRows();
    addTimeRows();
    addWindowRows();
    const OpenMenus menus = fillMenus(*menuBar(), *m_commands);
    m_recentMenu = menus.recent;
    m_docksMenu = menus.docks;
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    addActions(m_commands->all()); // keys work with the menu bar hidden, too
    applyStoredShortcuts(m_commands->all());
    QToolBar *tools = makeToolBar(*m_commands, this);
    addToolBar(Qt::LeftToolBarArea, tools);
    addToolBar(Qt::TopToolBarArea, m_toolOptions);
    makeDocks();
    m_docksMenu->addSeparator();
    m_docksMenu->addAction(tools->toggleViewAction());
    m_docksMenu->addAction(m_toolOptions->toggleViewAction());
    action(Command::Brush).setChecked(true);
    m_canvas->setPenSettings(settings::penSettings());
    connectBrushes();
    connectSaving();
    connectUpdates();
    updateTitle();
    m_commands->update();
    updateZoom();
    window_layout::restore(*this);
    action(Command::FullScreen).setChecked(isFullScreen());
    m_canvas->setFocus();
}

QAction &MainWindow::action(Command command)
{
    m_editor.laterChanges().flush(); // it may be asked whether it is enabled
    return (*m_commands)[command];
}

MainWindow::~MainWindow()
{
    if (m_open)
        release();
}

QDockWidget *MainWindow::addDock(const char *name, const QString &title, QWidget *panel)
{
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(panel->minimumSizeHint().height() > lowPanel ? new LowScroll(panel) : panel);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    m_docksMenu->addAction(dock->toggleViewAction());
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
        if (shown) // and not as a tab behind another
            dock->raise();
    });
    m_docks << dock;
    return dock;
}

void MainWindow::makeDocks()
{
    QDockWidget *colour = addDock("colourDock", tr("Colour"), new ColourPanel(m_editor));
    QDockWidget *brushes = addDock("brushesDock", tr("Brushes"), new BrushPanel(m_editor));
    auto *inspectorPanel = new InspectorPanel(m_editor);
    QDockWidget *inspector = addDock("inspectorDock", tr("Inspector"), inspectorPanel);
    connect(inspectorPanel, &InspectorPanel::alongOpening, m_canvas,
            [this](QWidget *dialog) { moveBeside(*dialog, m_canvas->selectionOnScreen()); });
    m_strokes = new StrokesPanel(m_editor);
    m_strokes->addActions(m_commands->of(CommandScope::Strokes));
    QDockWidget *strokes = addDock("strokesDock", tr("Strokes"), m_strokes);
    QDockWidget *history = addDock("historyDock", tr("History"), new HistoryPanel(m_editor));
    tabifyDockWidget(colour, brushes);
    const bool isHigh = screen()->availableSize().height() >= highScreen;
    if (!isHigh)
        tabifyDockWidget(inspector, strokes);
    tabifyDockWidget(strokes, history);
    auto *probe = new ProbePanel(m_editor);
    QDockWidget *probeDock = addDock("probeDock", tr("Probe"), probe);
    tabifyDockWidget(history, probeDock);
    probeDock->hide();
    connect(m_canvas, &CanvasWidget::pointerMoved, probe, [probe](double x, double y) { probe->setPoint({x, y}); });
    connect(m_canvas, &CanvasWidget::pointerLeft, probe, &ProbePanel::leaveCanvas);
    colour->raise();
    (isHigh ? strokes : inspector)->raise();
    setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    auto *timelinePanel = new TimelinePanel(m_editor, *m_playback, *m_commands);
    timelinePanel->addActions(m_commands->of(CommandScope::Timeline));
    QDockWidget *timeline = addDock("timelineDock", tr("Timeline"), timelinePanel);
    addDockWidget(Qt::BottomDockWidgetArea, timeline);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    resizeDocks({timeline}, {150}, Qt::Vertical);
    resizeDocks({colour, inspector, strokes}, {300, 300, 300}, Qt::Horizontal);
    if (isHigh)
        resizeDocks({colour, inspector, strokes}, {360, 285, 255}, Qt::Vertical);
    else
        resizeDocks({colour, inspector}, {300, 360}, Qt::Vertical);
}

void MainWindow::addToolRows()
{
    using enum Command;
    const auto add = [this](Command command, const char *id, const QString &text, const char *icon, Qt::Key key,
                            const QString &tip, Tool *tool) {
        m_commands->add(command, QString::fromLatin1(id), text, icon, {QKeySequence(key)}, tip)
            .toggles([this, tool](bool on) {
                if (on)
                    useTool(tool);
            });
        connect(tool, &Tool::hintChanged, this, &MainWindow::showHint);
        m_toolOptions->setWidget(tool->options()); // the row is as high as the highest from the start
    };
    CanvasWidget *canvas = m_canvas;
    add(Brush, "brush", Commands::tr("&Brush"), "brush", Qt::Key_B, Commands::tr("Paint strokes"),
        new BrushTool(*canvas, canvas));
    add(Select, "select", Commands::tr("&Select"), "select", Qt::Key_V, Commands::tr("Select and move strokes"),
        new SelectTool(*canvas, *m_commands, canvas));
    add(Segments, "segments", Commands::tr("Se&gments"), "segments", Qt::Key_N,
        Commands::tr("Edit segments, nodes and handles of strokes"), new NodeTool(*canvas, *m_commands, canvas));
    add(Knife, "knife", Commands::tr("&Knife"), "knife", Qt::Key_K, Commands::tr("Cut strokes along a line"),
        new KnifeTool(*canvas, canvas));
    add(Eraser, "eraser", Commands::tr("&Eraser"), "eraser", Qt::Key_E, Commands::tr("Erase parts of strokes"),
        new EraserTool(*canvas, canvas));
    add(AttributeBrush, "attributeBrush", Commands::tr("&Attribute Brush"), "attribute-brush", Qt::Key_A,
        Commands::tr("Paint values onto segments"), new AttributeBrushTool(*canvas, canvas));
    add(Eyedropper, "eyedropper", Commands::tr("Eye&dropper"), "eyedropper", Qt::Key_I, Commands::tr("Pick a colour"),
        new EyedropperTool(*canvas, canvas));
    add(Pan, "pan", Commands::tr("&Hand"), "pan", Qt::Key_H, Commands::tr("Move the canvas"),
        new PanTool(*canvas, canvas));
    m_commands->makeExclusive({Brush, Select, Segments, Knife, Eraser, AttributeBrush, Eyedropper, Pan});
    // The pen's other end erases, whatever its tip does.
    connect(m_canvas, &CanvasWidget::penTurned, this, [this](bool eraser) {
        QAction *inUse = action(Command::Brush).actionGroup()->checkedAction();
        if (eraser && inUse != &action(Command::Eraser)) {
            m_tipAction = inUse;
            action(Command::Eraser).setChecked(true);
        } else if (!eraser && m_tipAction) {
            if (inUse == &action(Command::Eraser))
                m_tipAction->setChecked(true);
            m_tipAction = nullptr;
        }
    });
}

void MainWindow::useTool(Tool *tool)
{
    m_nextTool = m_canvas->isPressed() && m_canvas->tool()->isBusy() ? tool : nullptr;
    if (m_nextTool) // when the stroke in hand is finished
        return;
    m_canvas->setTool(tool);
    m_toolOptions->setWidget(tool->options());
    showHint();
}

void MainWindow::addFileRows()
{
    using enum Command;
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    m_commands->add(New, "new", Commands::tr("&New…"), "new", keys(QKeySequence::New)).runs([this] { newWindow(); });
    m_commands->add(Open, "open", Commands::tr("&Open…"), "open", keys(QKeySequence::Open)).runs([this] {
        chooseFileToOpen();
    });
    m_commands
        ->add(ImportStrokes, "importStrokes", Commands::tr("&Import Strokes…"), "", {},
              Commands::tr("Drawings, recordings and the strokes of other paintings, into this one"))
        .runs([this] { chooseStrokesToImport(); });
    m_commands
        ->add(ImportUnderlay, "importUnderlay", Commands::tr("Import &Underlay…"), "", {},
              Commands::tr("A picture to paint over, which shows on the canvas only"))
        .runs([this] {
            if (const QString path = choosePicture(this, tr("Import underlay")); !path.isEmpty())
                importUnderlay(path);
        });
    m_commands->add(Close, "close", Commands::tr("&Close Window"), "", keys(QKeySequence::Close)).runs([this] {
        close();
    });
    m_commands->add(Quit, "quit", Commands::tr("&Quit"), "", {QKeySequence(Commands::tr("Ctrl+Q"))}).runs([] {
        QApplication::closeAllWindows();
    });
    action(Quit).setMenuRole(QAction::QuitRole);
}

void MainWindow::addWindowRows()
{
    using enum Command;
    m_commands->add(Settings, "settings", Commands::tr("Settin&gs…"), "", {QKeySequence(Commands::tr("Ctrl+,"))})
        .runs([this] { changeSettings(); });
    action(Settings).setMenuRole(QAction::PreferencesRole);
    m_commands->add(HideDocks, "hideDocks", Commands::tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)})
        .checkable()
        .runs([this] { hideDocks(action(HideDocks).isChecked()); });
    m_commands
        ->add(NextPanel, "nextPanel", Commands::tr("Ne&xt Panel"), "", {QKeySequence(Qt::Key_F6)},
              Commands::tr("The keyboard goes from the canvas to the docks and tool bars in turn"))
        .runs([this] { m_keyboard->walk(true); });
    m_commands
        ->add(PreviousPanel, "previousPanel", Commands::tr("&Previous Panel"), "",
              {QKeySequence(Qt::SHIFT | Qt::Key_F6)}, Commands::tr("The keyboard goes back from panel to panel"))
        .runs([this] { m_keyboard->walk(false); });
    m_commands->add(FullScreen, "fullScreen", Commands::tr("Full S&creen"), "", {QKeySequence(Qt::Key_F11)})
        .checkable()
        .runs([this] {
            const bool full = action(FullScreen).isChecked();
            setWindowState(full ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
        });
    m_commands
        ->add(FindCommand, "findCommand", Commands::tr("&Find a Command…"), "", {QKeySequence(Commands::tr("Ctrl+K"))},
              Commands::tr("Commands, brushes, docks and recent files by their names"))
        .runs([this] { CommandPalette::ask(paletteEntries(), *m_canvas); });
    m_commands->add(Shortcuts, "shortcuts", Commands::tr("&Keyboard Shortcuts…"), "", {QKeySequence(Qt::Key_F1)})
        .runs([this] { changeShortcuts(); });
    m_commands->add(About, "about", Commands::tr("&About Suffuse…"), "", {}).runs([this] { AboutDialog(this).exec(); });
    action(About).setMenuRole(QAction::AboutRole);
}

std::vector<PaletteEntry> MainWindow::paletteEntries()
{
    return suffuse::paletteEntries(m_editor, *m_commands, m_docksMenu->actions(),
                                   [this](const QString &path) { openFile(path); });
}

void MainWindow::connectUpdates()
{
    connect(&m_editor, &Editor::fileChanged, this, &MainWindow::updateTitle);
    connect(m_keyboard, &KeyboardFocus::acting, this, [this] { m_editor.laterChanges().flush(); });
    connect(m_commands, &Commands::said, this, [this](const QString &message, int milliseconds) {
        sayUntilChange(*statusBar(), m_editor.document(), message, milliseconds);
    });
    connect(m_strokes, &StrokesPanel::searchingChanged, this, [this] { m_commands->update(Command::SelectFound); });
    connect(m_canvas, &CanvasWidget::busyChanged, this, [this] {
        if (m_nextTool)
            useTool(m_nextTool);
    });
    connect(m_canvas, &CanvasWidget::viewChanged, this, &MainWindow::updateZoom);
    connect(m_canvas, &CanvasWidget::modifiersChanged, this, &MainWindow::showHint);
    connect(m_canvas, &CanvasWidget::framePresented, this, &MainWindow::showFrame);
    connect(m_canvas, &CanvasWidget::backendChanged, this, &MainWindow::showBackend);
    connect(m_canvas, &CanvasWidget::pointerLeft, this, [this] { m_position->clear(); });
    connect(m_canvas, &CanvasWidget::pointerMoved, this, &MainWindow::showPosition);
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

void MainWindow::hideDocks(bool hide)
{
    // The way back is the same in every tool.
    m_canvas->setWindowKeys(hide ? action(Command::HideDocks).shortcuts() : QList<QKeySequence>());
    if (hide) {
        m_layout = saveState();
        for (QDockWidget *dock : std::as_const(m_docks))
            dock->hide();
        return;
    }
    const QList<QDockWidget *> opened = [this] { // meanwhile, by their own entries in the menu
        QList<QDockWidget *> shown = m_docks;
        shown.removeIf([](const QDockWidget *dock) { return dock->isHidden(); });
        return shown;
    }();
    restoreState(m_layout); // with the very sizes that they had
    for (QDockWidget *dock : opened)
        dock->show();
}

} // namespace suffuse
