#include "app/window/layout/docks.h"

#include "app/canvas/canvas_widget.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/history/history_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/probe/probe_panel.h"
#include "app/panels/reference/reference_panel.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/panels/timeline/timeline_panel.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/open_painting.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/section.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>

#include <algorithm>

namespace suffuse {

namespace {

/// Logical pixels that every screen has for a panel.
constexpr int lowPanel = 110;
/// Heights of a screen from which on the inspector has a place of its own below the brushes, and the list of strokes
/// one below the inspector.
constexpr int mediumScreen = 1000, highScreen = 1300;
/// Logical pixels of the timeline, with its title and its row of buttons: three lanes on a low screen, seven else.
constexpr int lowTimeline = 156, highTimeline = 230;
/// Logical pixels of the column of docks.
constexpr int columnWidth = 312;

/// It is not behind another one.
bool isInFront(const QDockWidget &dock)
{
    return !dock.isHidden() && !dock.visibleRegion().isEmpty();
}

/// Gives a panel as much room as it wants, and lets it scroll where the window is low.
class LowScroll : public PanelScroll {
public:
    explicit LowScroll(QWidget *panel) { setWidget(panel); }
    QSize sizeHint() const override { return widget()->sizeHint(); }
    QSize minimumSizeHint() const override { return {PanelScroll::minimumSizeHint().width(), lowPanel}; }
};

} // namespace

Docks::Docks(const Workplace &place, KeyboardFocus &keyboard, QObject *parent)
    : QObject(parent), m_place(place), m_keyboard(keyboard)
{
    makeDocks();
    addRows(keyboard);
    addSelectingRows();
}

Docks::~Docks()
{
    qDeleteAll(m_docks); // they show the painting, which may go before their window
}

QDockWidget *Docks::add(const char *name, const char *page, const QString &title, QWidget *panel, CommandScope scope)
{
    if (scope != CommandScope::Window)
        panel->addActions(m_place.commands.of(scope));
    auto *dock = new QDockWidget(title, &m_place.window);
    dock->setObjectName(QString::fromLatin1(name));
    setHelpPage(*dock, page);
    dock->setWidget(panel->minimumSizeHint().height() > lowPanel ? new LowScroll(panel) : panel);
    m_place.window.addDockWidget(Qt::RightDockWidgetArea, dock);
    // Qt would close a dock that is open behind another one, where people want to see it.
    QAction *toggle = dock->toggleViewAction();
    disconnect(toggle, &QAction::triggered, dock, nullptr);
    connect(toggle, &QAction::triggered, dock, [dock, toggle] {
        if (isInFront(*dock))
            return void(dock->close());
        dock->show();
        dock->raise();
        toggle->setChecked(true);
    });
    m_docks << dock;
    return dock;
}

void Docks::toggle(QAction &entry)
{
    const auto at =
        std::ranges::find(m_docks, &entry, [](const QDockWidget *dock) { return dock->toggleViewAction(); });
    // Who asks for a dock that is seen wants the keyboard there; who has it there wants the dock away.
    if (at == m_docks.end() || (isInFront(**at) && (*at)->isAncestorOf(m_place.window.focusWidget())))
        return entry.trigger();
    (*at)->show();
    m_keyboard.toDock(**at);
}

QDockWidget *Docks::makeProbe()
{
    auto *probe = new ProbePanel(m_place.open.editor);
    const CanvasWidget *canvas = &m_place.canvas;
    connect(canvas, &CanvasWidget::pointerMoved, probe, [probe](double x, double y) { probe->setPoint({x, y}); });
    connect(canvas, &CanvasWidget::pointerLeft, probe, &ProbePanel::leaveCanvas);
    QDockWidget *dock = add("probeDock", "numbers", tr("Probe"), probe);
    dock->hide();
    return dock;
}

QDockWidget *Docks::makeReference()
{
    const auto picks = [this] { return m_place.commands[Command::Eyedropper].isChecked(); };
    QDockWidget *dock = add("referenceDock", "colour", tr("Reference"), new ReferencePanel(m_place.open.editor, picks));
    dock->hide();
    return dock;
}

QDockWidget *Docks::makeTimeline()
{
    auto *panel = new TimelinePanel(m_place.open.editor, m_place.open.playback, m_place.commands);
    QDockWidget *dock = add("timelineDock", "time", tr("Timeline"), panel, CommandScope::Timeline);
    panel->addAction(&m_place.commands[Command::Delete]); // Its bars are strokes, and are selected as such.
    m_place.window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    return dock;
}

void Docks::makeDocks()
{
    Editor &editor = m_place.open.editor;
    QMainWindow &window = m_place.window;
    auto *brushPanel = new BrushPanel(editor);
    auto *inspectorPanel = new InspectorPanel(editor);
    const Commands &commands = m_place.commands;
    const auto menuOf = [&](const QString &title, std::initializer_list<Command> rows) {
        auto *menu = new QMenu(title, &window);
        for (const Command command : rows)
            menu->addAction(&commands[command]);
        return menu->menuAction();
    };
    using enum Command;
    m_strokes = new StrokesPanel(
        editor, {&commands[Duplicate], &commands[GroupStrokes], &commands[UngroupStrokes],
                 menuOf(tr("&Arrange"), {Top, Raise, Lower, Bottom}),
                 menuOf(Commands::tr("La&yer"), {NewLayer, NewClippedLayer, DuplicateLayer, MergeLayerDown, RaiseLayer,
                                                 LowerLayer, HideOtherLayers}),
                 menuOf(Commands::tr("Group as a Whole"), {ClipGroups, MaskGroups, WashGroups})});
    m_strokes->addSwitch(commands[ThisLayerOnly]);
    connect(brushPanel, &BrushPanel::chosen, this, [this] { takeToPaint(m_place.commands, m_place.open.editor); });
    connect(inspectorPanel, &InspectorPanel::alongOpening, this,
            [this](QWidget *dialog) { moveBeside(*dialog, m_place.canvas.selectionOnScreen()); });
    addAlongRow(*inspectorPanel);
    add("colourDock", "colour", tr("Colour"), new ColourPanel(editor));
    m_brushes = add("brushesDock", "brushes", tr("Brushes"), brushPanel);
    m_inspector = add("inspectorDock", "numbers", tr("Inspector"), inspectorPanel);
    m_strokesDock = add("strokesDock", "layers", tr("Strokes"), m_strokes, CommandScope::Strokes);
    add("historyDock", "refining", tr("History"), new HistoryPanel(editor));
    window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
    m_probe = makeProbe();
    m_timeline = makeTimeline();
    m_reference = makeReference();
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    stack();
    shareRoom();
    connect(&m_place.canvas, &CanvasWidget::toolChanged, this, [this] {
        if (!m_place.commands[Command::Brush].isChecked()) // a brush that is chosen by its key brings the tool, too
            followTool();
    });
    connect(&commands[Command::Brush], &QAction::triggered, this, &Docks::followTool);
}

/// Colour and brushes stand together on any screen, and the canvas gets what room there is. What has no place of its
/// own on the screen stands behind something else: `rest` always.
void Docks::stack()
{
    QMainWindow &window = m_place.window;
    const QList<QDockWidget *> rest = m_docks.mid(4, 2);
    QDockWidget *colour = m_docks[0], *brushes = m_docks[1], *inspector = m_docks[2], *strokes = m_docks[3];
    const int height = window.screen()->availableSize().height();
    const bool low = height < mediumScreen, high = height >= highScreen;
    if (low)
        window.tabifyDockWidget(brushes, inspector);
    if (!high)
        window.tabifyDockWidget(inspector, strokes);
    window.tabifyDockWidget(low ? colour : strokes, rest[0]);
    window.tabifyDockWidget(rest[0], rest[1]);
    window.tabifyDockWidget(rest[1], m_reference);
}

/// Gives stacked docks their sizes, and brings to the front what is to be seen.
void Docks::shareRoom()
{
    QMainWindow &window = m_place.window;
    const QList<QDockWidget *> column = m_docks.mid(0, 4);
    QDockWidget *colour = column[0], *brushes = column[1], *inspector = column[2], *strokes = column[3];
    const int height = window.screen()->availableSize().height();
    const bool low = height < mediumScreen, high = height >= highScreen;
    window.resizeDocks({m_timeline}, {low ? lowTimeline : highTimeline}, Qt::Vertical);
    window.resizeDocks(column, {columnWidth, columnWidth, columnWidth, columnWidth}, Qt::Horizontal);
    if (low)
        window.resizeDocks({colour, brushes}, {332, 308}, Qt::Vertical);
    else if (!high)
        window.resizeDocks({colour, brushes, inspector}, {300, 270, 350}, Qt::Vertical);
    else
        window.resizeDocks(column, {420, 300, 380, 260}, Qt::Vertical);
    colour->raise();
    (low ? brushes : high ? strokes : inspector)->raise();
}

void Docks::arrangeAnew(DockSet set)
{
    if (QAction &hides = m_place.commands[Command::HideDocks]; hides.isChecked())
        hides.trigger();
    // Seen one below the other all docks need more than many a screen has, and the window would grow.
    for (QDockWidget *dock : std::as_const(m_docks))
        dock->hide();
    for (QDockWidget *dock : std::as_const(m_docks)) {
        dock->setFloating(false);
        m_place.window.addDockWidget(dock == m_timeline ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea, dock);
    }
    stack();
    for (QDockWidget *dock : std::as_const(m_docks))
        dock->setVisible(dock != m_probe && dock != m_reference);
    shareRoom();
    if (set != DockSet::Usual)
        showOnly(set);
}

/// Hides what is not of a set, and brings to the front what its work needs most.
void Docks::showOnly(DockSet set)
{
    constexpr double timelineShare = 0.4; ///< of the window's height, in the workspace that is about time
    const bool paints = set == DockSet::Paint, refines = set == DockSet::Refine;
    QList<QDockWidget *> shown{paints ? m_brushes : m_inspector, m_strokesDock};
    if (set != DockSet::Time)
        shown << m_docks[0];
    if (refines)
        shown << m_docks[4];
    if (set == DockSet::Time)
        shown << m_timeline;
    for (QDockWidget *dock : std::as_const(m_docks))
        dock->setVisible(shown.contains(dock));
    if (m_timeline->isVisible())
        m_place.window.resizeDocks({m_timeline}, {int(timelineShare * m_place.window.height())}, Qt::Vertical);
    if (shown.contains(m_docks[0]))
        m_docks[0]->raise();
    shown[0]->raise();
}

/// Where brushes and inspector share a place, the one stands in front that the tool in use needs. Who has brought
/// something else to the front there keeps it, and so does who takes a brush by a key or at the pointer.
void Docks::followTool()
{
    const Commands &table = m_place.commands;
    const bool paints = table[Command::Brush].isChecked();
    const bool selects = table[Command::Select].isChecked() || table[Command::Segments].isChecked();
    QDockWidget *to = paints ? m_brushes : m_inspector, *from = paints ? m_inspector : m_brushes;
    if ((paints || selects) && isInFront(*from) && m_place.window.tabifiedDockWidgets(from).contains(to))
        to->raise();
}

void Docks::addRows(KeyboardFocus &keyboard)
{
    using enum Command;
    Commands &table = m_place.commands;
    table.add(HideDocks, "hideDocks", Commands::tr("&Hide the Docks"), "", {QKeySequence(Qt::Key_Tab)})
        .checkable()
        .runs([this] {
            // What is held would jump as the canvas moves below the pointer, and afterwards nobody expects it any more.
            if (m_place.canvas.isPressed() || m_place.open.editor.isDragging())
                m_place.commands[HideDocks].setChecked(m_hidden);
            else
                hide(m_place.commands[HideDocks].isChecked());
        });
    table
        .add(NextPanel, "nextPanel", Commands::tr("Ne&xt Panel"), "", {QKeySequence(Qt::Key_F6)},
             Commands::tr("The keyboard goes from the canvas to the docks and tool bars in turn"))
        .runs([&keyboard] { keyboard.walk(true); });
    table
        .add(PreviousPanel, "previousPanel", Commands::tr("&Previous Panel"), "",
             {QKeySequence(Qt::SHIFT | Qt::Key_F6)}, Commands::tr("The keyboard goes back from panel to panel"))
        .runs([&keyboard] { keyboard.walk(false); });
}

/// The dialog stays open while one works on, so the panel that shows the same values keeps it.
void Docks::addAlongRow(InspectorPanel &inspector)
{
    m_place.commands
        .add(Command::AlongStrokes, "along", Commands::tr("Along th&e Stroke…"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+R"))},
             Commands::tr("Set a value along the stroke: constant, as a ramp, or drawn as a curve"))
        .when(anySelected(m_place.open.editor))
        .runs([&inspector] { inspector.openAlong(); });
}

/// What is to be selected may be what the search in the Strokes dock shows.
void Docks::addSelectingRows()
{
    using enum Command;
    Commands &table = m_place.commands;
    table
        .add(SelectAll, "selectAll", Commands::tr("Select &All"), "",
             QKeySequence::keyBindings(QKeySequence::SelectAll))
        .when(anyStrokes(m_place.open.editor))
        .runs([this] {
            if (m_strokes->isSearching() && m_strokes->isAncestorOf(QApplication::focusWidget()))
                m_strokes->selectFound(); // all of what is to be seen there
            else if (!m_place.canvas.tool()->selectAll())
                commands::selectAll(m_place.open.editor);
        });
    table
        .add(SelectFound, "selectFound", Commands::tr("Select &Found"), "", {},
             Commands::tr("Select what the search in the Strokes dock has found"))
        .when([this] { return m_strokes->isSearching(); }, Commands::tr("Search in the Strokes dock first."))
        .runs([this] { m_strokes->selectFound(); });
    table
        .add(SearchStrokes, "searchStrokes", Commands::tr("Find Strokes"), "",
             QKeySequence::keyBindings(QKeySequence::Find),
             Commands::tr("Look for strokes and groups by their names, in the Strokes dock"))
        .runs([this] {
            m_strokesDock->show();
            m_keyboard.toDock(*m_strokesDock);
            m_strokes->search()->setFocus(Qt::ShortcutFocusReason);
        });
    connect(m_strokes, &StrokesPanel::said, this,
            [this](const QString &message) { emit m_place.commands.said(message, 8'000); });
    connect(m_strokes, &StrokesPanel::searchingChanged, this, [this] { m_place.commands.update(SelectFound); });
}

void Docks::hide(bool hide)
{
    if (hide == m_hidden)
        return;
    m_hidden = hide;
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
