// Moving strokes under a brush: pushed, combed, pinched, roughened.
#pragma once

#include "model/shaping/reshape.h"

namespace suffuse {

enum class TweakKind {
    Push,    ///< along with the brush
    Comb,    ///< curves turn into the direction in which the brush goes
    Pinch,   ///< towards the middle of the brush, or away from it
    Roughen, ///< this way and that
};

/// One touch of the brush. All of it fades from the middle to the edge of the circle as (1 − ρ²)².
struct Tweak {
    TweakKind kind = TweakKind::Push;
    Point centre;      ///< canvas units
    double radius = 1; ///< canvas units
    Point by;          ///< Push: how far; Comb: the direction. A push is shorter than half the radius, or curves fold
    double share =
        1; ///< Comb: of the angle; Pinch: of the way to the middle, below 0 away from it; Roughen: of the radius
    unsigned seed = 0; ///< Roughen: another one gives other moves, the same one the same
};

/// The stroke after a touch; none where the circle does not reach it. Segments under the circle that are too long to
/// follow are split first, exactly. Nodes and handles move with the plane around them, so that curves stay smooth where
/// they are. Values, times and kinds of nodes stay. `sources`: for each segment of the result, the index of that it
/// came from.
std::optional<Stroke> tweaked(const Stroke &stroke, const Tweak &tweak, std::vector<int> *sources = nullptr);

} // namespace suffuse
