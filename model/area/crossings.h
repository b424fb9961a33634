// Where the arcs of an outline meet each other.
#pragma once

#include "model/area/area_effort.h"
#include "model/area/rising_arc.h"

#include <cstdint>
#include <utility>

namespace suffuse {

/// The arcs [first, end) of a closed loop, in its order.
struct LoopRange {
    std::uint32_t first = 0, end = 0;
};

/// A level way of a loop between two arcs, which are not told of it otherwise.
struct LevelWay {
    double y = 0, left = 0, right = 0;
};

struct Meetings {
    /// Heights in the inside of an arc at which another arc crosses it, begins or ends on it, or a level way meets it.
    std::vector<std::pair<std::uint32_t, double>> cuts;
    /// Whether another arc than its neighbour in the loop comes to where the loop comes to an arc or leaves it.
    struct Touched {
        bool begin = false, end = false;
    };
    std::vector<Touched> touched;
    double tolerance = 0; ///< places that are nearer to each other count as one
};

/// Arcs of this direction that are no farther from each other in x lie on each other. What is a tolerance across a
/// steep arc is more along a level line.
inline double nearness(double dx, double dy, double tolerance)
{
    return tolerance * (1 + (dy > 0 ? std::min(std::abs(dx) / dy, 1e6) : 0));
}

Meetings meetingsOf(const std::vector<RisingPart> &parts, const std::vector<LoopRange> &loops,
                    const std::vector<LevelWay> &levels, AreaEffort *effort = nullptr);

} // namespace suffuse
