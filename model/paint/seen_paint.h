// How much of a stroke is seen at a point, quickly, for hit tests, which ask thousands of times.
#pragma once

#include "model/painting/stroke.h"

namespace suffuse {

/// A stroke is not seen at a point where its opacity w is less than this.
inline constexpr double visibleOpacity = 0.02;

/// What is seen of a stroke at a point.
struct SeenPaint {
    double density = 0; ///< φ (14)
    double opacity = 0; ///< w (21) on smooth paper, right to about a hundredth of it
    /// the segment with the largest share of the density that is laid; -1 if none reaches the point
    int segment = -1;
};

/// Computes it with a few straight pieces for each curve, whose density has a closed form. `render/probe.h` has the
/// exact figures.
SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point);

} // namespace suffuse
