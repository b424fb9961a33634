// How a value runs along a stroke, as a curve with few points.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// The mean of several runs at `count` ≥ 2 places, evenly spread over [0, 1]. Each run is a list of places (x, in
/// order) with a value (y); between them it goes straight on, and before the first and behind the last it stays level.
/// Empty runs do not count; without any the result is 0 all along.
std::vector<Point> sampledProfile(const std::vector<std::vector<Point>> &runs, int count);

/// The fewest of the points, ends included, from which the lines between them go past none of the others by more than
/// `tolerance`, as far as halving finds them (Douglas and Peucker, measured along y).
std::vector<Point> simplifiedProfile(const std::vector<Point> &points, double tolerance);

} // namespace suffuse
