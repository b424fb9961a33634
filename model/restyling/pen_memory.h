// What a stroke remembers of the pen that painted it. Pressure is not stored, but what it did is: it is read off the
// values of the segments by the curves of the brush that painted them.
#pragma once

#include "model/brush/brush.h"
#include "model/painting/stroke.h"

#include <vector>

namespace suffuse {

/// The pen at the middle of a segment.
struct RememberedPen {
    double pressure = 1; ///< [0, 1]; where the stroke is strongest it is 1
    double speed = 0;    ///< canvas units a second, by the times at which the segments were born
    double distance = 0; ///< arc length since the stroke's start, canvas units
    double rest = 0;     ///< arc length to its end, canvas units
};

/// What strokes of one brush lay down where they are strongest. Their pressures count from it, so that of strokes which
/// are looked at together the stronger one keeps the greater pressure.
struct StrongestPaint {
    double size = 0;    ///< √D
    double peak = 0;    ///< peak of a long line's density
    double opacity = 0; ///< of the colour

    /// Takes a stroke into account. `painted` is the brush that painted it; null if it is not known.
    void take(const Stroke &stroke, const Brush *painted);
};

/// The pen at each segment of a stroke. Where the brush is known and listens to pressure, its curves say which pressure
/// gives these sizes, densities and opacities, after what speed, distance and tapering did is taken off. Else pressure
/// is the density φˢ as a share of the strongest, and 1 along a stroke that is even.
std::vector<RememberedPen> penOf(const Stroke &stroke, const Brush *painted, const StrongestPaint &strongest);

} // namespace suffuse
