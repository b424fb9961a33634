// Straightening curves, and moving them sideways.
#pragma once

#include "model/shaping/curves/runs.h"

namespace suffuse {

/// Moves the chosen segments (see `runsOf`) towards the chord of their run. Each point moves to the place on the chord
/// that its share of the arc length gives: `share` 0 leaves the curve as it is, 1 makes it straight. A run has a chord
/// from each of its corners to the next one. Corners, ends of runs, values and times stay.
Stroke straightened(const Stroke &stroke, double share, const std::vector<bool> &chosen = {});

/// Moves the chosen segments sideways by a distance in canvas units, to the right of the stroke's direction where it is
/// positive (y points down). A curve that turns much is split, so that the offset is right to about a hundredth of the
/// distance; corners are mitred. If a run is a part of a chain, the offset grows from its ends. `sources` gets, for
/// each segment of the result, the index of the segment that it came from. Values and times stay.
Stroke offsetAside(const Stroke &stroke, double distance, const std::vector<bool> &chosen = {},
                   std::vector<int> *sources = nullptr);

} // namespace suffuse
