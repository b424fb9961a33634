#include "app/session/selecting/seen_selection.h"

#include "model/paint/half_width.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/erasing/erase.h"
#include "model/shaping/transform.h"

#include <optional>
#include <vector>

namespace suffuse {

namespace {

std::vector<int> selectedSegments(const Selection &selection, StrokeId id)
{
    std::vector<int> result;
    for (auto it = selection.segments.lower_bound({id, 0}); it != selection.segments.end() && it->stroke == id; ++it)
        result.push_back(it->segment);
    return result;
}

Rect curvesOf(const Stroke &stroke, const std::vector<int> &segments)
{
    Rect box;
    for (const int segment : segments)
        box = box.united(stroke.cubicOf(stroke.segments[std::size_t(segment)]).controlBox());
    return box;
}

} // namespace

Rect seenSelection(const Painting &painting, const Selection &selection)
{
    Rect all;
    for (const StrokeId id : selection.strokes) {
        const StrokePtr stroke = painting.find(id);
        if (!stroke)
            continue;
        const std::vector<int> segments = selectedSegments(selection, id);
        const std::optional<Stroke> part = segments.empty() ? *stroke : withSegmentsOnly(*stroke, segments);
        const Rect seen = part ? seenBox(*part) : Rect();
        all = all.united(!seen.isEmpty() ? seen : segments.empty() ? controlBox(*stroke) : curvesOf(*stroke, segments));
    }
    return all;
}

Rect curvesAround(const Painting &painting, const std::set<NodeRef> &nodes)
{
    Rect all;
    for (const NodeRef &node : nodes) {
        const StrokePtr stroke = painting.find(node.stroke);
        if (!stroke)
            continue;
        const NodeSides sides = sidesOf(*stroke, node.node);
        std::vector<int> meeting;
        for (const int side : {sides.before, sides.after})
            if (side >= 0)
                meeting.push_back(side);
        all = all.united(curvesOf(*stroke, meeting));
    }
    return all;
}

} // namespace suffuse
