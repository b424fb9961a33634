#include "app/tools/nodes/node_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "app/session/selecting/seen_selection.h"
#include "app/tools/nodes/erasures.h"
#include "app/tools/nodes/node_sets.h"
#include "app/tools/tool_fields.h"
#include "model/painting/editable.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "undo/node_edits.h"

#include <QHBoxLayout>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace suffuse {

NodeTool::NodeTool(CanvasWidget &canvas, Commands &commands, QObject *parent)
    : SelectionTool(canvas, parent), m_commands(canvas, m_editor, commands, *this, m_nodes), m_inReach(canvas, m_nodes),
      m_drag(canvas, m_reach), m_width(canvas), m_gradient(canvas)
{
    connect(&m_editor.layer(), &CurrentLayer::changed, this, [this] { // what is reached may be other strokes
        m_inReach.reset();
        m_canvas.updateSelection();
    });
    connect(&m_editor.document(), &Document::changed, this, &NodeTool::followDocument);
    connect(&canvas, &CanvasWidget::begunChanged, this, [this] {
        Change change;
        change.selection = true;
        followDocument(change);
    });
    connect(&canvas, &CanvasWidget::toolChanged, this, [this] {
        if (!isInUse()) {
            m_nodes.clear();
            m_deleted.reset(); // Other tools mean the strokes that are selected.
        }
        // The eyedropper takes a colour for the knob, and comes back.
        const bool staysWithIt =
            isInUse() || (m_canvas.tool() && m_canvas.tool()->colourUse() == ColourTarget::ToolUse::Either);
        if (!staysWithIt)
            m_gradient.deselect();
        m_inReach.reset();
        m_commands.update();
    });
    connect(&canvas, &CanvasWidget::viewChanged, this, &NodeTool::followView);
    connect(&m_commands, &NodeCommands::chosen, this, &NodeTool::selectNodes);
    connect(&m_commands, &NodeCommands::deleted, this, &NodeTool::rememberDeleted);
    m_commands.update();
}

void NodeTool::followView()
{
    m_reach.follow(m_canvas.view(), m_canvas.devicePixelRatioF());
}

bool NodeTool::isInUse() const
{
    return m_canvas.tool() == this;
}

QString NodeTool::hint() const
{
    if (m_hovered.mark.handle)
        return tr("Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.");
    if (m_hovered.mark.node)
        return tr(
            "Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. "
            "Shift+click for more.");
    if (m_hovered.gradient)
        return GradientHandles::hint();
    if (m_hovered.width)
        return WidthHandle::hint();
    if (m_hovered.erasure || (m_drag.isOpen() && m_hit.erasure))
        return erasureHint();
    if (m_hovered.curve)
        return tr("Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to "
                  "select the segment.");
    return tr(
        "Click a segment to select it, Shift+click for a run or another stroke's, Ctrl+click to add or remove one. "
        "Drag around nodes.");
}

QString NodeTool::erasureHint() const
{
    return m_drag.isOpen()
               ? tr("Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.")
               : tr("Drag to move the erasure. Click to select it in all strokes, again for its part in this "
                    "one, again for a segment. Delete removes it.");
}

QCursor NodeTool::cursor() const
{
    if (!m_hovered.mark.isEmpty() || m_hovered.width || m_hovered.gradient)
        return Qt::SizeAllCursor;
    return m_hovered.curve ? Qt::OpenHandCursor : Qt::PointingHandCursor;
}

QWidget *NodeTool::options()
{
    if (m_options)
        return m_options;
    m_options = new QWidget;
    QHBoxLayout *row = toolRow(m_options);
    m_commands.addButtons(*row);
    row->addSpacing(10);
    m_reach.addTo(*row);
    followView();
    row->addStretch();
    return m_options;
}

void NodeTool::followDocument(const Change &change)
{
    followDeleted(change);
    const std::size_t nodes = m_nodes.size();
    if (change.reset || change.selection)
        m_gradient.deselect();
    if (change.reset || !selection().segments.empty())
        m_nodes.clear();
    keepNodesOf(*m_editor.document().painting(), m_canvas.selection().strokes, m_nodes);
    if (m_nodes.size() == nodes && isOfDrag(change))
        m_inReach.followDrag(change);
    else
        m_inReach.follow(change, m_drag);
    m_commands.update();
}

/// What was deleted counts until something else is selected, which no edit does; and undo brings its nodes back.
void NodeTool::followDeleted(const Change &change)
{
    if (change.reset || (change.strokes.empty() && m_deleted && !m_deleted->leaves(selection())))
        m_deleted.reset();
    if (!m_deleted || change.strokes.empty())
        return;
    if (auto nodes = m_deleted->nodesIn(*m_editor.document().painting(), change.strokes))
        m_nodes = std::move(*nodes);
}

