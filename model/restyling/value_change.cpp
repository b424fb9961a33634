#include "model/restyling/value_change.h"

#include "model/painting/editable.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

/// A stroke as it is and as it was.
struct StrokeTwice {
    const Stroke *now = nullptr;
    const Stroke *before = nullptr;
};

std::unordered_map<StrokeId, StrokeTwice> strokesTwice(const Painting &now, const Painting &before,
                                                       const std::vector<SegmentRef> &segments)
{
    std::unordered_map<StrokeId, StrokeTwice> found;
    for (const SegmentRef &ref : segments)
        found.try_emplace(ref.stroke);
    for (const StrokePtr &stroke : now.strokes)
        if (const auto it = found.find(stroke->id); it != found.end())
            it->second.now = stroke.get();
    for (const StrokePtr &stroke : before.strokes)
        if (const auto it = found.find(stroke->id); it != found.end())
            it->second.before = stroke.get();
    return found;
}

} // namespace

double ValueChange::applied(double value) const
{
    if (amount == neutral(kind))
        return value;
    // A value that is beyond the bounds already is not brought back by a change that has nothing to do with them.
    const double low = std::min(least, value), high = std::max(greatest, value);
    return std::clamp(kind == Scale ? value * amount : value + amount, low, high);
}

bool isChangedBy(const Painting &now, const Painting &before, const std::vector<SegmentRef> &segments,
                 const std::function<float(const Segment &)> &valueOf, const ValueChange &change)
{
    const std::unordered_map<StrokeId, StrokeTwice> strokes = strokesTwice(now, before, segments);
    const Locks isLocked(now.groups);
    return std::ranges::all_of(segments, [&](const SegmentRef &ref) {
        const StrokeTwice &stroke = strokes.at(ref.stroke);
        const auto k = std::size_t(ref.segment);
        if (!stroke.now || !stroke.before || stroke.now->segments.size() != stroke.before->segments.size() ||
            k >= stroke.now->segments.size())
            return false;
        const double was = double(valueOf(stroke.before->segments[k]));
        return isLocked(*stroke.now) || valueOf(stroke.now->segments[k]) == float(change.applied(was));
    });
}

} // namespace suffuse
