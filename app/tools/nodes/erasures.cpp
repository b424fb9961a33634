#include "app/tools/nodes/erasures.h"

#include "model/shaping/chains.h"
#include "model/shaping/reshape.h"

namespace suffuse {

std::set<SegmentRef> erasureOf(const Painting &painting, const SegmentRef &segment)
{
    std::set<SegmentRef> segments;
    const StrokePtr stroke = painting.find(segment.stroke);
    if (!stroke || segment.segment >= int(stroke->segments.size()) ||
        !stroke->segments[std::size_t(segment.segment)].lift)
        return segments;
    const Chain chain = chainAt(*stroke, segment.segment);
    for (int k = chain.first; k <= chain.last; ++k)
        if (stroke->segments[std::size_t(k)].lift)
            segments.insert(segments.end(), SegmentRef{stroke->id, k});
    return segments;
}

std::optional<ErasurePlace> erasureAt(const Painting &painting, Point point, double reach)
{
    std::optional<ErasurePlace> found;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!stroke->hasLift() || !painting.isVisible(*stroke) || painting.isLocked(*stroke))
            continue;
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            const Segment &segment = stroke->segments[k];
            if (!segment.lift || !stroke->cubicOf(segment).controlBox().grown(reach).contains(point))
                continue;
            Stroke one;
            one.origin = stroke->origin;
            one.segments = {segment};
            double distance = 0;
            const CurvePlace place = nearestPlace(one, point, &distance);
            if (distance > reach)
                continue;
            reach = distance;
            found = {stroke->id, int(k), place.p};
        }
    }
    return found;
}

std::set<NodeRef> nodesOfErasureAt(const Painting &painting, const NodeRef &node)
{
    const StrokePtr stroke = painting.find(node.stroke);
    if (!stroke)
        return {};
    const NodeSides sides = sidesOf(*stroke, node.node);
    const int segment = std::max(sides.after, sides.before);
    return segment < 0 ? std::set<NodeRef>() : nodesOfErasures(painting, erasureOf(painting, {node.stroke, segment}));
}

std::set<NodeRef> nodesOfErasures(const Painting &painting, const std::set<SegmentRef> &segments)
{
    std::set<NodeRef> nodes;
    StrokePtr stroke;
    for (const SegmentRef &ref : segments) {
        if (!stroke || stroke->id != ref.stroke)
            stroke = painting.find(ref.stroke);
        if (!stroke || ref.segment >= int(stroke->segments.size()) || !stroke->segments[std::size_t(ref.segment)].lift)
            continue;
        nodes.insert({ref.stroke, ref.segment});
        nodes.insert({ref.stroke, endNode(*stroke, ref.segment)});
    }
    return nodes;
}

} // namespace suffuse
