// How the Segments tool drags nodes, handles and curves.
#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/tools/nodes/node_tool.h"
#include "undo/node_edits.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

/// Handles that are dragged with Ctrl take angles in steps of this.
constexpr double handleAngleStep = std::numbers::pi / 12;

/// The part of a move along one axis of the screen: along the axis with the longer part.
Point alongAxis(Point pixels)
{
    return std::abs(pixels.x) > std::abs(pixels.y) ? Point{pixels.x, 0} : Point{0, pixels.y};
}

/// The part of a move along one of a node's handles, namely the one that it follows more. Without handles it is the
/// whole move.
Point alongHandles(const Stroke &stroke, int node, Point by)
{
    Point best = by;
    double longest = -1;
    for (const bool after : {false, true}) {
        const std::optional<Point> handle = handlePosition(stroke, node, after);
        const Point way = handle ? *handle - nodePosition(stroke, node) : Point{};
        const double l = length(way);
        if (l == 0)
            continue;
        const Point part = (dot(by, way) / (l * l)) * way;
        if (length(part) > longest) {
            longest = length(part);
            best = part;
        }
    }
    return best;
}

} // namespace

bool NodeTool::beginDrag(const PointerEvent &event)
{
    if (m_hit.node) {
        if (!m_nodes.contains(*m_hit.node)) {
            std::set<NodeRef> nodes = event.modifiers & Qt::ShiftModifier ? m_nodes : std::set<NodeRef>();
            nodes.insert(*m_hit.node);
            selectNodes(std::move(nodes));
        }
        begin(strokesOfNodes(), m_nodes.size() > 1 ? tr("Move nodes") : tr("Move node"));
        m_snapping = Snapping(*m_editor.document().painting(), m_canvas.aids(), [this](const Stroke &stroke, int node) {
            return m_nodes.contains({stroke.id, node});
        });
    } else if (m_hit.handle) {
        begin({m_hit.handle->node.stroke}, tr("Move handle"));
    } else if (m_onCurve) {
        begin({m_onCurve->stroke}, tr("Bend curve"));
    }
    return m_gesture.isOpen();
}

/// Begins the drag of those of the strokes that are not locked. If all are locked, nothing is dragged.
void NodeTool::begin(const std::set<StrokeId> &strokes, const QString &name)
{
    m_gesture = m_editor.begin(name);
    m_gesture.take(strokes);
    if (m_gesture.strokes().empty())
        m_gesture.giveUp();
}

void NodeTool::drag(const PointerEvent &event)
{
    if (m_hit.node)
        dragNodes(event);
    else if (m_hit.handle)
        dragHandle(event);
    else if (m_onCurve)
        m_gesture.show([&](const Stroke &stroke) {
            return withCurveDragged(stroke, m_onCurve->place.segment, m_onCurve->place.p, event.point - start().point);
        });
}

void NodeTool::dragNodes(const PointerEvent &event)
{
    const Stroke *grabbed = m_gesture.before(m_hit.node->stroke);
    if (!grabbed)
        return;
    const View &view = m_canvas.view();
    Point by = event.point - start().point;
    m_snap = {};
    if (event.modifiers & Qt::ControlModifier) {
        by = view.toCanvas(start().pixel + alongAxis(event.pixel - start().pixel)) - start().point;
    } else if (event.modifiers & Qt::AltModifier) {
        by = alongHandles(*grabbed, m_hit.node->node, by);
    } else {
        const Point node = nodePosition(*grabbed, m_hit.node->node);
        m_snap = m_snapping.snap(node + by, view, m_canvas.devicePixelRatioF());
        if (m_snap.to != SnapTo::Nothing)
            by = m_snap.point - node;
    }
    std::map<StrokeId, std::vector<int>> nodes;
    for (const NodeRef &node : m_nodes)
        nodes[node.stroke].push_back(node.node);
    m_gesture.show([&](const Stroke &stroke) { return withNodeMoved(stroke, nodes[stroke.id], by); });
}

void NodeTool::dragHandle(const PointerEvent &event)
{
    const auto [node, after] = *m_hit.handle;
    const Stroke *grabbed = m_gesture.before(node.stroke);
    if (!grabbed)
        return;
    const View &view = m_canvas.view();
    Point to = *handlePosition(*grabbed, node.node, after) + (event.point - start().point);
    if (event.modifiers & Qt::ControlModifier) {
        const Point centre = view.toPixels(nodePosition(*grabbed, node.node));
        const Point arm = view.toPixels(to) - centre;
        const double angle = handleAngleStep * std::round(std::atan2(arm.y, arm.x) / handleAngleStep);
        to = view.toCanvas(centre + length(arm) * Point{std::cos(angle), std::sin(angle)});
    }
    const bool breaks = event.modifiers & Qt::ShiftModifier;
    m_gesture.show([&](const Stroke &stroke) {
        return withHandleMoved(breaks ? withNodeKind(stroke, {node.node}, NodeKind::Corner) : stroke, node.node, after,
                               to);
    });
}

void NodeTool::endDrag(bool cancelled)
{
    if (cancelled)
        m_gesture.giveUp();
    else
        m_gesture.commit();
    m_marks.reset();
    m_snap = {};
}

} // namespace suffuse
