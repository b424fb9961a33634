#include "app/tools/nodes/nodes_in_reach.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/tools/nodes/erasures.h"
#include "model/painting/editable.h"
#include "model/shaping/nodes/coarse_nodes.h"

#include <algorithm>

namespace suffuse {

NodesInReach::NodesInReach(CanvasWidget &canvas, const std::set<NodeRef> &nodes)
    : m_canvas(canvas), m_editor(canvas.editor()), m_nodes(nodes)
{}

const NodeMarks &NodesInReach::marks() const
{
    if (!m_marks || m_marks->view() != m_canvas.view())
        m_marks.emplace(*m_editor.layer().reached(), m_canvas.selection().strokes, m_nodes, m_canvas.view(),
                        m_canvas.devicePixelRatioF(), m_shown);
    return *m_marks;
}

NodeMarks::Hit NodesInReach::markAt(Point pixel, bool narrow) const
{
    return marks().hit(pixel, narrow ? NodeMarks::narrowReach : NodeMarks::reach);
}

/// Whether a node belongs to an erasure of which no node is selected.
bool NodesInReach::meansErasure(const NodeRef &node) const
{
    const std::set<NodeRef> nodes = nodesOfErasureAt(*m_editor.document().painting(), node);
    return !nodes.empty() && std::ranges::none_of(nodes, [this](const NodeRef &n) { return m_nodes.contains(n); });
}

std::optional<ErasurePlace> NodesInReach::shownErasureAt(Point point, double reach) const
{
    const std::set<StrokeId> *only = m_canvas.showsErasures() ? nullptr : &m_canvas.selection().strokes;
    return erasureAt(*m_editor.layer().reached(), point, reach, only);
}

std::optional<ErasurePlace> NodesInReach::selectedErasureAt(Point point, double reach) const
{
    const std::set<SegmentRef> &segments = m_canvas.selection().segments;
    const PaintingPtr painting = m_editor.layer().reached();
    if (segments.empty() || !m_nodes.empty())
        return {};
    const std::optional<ErasurePlace> erasure = erasureAt(*painting, point, reach);
    if (!erasure || !segments.contains({erasure->stroke, erasure->segment}))
        return {};
    const NodeMarks::Hit mark = marks().hit(m_canvas.view().toPixels(point), NodeMarks::reach);
    const bool isItsOwn = mark.node && !nodesOfErasureAt(*painting, *mark.node).empty();
    return mark.isEmpty() || isItsOwn ? std::nullopt : erasure;
}

NodeHit NodesInReach::hitAt(const PointerEvent &event, bool narrow) const
{
    NodeHit hit;
    hit.mark = markAt(event.pixel, narrow);
    const PaintingPtr painting = m_editor.layer().reached();
    const double reach = NodeMarks::reach * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    if (const std::optional<ErasurePlace> erasure = selectedErasureAt(event.point, reach)) {
        hit.mark = {};
        hit.curve = erasure->stroke;
        hit.place = {erasure->segment, erasure->p};
        return hit;
    }
    // Between the nodes of lettering there is no ground without one in reach: over an erasure a node is what is seen of
    // it.
    if (hit.mark.node && !m_nodes.contains(*hit.mark.node) && nodesOfErasureAt(*painting, *hit.mark.node).empty() &&
        shownErasureAt(event.point, reach))
        hit.mark = markAt(event.pixel, true);
    if (hit.mark.node && meansErasure(*hit.mark.node)) {
        hit.within = std::exchange(hit.mark.node, std::nullopt);
        hit.curve = hit.within->stroke;
        hit.place = placeOfNode(*painting->find(hit.curve), hit.within->node);
    }
    if (hit.mark.isEmpty() && !hit.within)
        findCurve(event.point, reach, hit);
    return hit;
}

void NodesInReach::findCurve(Point point, double reach, NodeHit &hit) const
{
    const PaintingPtr painting = m_editor.layer().reached();
    const std::set<StrokeId> &shown = m_canvas.selection().strokes;
    const Editable isEditable(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        if (!shown.contains(stroke->id) || !isEditable(*stroke))
            continue;
        const auto isNear = [&](const Segment &segment) {
            return stroke->cubicOf(segment).controlBox().grown(reach).contains(point);
        };
        if (std::none_of(stroke->segments.begin(), stroke->segments.end(), isNear))
            continue;
        double distance = 0;
        const CurvePlace place = nearestPlace(*stroke, point, &distance);
        if (distance <= reach) {
            reach = distance;
            hit.curve = stroke->id;
            hit.place = place;
        }
    }
    if (!hit.curve && m_canvas.showsErasures())
        if (const auto erasure = shownErasureAt(point, reach)) {
            hit.curve = erasure->stroke;
            hit.place = {erasure->segment, erasure->p};
        }
}

void NodesInReach::followDrag(const Change &change)
{
    if (m_marks)
        m_marks->follow(*m_editor.layer().reached(), change.strokes, m_nodes);
}

void NodesInReach::follow(const Change &change, const NodeDrag &drag)
{
    for (const StrokeId stroke : change.strokes)
        if (!drag.holds(stroke))
            m_shown.ofStrokes.erase(stroke);
    if (change.reset)
        m_shown.ofStrokes.clear();
    m_marks.reset();
}

} // namespace suffuse
