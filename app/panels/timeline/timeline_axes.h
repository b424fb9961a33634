// Where moments and lanes lie on the Timeline.
#pragma once

#include "model/document/timelapse.h"

#include <cmath>

namespace suffuse {

/// Time runs from left to right, lanes from top to bottom. Units are logical pixels of the viewport.
struct TimelineAxes {
    static constexpr double laneHeight = 14, laneGap = 3;

    Microseconds from = 0; ///< the moment at the left edge
    double scale = 10'000; ///< microseconds a pixel
    int rulerHeight = 0;
    int scrolled = 0; ///< logical pixels of lanes above the view

    double xOf(Microseconds time) const { return double(time - from) / scale; }
    Microseconds timeAt(double x) const { return from + Microseconds(std::llround(x * scale)); }
    double laneTop(int lane) const { return rulerHeight + 4 + lane * (laneHeight + laneGap) - scrolled; }
    int laneAt(double y) const { return int(std::floor((y - laneTop(0)) / (laneTop(1) - laneTop(0)))); }
};

} // namespace suffuse
