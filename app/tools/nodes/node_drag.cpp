#include "app/tools/nodes/node_drag.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/tools/tool_fields.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double handleAngleStep = std::numbers::pi / 12; ///< the step of a handle's angle with Ctrl
constexpr double followingLine = 2;                       ///< width of the line along what follows, logical pixels
constexpr double ringEdge = 4;                            ///< what the ring's pen takes, logical pixels

/// The longer one of the two parts of a move along the axes of the screen.
Point alongAxis(Point pixels)
{
    return std::abs(pixels.x) > std::abs(pixels.y) ? Point{pixels.x, 0} : Point{0, pixels.y};
}

/// The part of a move along that handle of a node which the move follows more; all of the move if the node has no
/// handles.
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

/// The name of the step that a drag makes.
QString stepName(const NodeHit &hit, std::size_t nodes)
{
    if (hit.erasure)
        return QCoreApplication::translate("NodeDrag", "Move erasure");
    if (hit.mark.node)
        return nodes > 1 ? QCoreApplication::translate("NodeDrag", "Move nodes")
                         : QCoreApplication::translate("NodeDrag", "Move node");
    return hit.mark.handle ? QCoreApplication::translate("NodeDrag", "Move handle")
                           : QCoreApplication::translate("NodeDrag", "Bend curve");
}

} // namespace

double NodeDrag::dpr() const
{
    return m_canvas.devicePixelRatioF();
}

StrokeId NodeDrag::grabbed() const
{
    return m_hit.mark.node ? m_hit.mark.node->stroke : m_hit.mark.handle ? m_hit.mark.handle->node.stroke : m_hit.curve;
}

StrokePtr NodeDrag::grabbedStroke() const
{
    const StrokePtr stroke = m_canvas.editor().document().painting()->find(grabbed());
    const bool isThere = stroke && (m_hit.mark.node ? m_hit.mark.node->node < nodeCount(*stroke)
                                                    : m_hit.place.segment < int(stroke->segments.size()));
    return isThere ? stroke : nullptr;
}

Point NodeDrag::placeOn(const Stroke &stroke) const
{
    if (m_hit.mark.node)
        return nodePosition(stroke, m_hit.mark.node->node);
    return stroke.cubicOf(stroke.segments[std::size_t(m_hit.place.segment)]).at(m_hit.place.p);
}

void NodeDrag::begin(const PointerEvent &press, const NodeHit &hit, const std::set<NodeRef> &nodes)
{
    m_hit = hit;
    m_start = m_now = press;
    m_nodes.clear();
    const bool alt = press.modifiers & Qt::AltModifier && !(press.modifiers & Qt::ControlModifier);
    std::set<StrokeId> strokes{grabbed()};
    if (hit.mark.node)
        for (const NodeRef &node : nodes) {
            strokes.insert(node.stroke);
            m_nodes[node.stroke].push_back(node.node);
        }
    const StrokePtr stroke = grabbedStroke();
    if (!stroke)
        return;
    m_reach = 0;
    if (hit.mark.node && !hit.erasure)
        m_reach = m_soft.ofNode(*stroke, hit.mark.node->node, m_canvas.view(), dpr());
    else if (hit.curve)
        m_reach = m_soft.ofCurve(*stroke, hit.place, m_canvas.view(), dpr());
    if (alt && !hit.mark.handle && !hit.erasure) {
        m_setsReach = true;
        m_chosenBefore = m_soft.chosen();
    } else {
        take(strokes, stepName(hit, nodes.size()));
        gatherPlaces();
    }
    if (isOpen() && !hit.mark.handle && !hit.erasure)
        m_soft.showInEffect(m_reach);
}

/// Takes those strokes that are not locked. If all are, there is nothing to drag.
void NodeDrag::take(const std::set<StrokeId> &strokes, const QString &name)
{
    m_gesture = m_canvas.editor().begin(name);
    m_gesture.take(strokes);
    if (m_gesture.strokes().empty())
        m_gesture.giveUp();
}

/// Gathers the places to snap to. These are the nodes that the drag leaves where they are.
void NodeDrag::gatherPlaces()
{
    m_snapping = {};
    if (!m_hit.mark.node || !m_gesture.isOpen())
        return;
    Editor &editor = m_canvas.editor();
    m_snapping = Snapping(*editor.document().painting(), m_canvas.aids(), editor.aids().guides(),
                          [this](const Stroke &stroke, int node) {
                              const auto it = m_nodes.find(stroke.id);
                              return it != m_nodes.end() &&
                                     (m_reach > 0 ||
                                      std::find(it->second.begin(), it->second.end(), node) != it->second.end());
                          });
}

void NodeDrag::setReach(double reach)
{
    if (reach == m_reach)
        return;
    const bool wasSoft = m_reach > 0;
    m_reach = reach;
    m_soft.choose(reach);
    m_soft.showInEffect(reach);
    if (wasSoft != (m_reach > 0))
        gatherPlaces();
    m_canvas.updateSelection();
}

bool NodeDrag::stepReach(double steps)
{
    if (!isOpen() || m_hit.mark.handle || m_hit.erasure)
        return false;
    setReach(SoftReach::stepped(m_reach, steps, m_canvas.view(), dpr()));
    if (!m_setsReach)
        show();
    return true;
}

