// Keeps the selection of segments when strokes are reshaped.
#pragma once

#include "model/painting/selection.h"

namespace suffuse {

/// Removes a stroke's segments from the selection, and returns them.
inline std::set<SegmentRef> takeSegments(Selection &selection, StrokeId stroke)
{
    const auto first = selection.segments.lower_bound({stroke, 0});
    const auto last = selection.segments.lower_bound({stroke + 1, 0});
    std::set<SegmentRef> taken(first, last);
    selection.segments.erase(first, last);
    return taken;
}

/// Selects those segments of a stroke that came from selected ones. Segment k came from sources[k].
inline void remap(Selection &selection, StrokeId stroke, const std::vector<int> &sources)
{
    const std::set<SegmentRef> before = takeSegments(selection, stroke);
    if (before.empty())
        return;
    for (int k = 0; k < int(sources.size()); ++k)
        if (before.contains({stroke, sources[std::size_t(k)]}))
            selection.segments.insert({stroke, k});
}

} // namespace suffuse