void NodeTool::rememberDeleted(const std::set<NodeRef> &nodes, const Painting &before)
{
    const Painting &after = *m_editor.document().painting();
    if (&after != &before) // what is locked stays
        m_deleted.emplace(nodes, before, after, selection());
}

/// Whether a change comes from dragging few strokes, and from nothing else.
bool NodeTool::isOfDrag(const Change &change) const
{
    constexpr std::size_t few = 32;
    return !change.selection && !change.order && !change.canvas && !change.texts && !change.reset &&
           change.strokes.size() <= few &&
           std::all_of(change.strokes.begin(), change.strokes.end(), [this](StrokeId id) { return m_drag.holds(id); });
}

void NodeTool::selectNodes(std::set<NodeRef> nodes)
{
    m_nodes = withSeams(*m_editor.document().painting(), nodes);
    m_gradient.deselect();
    // Segments and nodes are never both selected; where no node is left, this deselects the segments.
    if (!selection().segments.empty())
        select(Selection{selection().strokes, {}});
    m_inReach.reset();
    m_commands.update();
    m_canvas.updateSelection();
}

/// Where the knob of a gradient lies on a node, the middle is the node's, and the ring around it the knob's.
NodeHit NodeTool::hitAt(const PointerEvent &event) const
{
    return m_inReach.hitAt(event, m_gradient.isAt(event.pixel));
}

void NodeTool::setHovered(const Hovered &hovered)
{
    if (hovered == m_hovered)
        return;
    m_hovered = hovered;
    m_canvas.updateSelection();
    m_canvas.refreshCursor();
    emit hintChanged();
}

void NodeTool::hover(const PointerEvent &event)
{
    const NodeHit hit = hitAt(event);
    Hovered hovered;
    hovered.mark = hit.mark;
    hovered.gradient = hovered.mark.isEmpty() && m_gradient.isAt(event.pixel);
    hovered.width = hovered.mark.isEmpty() && !hovered.gradient && m_width.isAt(event.pixel);
    hovered.curve = !hovered.width && !hovered.gradient && hit.curve;
    hovered.erasure = hovered.curve && !erasureOf(*m_editor.document().painting(), hit.segment()).empty();
    setHovered(hovered);
}

void NodeTool::leave()
{
    setHovered({});
}

void NodeTool::press(const PointerEvent &event)
{
    const bool isFree = m_inReach.markAt(event.pixel, m_gradient.isAt(event.pixel)).isEmpty();
    if (isFree && m_gradient.press(event))
        return;
    m_gradient.deselect();
    const bool atWidth = isFree && m_width.isAt(event.pixel);
    if (atWidth && event.doubleClick)
        emit valuesAsked(event, *m_width.segment()); // to type the number
    else if (!atWidth || !m_width.press(event))
        SelectionTool::press(event);
}

void NodeTool::move(const PointerEvent &event)
{
    if (m_gradient.isBusy())
        m_gradient.move(event);
    else if (m_width.isBusy())
        m_width.move(event);
    else
        SelectionTool::move(event);
}

void NodeTool::release(const PointerEvent &event)
{
    if (m_gradient.isBusy())
        m_gradient.release();
    else if (m_width.isBusy())
        m_width.release();
    else
        SelectionTool::release(event);
}

void NodeTool::cancel()
{
    if (m_gradient.isBusy())
        m_gradient.cancel();
    if (m_width.isBusy())
        m_width.cancel();
    SelectionTool::cancel();
}

void NodeTool::pressed(const PointerEvent &event)
{
    m_inserted = false;
    m_hit = hitAt(event);
    if (event.doubleClick && m_hit.curve && !(event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier)))
        insertNode(m_hit);
}

void NodeTool::insertNode(const NodeHit &at)
{
    const StrokePtr before = m_editor.document().painting()->find(at.curve);
    m_editor.push(insertNodes(m_editor.document(), {{at.curve, {at.place}}}), tr("Insert node"));
    const StrokePtr after = m_editor.document().painting()->find(at.curve);
    if (!before || !after || nodeCount(*after) == nodeCount(*before))
        return;
    const NodeRef node{at.curve, at.place.segment + 1};
    selectNodes({node});
    m_inserted = true;
    m_hit = {};
    m_hit.mark.node = node;
}

