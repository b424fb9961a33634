#include "app/panels/inspected.h"

#include "undo/edits.h"

#include <unordered_map>

namespace suffuse {

Inspected inspect(const Document &document)
{
    Inspected result;
    result.painting = document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    std::unordered_map<StrokeId, const Stroke *> byId;
    for (const StrokePtr &stroke : result.painting->strokes)
        if (selected.contains(stroke->id)) {
            byId.emplace(stroke->id, stroke.get());
            result.strokes.push_back(stroke.get());
        }
    for (const SegmentRef &ref : targetSegments(document)) {
        const auto it = byId.find(ref.stroke);
        if (it == byId.end() || ref.segment < 0 || ref.segment >= int(it->second->segments.size()))
            continue;
        result.refs.push_back(ref);
        result.segments.push_back({it->second, &it->second->segments[std::size_t(ref.segment)]});
    }
    return result;
}

} // namespace suffuse