void NodeDrag::move(const PointerEvent &event)
{
    m_now = event;
    if (!m_setsReach)
        return show();
    if (const StrokePtr stroke = grabbedStroke())
        setReach(SoftReach::settled(length(event.point - placeOn(*stroke)), m_canvas.view(), dpr()));
}

void NodeDrag::show()
{
    if (m_hit.mark.node)
        showNodes();
    else if (m_hit.mark.handle)
        showHandle();
    else
        showCurve();
}

void NodeDrag::showNodes()
{
    const Stroke *grabbed = m_gesture.before(m_hit.mark.node->stroke);
    if (!grabbed)
        return;
    const View &view = m_canvas.view();
    Point by = m_now.point - m_start.point;
    m_snap = {};
    if (m_now.modifiers & Qt::ControlModifier && m_now.modifiers & Qt::AltModifier) {
        by = alongHandles(*grabbed, m_hit.mark.node->node, by);
    } else if (m_now.modifiers & Qt::ControlModifier) {
        by = view.toCanvas(m_start.pixel + alongAxis(m_now.pixel - m_start.pixel)) - m_start.point;
    } else {
        const Point node = nodePosition(*grabbed, m_hit.mark.node->node);
        m_snap = m_snapping.snap(node + by, view, dpr());
        if (m_snap.to != SnapTo::Nothing)
            by = m_snap.point - node;
    }
    m_gesture.show([&](const Stroke &stroke) { return SoftMove(stroke, m_nodes[stroke.id], m_reach, m_soft.ends()).by(by); });
}

void NodeDrag::showHandle()
{
    const auto [node, after] = *m_hit.mark.handle;
    const Stroke *grabbed = m_gesture.before(node.stroke);
    if (!grabbed)
        return;
    const View &view = m_canvas.view();
    Point to = *handlePosition(*grabbed, node.node, after) + (m_now.point - m_start.point);
    if (m_now.modifiers & Qt::ControlModifier) {
        const Point centre = view.toPixels(nodePosition(*grabbed, node.node));
        const Point arm = view.toPixels(to) - centre;
        const double angle = handleAngleStep * std::round(std::atan2(arm.y, arm.x) / handleAngleStep);
        to = view.toCanvas(centre + length(arm) * Point{std::cos(angle), std::sin(angle)});
    }
    const bool breaks = m_now.modifiers & Qt::ShiftModifier;
    m_gesture.show([&, node = node, after = after](const Stroke &stroke) {
        return withHandleMoved(breaks ? withNodeKind(stroke, {node.node}, NodeKind::Corner) : stroke, node.node, after,
                               to);
    });
}

/// The grabbed place moves as the pointer does, and so keeps the distance to it that it had at the press.
void NodeDrag::showCurve()
{
    const Point by = m_now.point - m_start.point;
    m_gesture.show([&](const Stroke &stroke) { return SoftMove(stroke, m_hit.place, m_reach, m_soft.ends()).by(by); });
}

void NodeDrag::commit()
{
    m_gesture.commit();
    end();
}

void NodeDrag::giveUp()
{
    m_gesture.giveUp();
    if (m_setsReach)
        m_soft.choose(m_chosenBefore);
    end();
}

void NodeDrag::end()
{
    m_setsReach = false;
    m_snapping = {};
    m_snap = {};
    m_soft.showInEffect(std::nullopt);
}

double NodeDrag::margin() const
{
    return isOpen() && !m_hit.mark.handle ? m_reach * m_canvas.view().scale + ringEdge * dpr() : 0;
}

void NodeDrag::paint(QPainter &painter, const View &view, double dpr) const
{
    if (!isOpen())
        return;
    if (m_snap.to != SnapTo::Nothing)
        paintSnapMark(painter, view.toPixels(m_snap.point), m_canvas.overlayColours(), dpr);
    const StrokePtr now = grabbedStroke();
    if (!now || m_hit.mark.handle || !(m_reach > 0))
        return;
    // Lengths along the shape that the stroke had at the press decide what follows.
    QPainterPath following;
    for (const StrokeId id : m_setsReach ? std::set<StrokeId>{grabbed()} : m_gesture.strokes()) {
        const StrokePtr shown = m_canvas.editor().document().painting()->find(id);
        const Stroke *before = m_setsReach ? shown.get() : m_gesture.before(id);
        if (!shown || !before || before->segments.size() != shown->segments.size())
            continue;
        const auto nodes = m_nodes.find(id);
        const SoftMove move = nodes != m_nodes.end() ? SoftMove(*before, nodes->second, m_reach, m_soft.ends())
                                                     : SoftMove(*before, m_hit.place, m_reach, m_soft.ends());
        for (const int k : move.segments())
            addCurve(following, shown->cubicOf(shown->segments[std::size_t(k)]), view);
    }
    strokeTwoTone(painter, following, m_canvas.overlayColours().accent, followingLine * dpr);
    const Point centre = view.toPixels(placeOn(*now));
    if (const double r = m_reach * view.scale; r < 2.0 * (view.width + view.height))
        paintRing(painter, centre.x, centre.y, r, dpr);
}

} // namespace suffuse
