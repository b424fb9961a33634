// Straightening curves, and moving them sideways.
#pragma once

#include "model/shaping/runs.h"

namespace suffuse {

/// The chosen segments (`runsOf`) moved towards the chord of their run, each point to where it lies on the chord by its
/// share of the arc length: `share` 0 leaves the curve, 1 makes it straight. Ends, values and times stay.
Stroke straightened(const Stroke &stroke, double share, const std::vector<bool> &chosen = {});

/// The chosen segments moved sideways by a distance in canvas units, to the right of the stroke's direction where it is
/// positive (y points down). A curve is split where it turns much, so that the offset is right to about a hundredth of
/// the distance; corners are mitred. Where a run is a part of a chain, the way aside grows from its ends. `sources`:
/// for each segment of the result, the index of that it came from. Values and times stay.
Stroke offsetAside(const Stroke &stroke, double distance, const std::vector<bool> &chosen = {},
                   std::vector<int> *sources = nullptr);

} // namespace suffuse
