#include "app/window/main_window.h"

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
#include "app/session/commands/selection_commands.h"
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
#include "app/widgets/house_rules.h"
#include "app/widgets/icons.h"
#include "app/widgets/keyboard_focus.h"
#include "app/widgets/place_beside.h"
#include "app/widgets/section.h"
#include "app/window/palette_entries.h"
#include "app/window/window_layout.h"

#include <QActionGroup>
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
    m_actions = new Actions(*this);
    m_actions->fillMenus();
    applyStoredShortcuts(m_actions->all());
    QToolBar *tools = m_actions->makeToolBar();
    addToolBar(Qt::LeftToolBarArea, tools);
    m_toolOptions = new ToolOptionsBar(tr("Tool Options"), this);
    addToolBar(Qt::TopToolBarArea, m_toolOptions);
    makeDocks();
    m_actions->docksMenu()->addSeparator();
    m_actions->docksMenu()->addAction(tools->toggleViewAction());
    m_actions->docksMenu()->addAction(m_toolOptions->toggleViewAction());
    makeStatusBar();
    makeTools();
    m_actions->serve({m_editor, *m_playback, *m_selectionOrder, *m_canvas, *m_actions});
    connectActions();
    connectViewActions();
    connectClipboard();
    connectObjectActions();
    connectTimeActions();
    connectBrushes();
    connectSaving();
    connectUpdates();
    updateTitle();
    updateActions();
    updateZoom();
    window_layout::restore(*this);
    action(Command::FullScreen).setChecked(isFullScreen());
    m_canvas->setFocus();
}

QAction &MainWindow::action(Command command)
{
    m_editor.laterChanges().flush(); // it may be asked whether it is enabled
    return (*m_actions)[command];
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
    m_actions->docksMenu()->addAction(dock->toggleViewAction());
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
    m_strokes->addAction(&action(Command::Delete));
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
    QDockWidget *timeline =
        addDock("timelineDock", tr("Timeline"), new TimelinePanel(m_editor, *m_playback, *m_actions));
    addDockWidget(Qt::BottomDockWidgetArea, timeline);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    resizeDocks({timeline}, {150}, Qt::Vertical);
    resizeDocks({colour, inspector, strokes}, {300, 300, 300}, Qt::Horizontal);
    if (isHigh)
        resizeDocks({colour, inspector, strokes}, {360, 285, 255}, Qt::Vertical);
    else
        resizeDocks({colour, inspector}, {300, 360}, Qt::Vertical);
}

void MainWindow::makeTools()
{
    const std::pair<Command, Tool *> tools[] = {{Command::Brush, new BrushTool(*m_canvas, m_canvas)},
                                                {Command::Select, new SelectTool(*m_canvas, *m_actions, m_canvas)},
                                                {Command::Segments, new NodeTool(*m_canvas, *m_actions, m_canvas)},
                                                {Command::Knife, new KnifeTool(*m_canvas, m_canvas)},
                                                {Command::Eraser, new EraserTool(*m_canvas, m_canvas)},
                                                {Command::AttributeBrush, new AttributeBrushTool(*m_canvas, m_canvas)},
                                                {Command::Eyedropper, new EyedropperTool(*m_canvas, m_canvas)},
                                                {Command::Pan, new PanTool(*m_canvas, m_canvas)}};
    for (const auto &[command, tool] : tools) {
        connect(&action(command), &QAction::toggled, this, [this, tool = tool](bool on) {
            if (on)
                useTool(tool);
        });
        connect(tool, &Tool::hintChanged, this, &MainWindow::showHint);
        m_toolOptions->setWidget(tool->options()); // the row is as high as the highest from the start
    }
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
    action(Command::Brush).setChecked(true);
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

void MainWindow::connectActions()
{
    const auto on = [this](Command command, auto function) {
        connect(&action(command), &QAction::triggered, this, function);
    };
    on(Command::New, [this] { newWindow(); });
    on(Command::Open, [this] { chooseFileToOpen(); });
    on(Command::ImportStrokes, [this] { chooseStrokesToImport(); });
    on(Command::Save, [this] { startSaving(); });
    on(Command::SaveAs, [this] { startSavingAs(); });
    connectExport();
    on(Command::Close, [this] { close(); });
    on(Command::Quit, [] { QApplication::closeAllWindows(); });
    on(Command::SelectAll, [this] {
        if (m_strokes->isSearching() && m_strokes->isAncestorOf(QApplication::focusWidget()))
            m_strokes->selectFound(); // all of what is to be seen there
        else if (!m_canvas->tool()->selectAll())
            commands::selectAll(m_editor);
    });
    m_canvas->setPenSettings(settings::penSettings());
    on(Command::Settings, [this] { changeSettings(); });
    on(Command::FindCommand, [this] { CommandPalette::ask(paletteEntries(*this, *m_actions), *m_canvas); });
    on(Command::Shortcuts, [this] { changeShortcuts(); });
    on(Command::About, [this] { AboutDialog(this).exec(); });
    connect(m_actions->recentMenu(), &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
}

void MainWindow::connectViewActions()
{
    const auto on = [this](Command command, auto function) {
        connect(&action(command), &QAction::triggered, this, function);
    };
    const auto hold = [this] {
        const auto keys = [this](Command command) { return (*m_actions)[command].shortcuts(); };
        m_canvas->setHeldKeys({keys(Command::HoldToPan), keys(Command::HoldToTurn), keys(Command::HoldToHideOutlines)});
    };
    hold();
    for (const Command command : {Command::HoldToPan, Command::HoldToTurn, Command::HoldToHideOutlines})
        connect(&action(command), &QAction::changed, this, hold);
    on(Command::HideDocks, [this](bool hide) { hideDocks(hide); });
    on(Command::NextPanel, [this] { m_keyboard->walk(true); });
    on(Command::PreviousPanel, [this] { m_keyboard->walk(false); });
    on(Command::FullScreen, [this](bool full) {
        setWindowState(full ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    });
}

void MainWindow::connectUpdates()
{
    connect(&m_editor, &Editor::fileChanged, this, &MainWindow::updateTitle);
    connect(&m_editor.laterChanges(), &LaterChanges::changed, this, &MainWindow::updateActions);
    const auto update = [this] {
        if (!m_editor.laterChanges().isWaiting()) // else it comes with what waits
            updateActions();
    };
    connect(&m_editor.undoStack(), &QUndoStack::indexChanged, this, update);
    connect(&m_editor, &Editor::dragEnded, this, update);
    connect(m_keyboard, &KeyboardFocus::acting, this, [this] { m_editor.laterChanges().flush(); });
    connect(m_canvas, &CanvasWidget::busyChanged, this, update);
    connect(m_strokes, &StrokesPanel::searchingChanged, this, update);
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

void MainWindow::updateActions()
{
    action(Command::SelectFound).setEnabled(m_strokes->isSearching());
    m_actions->update();
}

void MainWindow::updateTitle()
{
    setWindowTitle(QStringLiteral("%1[*] — Suffuse").arg(m_editor.displayName()));
    setWindowFilePath(m_editor.filePath());
    setWindowModified(m_editor.isModified());
}

void MainWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::WindowStateChange && m_actions) // the window manager has keys for it, too
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
