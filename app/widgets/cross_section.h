// A cut across a stroke for panels: quick, to a thousandth of the peak. Pictures never come from here.
#pragma once

#include "model/painting/painting.h"

#include <array>
#include <vector>

namespace suffuse {

/// A stroke at one distance from its curve.
struct CrossSectionPoint {
    double offset = 0;           ///< across the curve, units
    double density = 0;          ///< φ
    double opacity = 0;          ///< w (21), without the paper's texture
    std::array<double, 3> rgb{}; ///< of the stroke mixed onto the background, sRGB-encoded
};

/// Across the middle of a segment, all segments of its stroke counted, from one side to the other; empty where the
/// segment is not there yet.
std::vector<CrossSectionPoint> crossSectionOf(const Painting &painting, const Stroke &stroke, int segment,
                                              Microseconds time, int samples);

} // namespace suffuse
