// Derivatives of colour.h, backwards: from those of a loss by what comes out to those by what goes in.
#if defined(SUFFUSE_RENDER_MATH_COLOUR_SLOPES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_COLOUR_SLOPES_H
#undef SUFFUSE_RENDER_MATH_COLOUR_SLOPES_H
#else
#define SUFFUSE_RENDER_MATH_COLOUR_SLOPES_H
#endif

#include "render/math/colour.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

/// ∂L/∂(R, Y, B) from ∂L/∂(R, G, B), at a colour. The function is linear in parts; where parts meet (greys, and colours
/// of which two components are the same) this takes one of them.
template <class V>
SUFFUSE_INLINE Triple<V> rybSlopes(V red, V yellow, V blue, const Triple<V> &by)
{
    const V zero(0), one(1), white = min_(red, min_(yellow, blue)), most = max_(red, max_(yellow, blue));
    const V r = red - white, y = yellow - white, b = blue - white, m = min_(y, b), before = most - white;
    const V r1 = r + y - m, g1 = y + m, b1 = V(2) * (b - m), after = max_(r1, max_(g1, b1));
    const auto coloured = less_(V(1e-20), after);
    const V inverse = one / max_(after, V(1e-20)), scale = select_(coloured, before * inverse, one);
    // (r1, g1, b1) · before/after + black
    const V byScale = select_(coloured, by.x * r1 + by.y * g1 + by.z * b1, zero), black = by.x + by.y + by.z;
    const V byBefore = byScale * inverse, byAfter = zero - byBefore * scale;
    const auto r1Most = not_(less_(r1, max_(g1, b1))), g1Most = not_(or_(r1Most, less_(g1, b1)));
    const V byR1 = mulAdd_(by.x, scale, select_(r1Most, byAfter, zero));
    const V byG1 = mulAdd_(by.y, scale, select_(g1Most, byAfter, zero));
    const V byB1 = mulAdd_(by.z, scale, select_(or_(r1Most, g1Most), zero, byAfter));
    const V byM = byG1 - byR1 - V(2) * byB1;
    const auto yellowLess = less_(y, b);
    const V byRed = byR1, byYellow = byR1 + byG1 + select_(yellowLess, byM, zero);
    const V byBlue = V(2) * byB1 + select_(yellowLess, zero, byM);
    // Black is 1 − the greatest component, and `before` that component less white.
    const V byMost = byBefore - black, byWhite = zero - (byBefore + byRed + byYellow + byBlue);
    const auto redMost = not_(less_(red, max_(yellow, blue))), yellowMost = not_(or_(redMost, less_(yellow, blue)));
    const auto redLeast = not_(less_(min_(yellow, blue), red)), yellowLeast = not_(or_(redLeast, less_(blue, yellow)));
    const auto share = [&](V own, decltype(redMost) isMost, decltype(redMost) isLeast) {
        return own + select_(isMost, byMost, zero) + select_(isLeast, byWhite, zero);
    };
    return {share(byRed, redMost, redLeast), share(byYellow, yellowMost, yellowLeast),
            share(byBlue, not_(or_(redMost, yellowMost)), not_(or_(redLeast, yellowLeast)))};
}

/// Derivatives of `mixed` for one channel.
template <class V>
struct MixSlopes {
    V byBackdrop, byColour, byOpacity;
};

/// From ∂L/∂B after mixing.
template <class V>
SUFFUSE_INLINE MixSlopes<V> mixSlopes(V backdrop, V colour, V w, V keep, V by)
{
    const V factor = negMulAdd_(w, keep, V(1)), sum = mulAdd_(w, colour, factor * backdrop);
    const V passed = select_(less_(V(1), sum), V(0), by);
    return {passed * factor, passed * w, passed * negMulAdd_(keep, backdrop, colour)};
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
