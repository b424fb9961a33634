// Figures of a segment as if it were long and straight.
#pragma once

#include "model/paint/half_width.h"

#include <optional>

namespace suffuse {

/// D along the curve of a segment and across it, in the middle of the segment. They are equal where it spreads evenly.
struct CurveDiffusion {
    double along = 0;
    double across = 0;
};
CurveDiffusion curveDiffusion(const Segment &segment);

/// Figures of a long straight stroke of constant values, dried out.
struct DerivedFigures {
    double spread = 0;    ///< s = √(4 D t_max), units; across the curve
    double along = 0;     ///< the spread along the curve, units
    double peak = 0;      ///< pk = φˢ/(√π s)
    double halfWidth = 0; ///< w = s √ln(pk/cut), units; 0 where nothing is visible
    /// the age at which the peak falls below the cut, s; no value if the stroke stays visible
    std::optional<double> driesOut;
};
DerivedFigures derivedFigures(const Segment &segment, const Style &style);

/// Of a segment that makes paint paler: the share of the paint that it takes in the middle of a long straight erasure,
/// 1 − e^−pk.
double takenShare(const Segment &segment);
/// Gives it the density that takes this share, which is at most so much that nothing is left to be seen.
void setTakenShare(Segment &segment, double share);

} // namespace suffuse
