#include "app/tools/nodes/node_sets.h"

#include "model/painting/editable.h"
#include "model/shaping/nodes/reshape.h"
#include "render/view.h"

#include <map>

namespace suffuse {

std::set<NodeRef> nodesAround(const Painting &painting, const std::set<SegmentRef> &segments)
{
    std::set<NodeRef> nodes;
    StrokePtr stroke;
    for (const SegmentRef &ref : segments) {
        if (!stroke || stroke->id != ref.stroke)
            stroke = painting.find(ref.stroke);
        if (!stroke || ref.segment >= int(stroke->segments.size()))
            continue;
        nodes.insert({ref.stroke, ref.segment});
        nodes.insert({ref.stroke, endNode(*stroke, ref.segment)});
    }
    return nodes;
}

std::set<NodeRef> withSeams(const Painting &painting, const std::set<NodeRef> &nodes)
{
    std::set<NodeRef> all;
    StrokePtr stroke;
    for (const NodeRef &ref : nodes) {
        if (!stroke || stroke->id != ref.stroke)
            stroke = painting.find(ref.stroke);
        if (stroke)
            for (const int node : nodesTogether(*stroke, ref.node))
                all.insert(all.end(), {ref.stroke, node});
    }
    return all;
}

std::set<NodeRef> nodesWithin(const Painting &painting, const std::set<StrokeId> &strokes, const View &view,
                              const Rect &pixels)
{
    std::set<NodeRef> nodes;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.contains(stroke->id) && isEditable(*stroke))
            for (int k = 0; k < nodeCount(*stroke); ++k)
                if (pixels.contains(view.toPixels(nodePosition(*stroke, k))))
                    nodes.insert({stroke->id, k});
    return nodes;
}

std::set<StrokeId> strokesOf(const std::set<NodeRef> &nodes)
{
    std::set<StrokeId> strokes;
    for (const NodeRef &node : nodes)
        strokes.insert(strokes.end(), node.stroke);
    return strokes;
}

void keepNodesOf(const Painting &painting, const std::set<StrokeId> &strokes, std::set<NodeRef> &nodes)
{
    if (nodes.empty())
        return;
    std::map<StrokeId, int> counts; // the nodes of each of the strokes that has some of `nodes`
    const std::set<StrokeId> wanted = strokesOf(nodes);
    for (const StrokePtr &stroke : painting.strokes)
        if (wanted.contains(stroke->id) && strokes.contains(stroke->id))
            counts[stroke->id] = nodeCount(*stroke);
    std::erase_if(nodes, [&](const NodeRef &n) { return !counts.contains(n.stroke) || n.node >= counts[n.stroke]; });
}

} // namespace suffuse
