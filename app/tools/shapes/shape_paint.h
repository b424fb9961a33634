// What shapes of all kinds have in common: paint in their outline, within it, or both.
#pragma once

#include "model/shaping/shapes.h"

namespace suffuse {

/// What of a shape is painted.
enum class ShapePaint { Outline, Fill, Both };

/// Logical pixels: what is shorter is a click and no drag.
inline constexpr double leastShapeDrag = 3;
/// Logical pixels around the first point of an outline in which a press closes it.
inline constexpr double closingReach = 8;

/// A stroke along curves with the values of a brush at full pressure; what is within spreads by at most half of the
/// width that there is. Null where nothing could be painted, as within a straight line.
StrokePtr paintedAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born,
                       ShapePaint paint);

} // namespace suffuse
