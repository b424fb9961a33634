// How much of a stroke is seen at a point, quickly: what hit tests ask thousands of times.
#pragma once

#include "model/painting/stroke.h"

namespace suffuse {

/// A stroke at a point.
struct SeenPaint {
    double opacity = 0; ///< w (21), on smooth paper, to about a hundredth of it
    int segment = -1;   ///< the one with the largest share of the density that is laid; -1: none reaches the point
};

/// Each curve counts as a few straight pieces, whose density has a closed form. `render/probe.h` has the exact figures.
SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point);

} // namespace suffuse
