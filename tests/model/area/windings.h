// Winding numbers of closed loops, counted at points.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse::test {

/// The winding number at a point, by short straight pieces.
inline int windingAt(const std::vector<std::vector<Cubic>> &loops, Point x, int pieces = 400)
{
    int winding = 0;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &c : loop) {
            Point a = c.p[0];
            for (int i = 1; i <= pieces; ++i) {
                const Point b = i == pieces ? c.p[3] : c.at(double(i) / pieces);
                if ((a.y <= x.y) != (b.y <= x.y) && a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x) < x.x)
                    winding += a.y < b.y ? 1 : -1;
                a = b;
            }
        }
    return winding;
}

/// The distance from a point to the loops, roughly.
inline double distanceTo(const std::vector<std::vector<Cubic>> &loops, Point x)
{
    double least = 1e300;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &c : loop)
            for (int i = 0; i <= 100; ++i)
                least = std::min(least, length(c.at(i / 100.0) - x));
    return least;
}

} // namespace suffuse::test
