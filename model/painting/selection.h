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

/// Selected strokes, and selected segments within them. The stroke of a selected segment is selected, too. A selected
/// stroke without selected segments is selected as a whole.
struct Selection {
    std::set<StrokeId> strokes;
    std::set<SegmentRef> segments;
    friend bool operator==(const Selection &, const Selection &) = default;

    bool isEmpty() const { return strokes.empty(); }
    void clear() { strokes.clear(), segments.clear(); }
};

} // namespace suffuse
