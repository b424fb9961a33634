#include "app/tools/nodes/erasures.h"

#include "model/shaping/chains.h"

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
