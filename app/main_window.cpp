#include "app/main_window.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/about_dialog.h"
#include "app/dialogs/export_dialog.h"
#include "app/dialogs/new_dialog.h"
#include "app/dialogs/settings_dialog.h"
#include "app/dialogs/shortcuts_dialog.h"
#include "app/icons.h"
#include "app/journal.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/history/history_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/probe/probe_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/place_beside.h"
#include "app/playback.h"
#include "app/settings.h"
#include "app/tools/attribute_brush_tool.h"
#include "app/tools/brush_tool.h"
#include "app/tools/commands.h"
#include "app/tools/eraser_tool.h"
#include "app/tools/eyedropper_tool.h"
#include "app/tools/knife_tool.h"
#include "app/tools/node_tool.h"
#include "app/tools/pan_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/tool_options.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QToolBar>

namespace suffuse {

namespace {

/// Logical pixels that every screen has for a panel.
constexpr int lowPanel = 110;
/// Of a screen, from which on the inspector and the strokes have room below each other.
constexpr int highScreen = 950;

/// Gives a panel as much room as it wants, and lets it scroll where the window is low.
class LowScroll : public QScrollArea {
public:
    explicit LowScroll(QWidget *panel)
    {
        setWidget(panel);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setFocusPolicy(Qt::NoFocus);
    }
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override { return {widget()->minimumSizeHint().width(), lowPanel}; }
};

} // namespace

MainWindow::MainWindow(QWidget *parent, MakeRenderer make) : QMainWindow(parent)
{
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    resize(1280, 800);
    m_editor.newPainting(Editor::usualCanvas());
    m_editor.setBrush(settings::brush());
    m_playback = new Playback(m_editor, this);
    m_canvas = new CanvasWidget(m_editor, this, std::move(make));
    setCentralWidget(m_canvas);
    m_actions = new Actions(*this, *m_canvas);
    m_actions->fillMenus();
    applyStoredShortcuts(m_actions->all());
    QToolBar *tools = m_actions->makeToolBar();
    addToolBar(Qt::LeftToolBarArea, tools);
    m_toolOptions = new ToolOptionsBar(tr("Tool Options"), this);
    addToolBar(Qt::TopToolBarArea, m_toolOptions);
    connect(m_toolOptions, &ToolOptionsBar::returnPressed, m_canvas, [this] { m_canvas->setFocus(); });
    makeDocks();
    m_actions->docksMenu()->addSeparator();
    m_actions->docksMenu()->addAction(tools->toggleViewAction());
    m_actions->docksMenu()->addAction(m_toolOptions->toggleViewAction());
    makeStatusBar();
    makeTools();
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
    settings::restoreLayout(*this);
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
    // A stack that goes reports that it is empty; there is no canvas to tell any more.
    disconnect(&m_editor, nullptr, this, nullptr);
    disconnect(&m_editor.document(), nullptr, this, nullptr);
    disconnect(&m_editor.laterChanges(), nullptr, this, nullptr);
    disconnect(&m_editor.undoStack(), nullptr, this, nullptr);
    delete m_journal; // what it follows goes as a member does, before the children
    // The canvas draws the document, which as a member goes before the child widgets do.
    delete m_canvas;
    for (QDockWidget *dock : std::as_const(m_docks))
        delete dock;
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
    // What was entered is done: keys mean the canvas again, Ctrl+Z among them.
    for (QLineEdit *field : panel->findChildren<QLineEdit *>())
        connect(
            field, &QLineEdit::returnPressed, m_canvas, [this] { m_canvas->setFocus(); }, Qt::QueuedConnection);
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
    QDockWidget *strokes = addDock("strokesDock", tr("Strokes"), new StrokesPanel(m_editor));
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
        resizeDocks({colour, inspector, strokes}, {330, 300, 270}, Qt::Vertical);
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
    // A stroke in hand belongs to no step yet: undo gives it up instead, as in Krita.
    const auto givesUp = [this] {
        const bool busy = m_canvas->tool() && m_canvas->tool()->isBusy();
        if (busy) {
            m_canvas->tool()->cancel();
            updateActions();
        }
        return busy;
    };
    on(Command::New, [this] { newWindow(); });
    on(Command::Open, [this] { chooseFileToOpen(); });
    on(Command::ImportStrokes, [this] { chooseStrokesToImport(); });
    on(Command::Save, [this] { startSaving(); });
    on(Command::SaveAs, [this] { startSavingAs(); });
    on(Command::Export, [this] { ExportDialog(m_editor, shownArea(m_canvas->view()), this).exec(); });
    on(Command::Close, [this] { close(); });
    on(Command::Quit, [] { QApplication::closeAllWindows(); });
    on(Command::Undo, [this, givesUp] {
        if (!givesUp())
            m_editor.undoStack().undo();
    });
    on(Command::Redo, [this, givesUp] {
        if (!givesUp())
            m_editor.undoStack().redo();
    });
    on(Command::Delete, [this, givesUp] {
        if (!givesUp() && !m_canvas->tool()->deleteSelected())
            commands::deleteSelected(m_editor);
    });
    on(Command::Duplicate, [this] { commands::duplicateSelected(m_editor); });
    on(Command::SelectAll, [this] {
        if (!m_canvas->tool()->selectAll())
            commands::selectAll(m_editor);
    });
    on(Command::Deselect, [this] { m_editor.document().setSelection({}); });
    on(Command::Raise, [this] { commands::arrangeSelected(m_editor, Arrange::Raise); });
    on(Command::Lower, [this] { commands::arrangeSelected(m_editor, Arrange::Lower); });
    on(Command::Top, [this] { commands::arrangeSelected(m_editor, Arrange::Top); });
    on(Command::Bottom, [this] { commands::arrangeSelected(m_editor, Arrange::Bottom); });
    m_canvas->setPenSettings(settings::penSettings());
    on(Command::Settings, [this] {
        if (SettingsDialog(this, m_editor.brush()).exec() == QDialog::Accepted)
            m_canvas->setPenSettings(settings::penSettings());
    });
    on(Command::Shortcuts, [this] { changeShortcuts(); });
    on(Command::About, [this] { AboutDialog(this).exec(); });
    connect(m_actions->recentMenu(), &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
}

void MainWindow::connectViewActions()
{
    const auto on = [this](Command command, auto function) {
        connect(&action(command), &QAction::triggered, this, function);
    };
    constexpr double step = 1.4142135623730951;
    constexpr double turn = 15; // degrees
    on(Command::ZoomIn, [this] { m_canvas->zoomBy(step); });
    on(Command::ZoomOut, [this] { m_canvas->zoomBy(1 / step); });
    on(Command::Zoom100, [this] { m_canvas->setZoom(1); });
    on(Command::Fit, [this] { m_canvas->fit(); });
    on(Command::RotateLeft, [this] { m_canvas->rotateBy(-turn); });
    on(Command::RotateRight, [this] { m_canvas->rotateBy(turn); });
    on(Command::ResetRotation, [this] { m_canvas->resetRotation(); });
    on(Command::Mirror, [this] { m_canvas->mirror(); });
    on(Command::SmallerSize, [this] { m_canvas->tool()->stepSize(-1); });
    on(Command::LargerSize, [this] { m_canvas->tool()->stepSize(1); });
    on(Command::LessOpacity, [this] { m_canvas->tool()->stepOpacity(-1); });
    on(Command::MoreOpacity, [this] { m_canvas->tool()->stepOpacity(1); });
    const auto hold = [this] {
        m_canvas->setHeldKeys(
            {(*m_actions)[Command::HoldToPan].shortcuts(), (*m_actions)[Command::HoldToTurn].shortcuts()});
    };
    hold();
    for (const Command command : {Command::HoldToPan, Command::HoldToTurn})
        connect(&action(command), &QAction::changed, this, hold);
    on(Command::HideDocks, [this](bool hide) { hideDocks(hide); });
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
    connect(m_canvas, &CanvasWidget::busyChanged, this, update);
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
    const bool any = !m_editor.document().selection().isEmpty();
    for (const Command command : {Command::Cut, Command::Copy, Command::Delete, Command::Duplicate, Command::Deselect,
                                  Command::Raise, Command::Lower, Command::Top, Command::Bottom})
        action(command).setEnabled(any);
    updateObjectActions();
    updateTimeActions();
    const QUndoStack &stack = m_editor.undoStack();
    const auto name = [&](Command command, const QString &plain, const QString &named, const QString &step, bool can) {
        action(command).setEnabled(can);
        action(command).setText(can && !step.isEmpty() ? named.arg(step) : plain);
    };
    const bool strokeInHand = m_editor.document().draft() != nullptr; // undo gives it up
    const bool busy = m_canvas->tool() && m_canvas->tool()->isBusy(); // and any other drag
    name(Command::Undo, tr("&Undo"), tr("&Undo: %1"), strokeInHand ? QString() : stack.undoText(),
         strokeInHand || busy || stack.canUndo());
    name(Command::Redo, tr("&Redo"), tr("&Redo: %1"), stack.redoText(), stack.canRedo());
}

void MainWindow::updateTitle()
{
    setWindowTitle(QStringLiteral("%1[*] — Suffuse").arg(m_editor.displayName()));
    setWindowFilePath(m_editor.filePath());
    setWindowModified(m_editor.isModified());
}

void MainWindow::changeShortcuts()
{
    if (ShortcutsDialog(m_actions->all(), fixedKeys(), this).exec() != QDialog::Accepted)
        return;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<MainWindow *>(widget))
            applyStoredShortcuts(window->m_actions->all());
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
        m_hiddenDocks.clear();
        for (QDockWidget *dock : std::as_const(m_docks)) {
            if (dock->toggleViewAction()->isChecked())
                m_hiddenDocks << dock;
            dock->hide();
        }
    } else {
        for (QDockWidget *dock : std::as_const(m_hiddenDocks))
            dock->show();
        m_hiddenDocks.clear();
    }
}

} // namespace suffuse
