// Curves beside a curve.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A quarter turn from the x axis towards the y axis.
inline Point turnedBack(Point v)
{
    return {v.y, -v.x};
}
inline Point turned(Point v)
{
    return {-v.y, v.x};
}

/// A straight line as a cubic.
Cubic straightCubic(Point a, Point b);

/// The arc around `centre` that begins in `from` and turns by `angle` (radians, from x towards y; at most a full turn),
/// as cubics that are off by less than 1/3000 of its radius.
std::vector<Cubic> arcAround(Point centre, Point from, double angle);

/// Whether a curve turns by less than about 60° and nowhere as sharply as a circle of radius `distance`, so that the
/// curves at that distance on both sides are smooth and run the same way.
bool isGentle(const Cubic &curve, double distance);

/// Adds the curve at a signed distance from a gentle one, towards `turned` of its direction, within a tolerance.
void appendOffset(const Cubic &curve, double distance, double tolerance, std::vector<Cubic> &out);

} // namespace suffuse
