// Fewer segments for nearly the same picture.
#pragma once

#include "model/shaping/reshape.h"

namespace suffuse {

/// How much a simplified stroke may differ from what it was.
struct SimplifyTolerance {
    double distance = 0.5; ///< of the curves, canvas units
    /// How far the values that become one value may lie apart: spreads, peak densities, drying times and ξ as a share
    /// of themselves; ω, colour and opacity as they are; births as a share of the drying time.
    double values = 0.3;
};

/// The stroke with runs of its segments made one cubic each: by least squares, with the curve's own direction where
/// they meet. Corners, chains, what takes paint away, styles and rewetting stay apart. A merged segment has means by
/// length, the run's total paint ∫φˢ dl, and the run's earliest birth. `chosen`: for each segment whether it may be
/// merged; empty: all may. `sources`: for each segment of the result, the index of the first that it came from. What
/// is not merged keeps its bits.
Stroke simplified(const Stroke &stroke, const SimplifyTolerance &tolerance, const std::vector<bool> &chosen = {},
                  std::vector<int> *sources = nullptr);

} // namespace suffuse