void NodeTool::clicked(const PointerEvent &event)
{
    if (m_inserted)
        return;
    const bool add = event.modifiers & Qt::ShiftModifier;
    const bool goesOnWithSegments = add && !selection().segments.empty();
    const bool nodesCount = !goesOnWithSegments && !(event.modifiers & Qt::ControlModifier);
    if (m_hit.within && nodesCount && selection().segments.contains(m_hit.segment()) &&
        !isWholeErasure(*m_editor.document().painting(), selection().segments, m_hit.segment())) {
        selectNodes({*m_hit.within});
    } else if (m_hit.mark.node && nodesCount) {
        std::set<NodeRef> nodes = add ? m_nodes : std::set<NodeRef>();
        const bool takesOff = nodes.contains(*m_hit.mark.node);
        for (const NodeRef &node : withSeams(*m_editor.document().painting(), {*m_hit.mark.node}))
            if (takesOff)
                nodes.erase(node);
            else
                nodes.insert(node);
        selectNodes(std::move(nodes));
    } else if (!(m_hit.mark.handle && nodesCount)) {
        clickedSegment(event);
    }
}

void NodeTool::clickedSegment(const PointerEvent &event)
{
    const bool plain = !(event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier));
    const bool shift = (event.modifiers & Qt::ShiftModifier) && m_nodes.empty();
    if (m_hit.curve && (plain || shift))
        if (auto chosen = withErasure(*m_editor.document().painting(), selection(), m_hit.segment(), shift))
            return select(std::move(*chosen));
    if (event.modifiers & Qt::ShiftModifier && selectRun(event))
        return;
    std::optional<SegmentRef> hit = m_hit.curve ? m_hit.segment() : pick(event);
    if (!hit) {
        if (!(event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier))) {
            if (m_nodes.empty())
                select({});
            selectNodes({});
        }
        return;
    }
    if (event.modifiers & Qt::ShiftModifier) {
        addStroke(*hit);
    } else if (event.modifiers & Qt::ControlModifier) {
        Selection chosen = selection();
        if (!chosen.segments.erase(*hit))
            chosen.segments.insert(*hit);
        chosen.strokes.insert(hit->stroke);
        select(std::move(chosen));
    } else {
        selectSegment(*hit);
    }
}

/// Adds another stroke to the selection: the segment that was hit or, where nodes are selected, the whole stroke, so
/// that its nodes can be chosen.
void NodeTool::addStroke(const SegmentRef &hit)
{
    if (m_nodes.empty())
        return addSegment(hit);
    std::set<StrokeId> strokes = selection().strokes;
    strokes.insert(hit.stroke);
    select(Selection{std::move(strokes), {}});
}

void NodeTool::banded(const Rect &band, const PointerEvent &event)
{
    const bool add = event.modifiers & Qt::ShiftModifier;
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    std::set<NodeRef> nodes = nodesWithin(painting, m_canvas.selection().strokes, m_canvas.view(), band);
    if (!nodes.empty()) {
        if (add)
            nodes.insert(m_nodes.begin(), m_nodes.end());
        selectNodes(std::move(nodes));
        return;
    }
    Selection chosen;
    if (add)
        chosen = selection();
    for (const SegmentRef &segment : segmentsWithin(painting, m_editor.clock().time(), m_canvas.view(), band)) {
        chosen.segments.insert(segment);
        chosen.strokes.insert(segment.stroke);
    }
    selectNodes({});
    select(std::move(chosen));
}

