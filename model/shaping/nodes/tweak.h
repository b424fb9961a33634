// Moves strokes under a brush: pushes, combs, pinches or roughens them.
#pragma once

#include "model/shaping/nodes/reshape.h"

namespace suffuse {

enum class TweakKind {
    Push,    ///< Curves move along with the brush.
    Comb,    ///< Curves turn into the direction in which the brush moves.
    Pinch,   ///< Curves move towards the middle of the brush, or away from it.
    Roughen, ///< Curves move to and fro at random.
};

/// One touch of the brush. Its effect fades from the middle to the edge of the circle as (1 − ρ²)².
struct Tweak {
    TweakKind kind = TweakKind::Push;
    Point centre;      ///< canvas units
    double radius = 1; ///< canvas units
    /// Push: how far; Comb: the direction. A push must be shorter than half the radius, or curves fold.
    Point by;
    /// How strong the touch is. Comb: share of the angle; Pinch: share of the way to the middle, below 0 away from it;
    /// Roughen: share of the radius.
    double share = 1;
    unsigned seed = 0; ///< Roughen: each seed gives other moves, and always the same ones.
};

/// Touches a stroke, in place. Returns false, and leaves it as it is, where the circle does not reach it. Segments
/// under the circle that are too long to follow are first split, exactly. Nodes and handles move with the plane around
/// them, so that smooth curves stay smooth. Values, times and kinds of nodes stay. `sources` gets, for each segment of
/// the result, the index of the segment that it came from; nothing if none is split.
bool tweak(Stroke &stroke, const Tweak &tweak, std::vector<int> *sources = nullptr);

/// The stroke after a touch; no value where the circle does not reach it. `sources` gets an index for each segment.
std::optional<Stroke> tweaked(const Stroke &stroke, const Tweak &tweak, std::vector<int> *sources = nullptr);

} // namespace suffuse
