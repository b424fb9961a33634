// Makes strokes of fewer segments, for nearly the same picture.
#pragma once

#include "model/shaping/nodes/reshape.h"

namespace suffuse {

/// How much a simplified stroke may differ from what it was.
struct SimplifyTolerance {
    double distance = 0.5; ///< the distance of the curves, canvas units
    /// How far apart the values that become one value may lie: spreads, peak densities, drying times and ξ relative to
    /// themselves; ω, colour and opacity absolutely; births relative to the drying time, or
    /// to a sixth of the time in which the stroke is painted, without its pauses, if that is longer.
    double values = 0.3;
};

/// The stroke with each run of similar segments made one cubic, by least squares, with the curve's own direction where
/// two meet. Corners, ends of chains, segments that take paint away, and changes of style or rewetting stay between two
/// segments. A merged segment has means by length, the run's total paint ∫φˢ dl, and its earliest birth. `chosen` says
/// for each segment whether it may be merged; if it is empty, all may. `sources` gets, for each segment of the result,
/// the index of the first segment that it came from. What is not merged keeps its bits.
Stroke simplified(const Stroke &stroke, const SimplifyTolerance &tolerance, const std::vector<bool> &chosen = {},
                  std::vector<int> *sources = nullptr);

} // namespace suffuse
