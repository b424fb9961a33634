// A cut across a stroke, for panels: quick, and exact to a thousandth of the peak. It is never used for pictures.
#pragma once

#include "model/painting/painting.h"

#include <array>
#include <vector>

namespace suffuse {

/// The values of a stroke at one distance from its curve.
struct CrossSectionPoint {
    double offset = 0;           ///< distance across the curve, units
    double density = 0;          ///< φ
    double opacity = 0;          ///< w (21), without the paper's texture
    std::array<double, 3> rgb{}; ///< the stroke mixed onto the background, sRGB-encoded
};

/// The values across the middle of a segment, from one side to the other, with all segments of its stroke counted.
/// Empty where the segment is not there yet.
std::vector<CrossSectionPoint> crossSectionOf(const Painting &painting, const Stroke &stroke, int segment,
                                              Microseconds time, int samples);

} // namespace suffuse
