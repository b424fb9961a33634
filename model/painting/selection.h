#pragma once

#include "model/painting/ids.h"

#include <set>
#include <vector>

namespace suffuse {

/// One segment of one stroke.
struct SegmentRef {
    StrokeId stroke = 0;
    int segment = 0; ///< index
    friend auto operator<=>(const SegmentRef &, const SegmentRef &) = default;
};

/// Selected strokes, and within them selected segments. A selected segment's stroke is selected too; a selected stroke
/// without selected segments means the whole stroke.
struct Selection {
    std::set<StrokeId> strokes;
    std::set<SegmentRef> segments;
    friend bool operator==(const Selection &, const Selection &) = default;

    bool isEmpty() const { return strokes.empty(); }
    void clear() { strokes.clear(), segments.clear(); }
};

} // namespace suffuse
