#include "app/window/docks.h"

#include "app/canvas/canvas_widget.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/history/history_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/probe/probe_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/open_painting.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/section.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>

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

} // namespace

Docks::Docks(const Workplace &place, KeyboardFocus &keyboard, QObject *parent) : QObject(parent), m_place(place)
{
    makeDocks();
    addRows(keyboard);
    addSelectingRows();
}

Docks::~Docks()
{
    qDeleteAll(m_docks); // they show the painting, which may go before their window
}

QDockWidget *Docks::add(const char *name, const QString &title, QWidget *panel, CommandScope scope)
{
    if (scope != CommandScope::Window)
        panel->addActions(m_place.commands.of(scope));
    auto *dock = new QDockWidget(title, &m_place.window);
    dock->setObjectName(QString::fromLatin1(name));
    dock->setWidget(panel->minimumSizeHint().height() > lowPanel ? new LowScroll(panel) : panel);
    m_place.window.addDockWidget(Qt::RightDockWidgetArea, dock);
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
        if (shown) // and not as a tab behind another
            dock->raise();
    });
    m_docks << dock;
    return dock;
}

QDockWidget *Docks::makeProbe()
{
    auto *probe = new ProbePanel(m_place.open.editor);
    const CanvasWidget *canvas = &m_place.canvas;
    connect(canvas, &CanvasWidget::pointerMoved, probe, [probe](double x, double y) { probe->setPoint({x, y}); });
    connect(canvas, &CanvasWidget::pointerLeft, probe, &ProbePanel::leaveCanvas);
    QDockWidget *dock = add("probeDock", tr("Probe"), probe);
    dock->hide();
    return dock;
}

QDockWidget *Docks::makeTimeline()
{
    auto *panel = new TimelinePanel(m_place.open.editor, m_place.open.playback, m_place.commands);
    QDockWidget *dock = add("timelineDock", tr("Timeline"), panel, CommandScope::Timeline);
    m_place.window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    return dock;
}

void Docks::makeDocks()
{
    Editor &editor = m_place.open.editor;
    QMainWindow &window = m_place.window;
    auto *brushPanel = new BrushPanel(editor);
    auto *inspectorPanel = new InspectorPanel(editor);
    m_strokes = new StrokesPanel(editor);
    connect(brushPanel, &BrushPanel::chosen, this, [this] { m_place.commands[Command::Brush].setChecked(true); });
    connect(inspectorPanel, &InspectorPanel::alongOpening, this,
            [this](QWidget *dialog) { moveBeside(*dialog, m_place.canvas.selectionOnScreen()); });
    QDockWidget *colour = add("colourDock", tr("Colour"), new ColourPanel(editor));
    QDockWidget *brushes = add("brushesDock", tr("Brushes"), brushPanel);
    QDockWidget *inspector = add("inspectorDock", tr("Inspector"), inspectorPanel);
    QDockWidget *strokes = add("strokesDock", tr("Strokes"), m_strokes, CommandScope::Strokes);
    QDockWidget *history = add("historyDock", tr("History"), new HistoryPanel(editor));
    window.tabifyDockWidget(colour, brushes);
    const bool isHigh = window.screen()->availableSize().height() >= highScreen;
    if (!isHigh)
        window.tabifyDockWidget(inspector, strokes);
    window.tabifyDockWidget(strokes, history);
    window.tabifyDockWidget(history, makeProbe());
    colour->raise();
    (isHigh ? strokes : inspector)->raise();
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    QDockWidget *timeline = makeTimeline();
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    window.resizeDocks({timeline}, {150}, Qt::Vertical);
    window.resizeDocks({colour, inspector, strokes}, {300, 300, 300}, Qt::Horizontal);
    if (isHigh)
        window.resizeDocks({colour, inspector, strokes}, {360, 285, 255}, Qt::Vertical);
    else
        window.resizeDocks({colour, inspector}, {300, 360}, Qt::Vertical);
}

void Docks::addRows(KeyboardFocus &keyboard)
{
    using enum Command;
    Commands &table = m_place.commands;
    table.add(HideDocks, "hideDocks", Commands::tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)})
        .checkable()
        .runs([this] { hide(m_place.commands[HideDocks].isChecked()); });
    table
        .add(NextPanel, "nextPanel", Commands::tr("Ne&xt Panel"), "", {QKeySequence(Qt::Key_F6)},
             Commands::tr("The keyboard goes from the canvas to the docks and tool bars in turn"))
        .runs([&keyboard] { keyboard.walk(true); });
    table
        .add(PreviousPanel, "previousPanel", Commands::tr("&Previous Panel"), "",
             {QKeySequence(Qt::SHIFT | Qt::Key_F6)}, Commands::tr("The keyboard goes back from panel to panel"))
        .runs([&keyboard] { keyboard.walk(false); });
}

/// What is to be selected may be what the search in the Strokes dock shows.
void Docks::addSelectingRows()
{
    using enum Command;
    Commands &table = m_place.commands;
    table
        .add(SelectAll, "selectAll", Commands::tr("Select &All"), "",
             QKeySequence::keyBindings(QKeySequence::SelectAll))
        .runs([this] {
            if (m_strokes->isSearching() && m_strokes->isAncestorOf(QApplication::focusWidget()))
                m_strokes->selectFound(); // all of what is to be seen there
            else if (!m_place.canvas.tool()->selectAll())
                commands::selectAll(m_place.open.editor);
        });
    table
        .add(SelectFound, "selectFound", Commands::tr("Select &Found"), "", {},
             Commands::tr("Select what the search in the Strokes dock has found"))
        .when([this] { return m_strokes->isSearching(); })
        .runs([this] { m_strokes->selectFound(); });
    connect(m_strokes, &StrokesPanel::searchingChanged, this, [this] { m_place.commands.update(SelectFound); });
}

void Docks::hide(bool hide)
{
    // The way back is the same in every tool.
    m_place.canvas.setWindowKeys(hide ? m_place.commands[Command::HideDocks].shortcuts() : QList<QKeySequence>());
    if (hide) {
        m_layout = m_place.window.saveState();
        for (QDockWidget *dock : std::as_const(m_docks))
            dock->hide();
        return;
    }
    const QList<QDockWidget *> opened = [this] { // meanwhile, by their own entries in the menu
        QList<QDockWidget *> shown = m_docks;
        shown.removeIf([](const QDockWidget *dock) { return dock->isHidden(); });
        return shown;
    }();
    m_place.window.restoreState(m_layout); // with the very sizes that they had
    for (QDockWidget *dock : opened)
        dock->show();
}

} // namespace suffuse