bool NodeTool::wantsKey(const QKeyEvent &event) const
{
    const bool tab = event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab;
    return tab && !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool NodeTool::keyPress(QKeyEvent *event)
{
    if (wantsKey(*event)) { // A drag keeps the keyboard.
        if (!isBusy())
            selectNext(event->key() == Qt::Key_Backtab || event->modifiers() & Qt::ShiftModifier ? -1 : 1);
        return true;
    }
    if (isBusy())
        return SelectionTool::keyPress(event);
    if (event->key() == Qt::Key_Escape && m_gradient.deselect())
        return true;
    if (!m_nodes.empty() && event->key() == Qt::Key_Escape) {
        selectNodes({});
        return true;
    }
    return nudge(event) || SelectionTool::keyPress(event);
}

void NodeTool::selectNext(int step)
{
    m_commands.selectNext(step);
    if (m_nodes.empty())
        return;
    if (const StrokePtr stroke = m_editor.document().painting()->find(m_nodes.begin()->stroke))
        m_canvas.bringIntoView(nodePosition(*stroke, m_nodes.begin()->node)); // The next key is meant for what is seen.
}

bool NodeTool::deleteSelected()
{
    if (m_gradient.isChosen()) {
        m_commands.say(tr("An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes "
                          "the gradient away; Esc first, and Delete means the stroke."));
    } else if (m_nodes.empty() && m_deleted && m_deleted->leaves(selection())) {
        m_commands.say(tr("What was selected is deleted; its strokes are merely shown. Click what else is to go, or "
                          "take whole strokes with the Select tool."));
    } else if (m_nodes.empty() && !selection().segments.empty()) {
        const PaintingPtr before = m_editor.document().painting();
        Selection parts{{}, selection().segments}; // Strokes that take no part are merely shown.
        for (const SegmentRef &segment : parts.segments)
            parts.strokes.insert(segment.stroke);
        select(std::move(parts));
        commands::deleteSelected(m_editor);
        rememberDeleted({}, *before);
    } else {
        return m_commands.deleteNodes();
    }
    return true;
}

/// Moves the selected nodes or, without any, those at the ends of the selected segments. Erasures are moved as they
/// are, without a reach.
bool NodeTool::nudge(QKeyEvent *event)
{
    const std::optional<Point> way = nudgeOf(*event);
    const Painting &painting = *m_editor.document().painting();
    const std::set<SegmentRef> &chosen = selection().segments;
    const std::set<NodeRef> ends = nodesAround(painting, chosen);
    const bool isErasure = m_nodes.empty() && nodesOfErasures(painting, chosen) == ends;
    const std::set<NodeRef> &nodes = m_nodes.empty() ? ends : m_nodes;
    if (!way)
        return false;
    if (std::exchange(m_nudged, nodes) != nodes) // The document does not know of them, and is no judge of it.
        m_nodeNudges.endSteps();
    m_nodeNudges.noteStep(event->isAutoRepeat());
    if (m_gradient.nudge(*way, m_nodeNudges))
        return true;
    if (nodes.empty())
        return false;
    const NodeRef &front = *nodes.begin();
    const StrokePtr first = painting.find(front.stroke);
    const double reach =
        first && !isErasure ? m_reach.ofNode(*first, front.node, m_canvas.view(), m_canvas.devicePixelRatioF()) : 0;
    m_editor.push(moveNodes(m_editor.document(), nodes, *way, reach, m_reach.ends()),
                  isErasure            ? tr("Move erasure")
                  : m_nodes.empty()    ? tr("Move segments")
                  : m_nodes.size() > 1 ? tr("Move nodes")
                                       : tr("Move node"),
                  &m_nodeNudges);
    return true;
}

bool NodeTool::beginDrag(const PointerEvent &)
{
    const std::optional<NodeRef> &node = m_hit.mark.node;
    if (node && !m_nodes.contains(*node)) {
        std::set<NodeRef> nodes = start().modifiers & Qt::ShiftModifier ? m_nodes : std::set<NodeRef>();
        nodes.insert(*node);
        selectNodes(std::move(nodes));
    }
    if (m_hit.mark.isEmpty() && m_hit.curve && dragErasure(start()))
        return m_drag.isOpen();
    if (!m_hit.mark.isEmpty() || m_hit.curve)
        m_drag.begin(start(), m_hit, m_nodes);
    return m_drag.isOpen();
}

/// Erasures are moved as they are: the selected ones if one of them was pressed, else the one that was. Returns false
/// where the curve lays paint.
bool NodeTool::dragErasure(const PointerEvent &press)
{
    const Painting &painting = *m_editor.document().painting();
    if (erasureOf(painting, m_hit.segment()).empty())
        return false;
    if (!selection().segments.contains(m_hit.segment()))
        if (auto chosen = withErasure(painting, selection(), m_hit.segment(), false))
            select(std::move(*chosen));
    m_hit.erasure = true;
    NodeHit node = m_hit;
    node.mark.node = NodeRef{m_hit.curve, m_hit.place.segment};
    m_drag.begin(press, node, nodesOfErasures(painting, selection().segments));
    emit hintChanged();
    return true;
}

void NodeTool::drag(const PointerEvent &event)
{
    m_drag.move(event);
}

void NodeTool::endDrag(bool cancelled)
{
    if (cancelled)
        m_drag.giveUp();
    else
        m_drag.commit();
    m_inReach.reset();
    if (std::exchange(m_hit.erasure, false))
        emit hintChanged();
}

void NodeTool::stepSize(int steps)
{
    if (m_drag.stepReach(steps))
        return;
    const View &view = m_canvas.view();
    const double dpr = m_canvas.devicePixelRatioF();
    m_reach.choose(SoftReach::stepped(m_reach.chosen().value_or(SoftReach::usual(view, dpr)), steps, view, dpr));
}

Rect NodeTool::chosenBox() const
{
    return curvesAround(*m_editor.document().painting(), m_nodes);
}

std::optional<double> NodeTool::paintMargin() const
{
    constexpr double marks = 20; // logical pixels that nodes, handles and the mark of a snap take
    return std::max({marks * m_canvas.devicePixelRatioF(), m_width.reach(), m_gradient.reach(), m_drag.margin()});
}

void NodeTool::paint(QPainter &painter, const View &view, double dpr) const
{
    m_width.paint(painter, view, dpr);
    m_gradient.paint(painter, view, dpr);
    m_drag.paint(painter, view, dpr);
    m_inReach.marks().paint(painter, m_canvas.overlayColours(), m_hovered.mark);
    SelectionTool::paint(painter, view, dpr);
}

} // namespace suffuse
