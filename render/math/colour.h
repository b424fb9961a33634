// RYB to sRGB-encoded RGB (Sugita & Takahashi, with g′ = y + m; docs/solver.md) and mixing (eq 22, 23).
#if defined(SUFFUSE_RENDER_MATH_COLOUR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_COLOUR_H
#undef SUFFUSE_RENDER_MATH_COLOUR_H
#else
#define SUFFUSE_RENDER_MATH_COLOUR_H
#endif

#include "render/math/compat.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

template <class V>
struct Triple {
    V x, y, z;
};

/// White is RYB (0, 0, 0), black (1, 1, 1).
template <class V>
SUFFUSE_INLINE Triple<V> rgbFromRyb(V red, V yellow, V blue)
{
    const V white = min_(red, min_(yellow, blue)), black = min_(V(1) - red, min_(V(1) - yellow, V(1) - blue));
    const V r = red - white, y = yellow - white, b = blue - white;
    const V m = min_(y, b);
    const V r1 = r + y - m, g1 = y + m, b1 = V(2) * (b - m);
    const V before = max_(r, max_(y, b)), after = max_(r1, max_(g1, b1));
    // n = after/before; dividing by it keeps the greatest component. 0/0 counts as 1.
    const V scale = select_(less_(V(0), after), before / max_(after, V(1e-30)), V(1));
    const V zero(0), one(1);
    return {min_(one, max_(zero, r1 * scale + black)), min_(one, max_(zero, g1 * scale + black)),
            min_(one, max_(zero, b1 * scale + black))};
}

/// Alpha (22) is keep = 1; pigment (23) keep = 1 − β: B ← min(1, w·C + (1 − w·keep)·B).
template <class V>
SUFFUSE_INLINE V mixed(V backdrop, V colour, V w, V keep)
{
    return min_(V(1), mulAdd_(w, colour, negMulAdd_(w, keep, V(1)) * backdrop));
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
