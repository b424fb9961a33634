// The four samples of a pixel of a calm density, told from sums at the centres around. docs/solver.md, "Four samples
// from one".
#if defined(SUFFUSE_RENDER_MATH_BENDS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_BENDS_H
#undef SUFFUSE_RENDER_MATH_BENDS_H
#else
#define SUFFUSE_RENDER_MATH_BENDS_H
#endif

#include "render/math/style.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

/// Sums at the centre of a pixel, per pixel.
template <class V>
struct Bent {
    V density, slopeX, slopeY; ///< φ, −½∂φ/∂x, −½∂φ/∂y
    V xx, xy, yy;              ///< ½∂²φ/∂x², ¼∂²φ/∂x∂y, ½∂²φ/∂y²
    V xxx, xxy, xyy, yyy;      ///< the third derivatives

    /// The same at the sample a quarter of a pixel to the right (`right` = 1, else −1) and down (`down` = 1).
    SUFFUSE_INLINE V densityAt(V right, V down) const
    {
        const V alongX = mulAdd_(V(3), xyy, xxx), alongY = mulAdd_(V(3), xxy, yyy);
        const V odd = mulAdd_(right, mulAdd_(V(-0.5), slopeX, V(1.0 / 384) * alongX),
                              down * mulAdd_(V(-0.5), slopeY, V(1.0 / 384) * alongY));
        return density + mulAdd_(V(1.0 / 16), xx + yy, mulAdd_(V(0.25) * right * down, xy, odd));
    }
    SUFFUSE_INLINE V slopeXAt(V right, V down) const
    {
        const V third = mulAdd_(V(2) * right * down, xxy, xxx + xyy);
        return slopeX - mulAdd_(V(0.25) * right, xx, mulAdd_(V(0.5) * down, xy, V(1.0 / 64) * third));
    }
    SUFFUSE_INLINE V slopeYAt(V right, V down) const
    {
        const V third = mulAdd_(V(2) * right * down, xyy, yyy + xxy);
        return slopeY - mulAdd_(V(0.25) * down, yy, mulAdd_(V(0.5) * right, xy, V(1.0 / 64) * third));
    }
};

template <class V>
struct Course {
    V change; ///< how much F′ changes; far above all others if F jumps
    V slope;  ///< |F′|, likewise
    V scale;  ///< F″ and all that follow change by their own size over this much density; 0 if they are not bounded
};
inline constexpr double jump = 1e9;

template <class V>
SUFFUSE_INLINE Course<V> courseOf(const Uniform<V> &style, V low, V high)
{
    const V distance = max_(max_(low - style.xi1, style.xi1 - high), V(0));
    const V decay = exp2_(max_(V(-log2e) * distance * style.inverseXi2, V(-100))) * style.inverseXi2;
    const V slope = V(0.25) * decay;
    return {min_(slope, V(0.0963) * decay * style.inverseXi2 * (high - low)), slope, style.xi2};
}

template <class V>
SUFFUSE_INLINE Course<V> courseOf(const Feathering<V> &style, V low, V high)
{
    const V one = V(1) - V(1e-6), power = style.xi2 - V(1), floor = V(1e-12), gain = style.xi2 * style.inverseXi1;
    const auto slopeAt = [&](V density) {
        const V x = min_(max_(density * style.inverseXi1, floor), one);
        return gain * exp2_(max_(min_(power * log2_(x), V(60)), V(-60)));
    };
    const V a = slopeAt(low), b = slopeAt(high), slope = max_(a, b);
    // Beyond 0 and ξ1 the slope is 0.
    const auto outside = or_(less_(low, V(1e-6) * style.xi1), less_(style.xi1, high)), full = less_(style.xi1, low);
    const V scale = low / max_(V(2), abs_(style.xi2 - V(2)));
    return {select_(full, V(0), select_(outside, slope, abs_(a - b))), select_(full, V(0), slope),
            select_(full, style.xi1, select_(outside, V(0), scale))};
}

template <class V>
SUFFUSE_INLINE Course<V> courseOf(const Edge<V> &style, V low, V high)
{
    const auto slopeAt = [&style](V density) {
        const V t = reciprocal_(max_(density * style.inversePhiE, V(1))), t3 = t * t * t;
        return style.xi3 * style.inversePhiE * t3 * t * mulAdd_(V(-6) * style.alpha, t3, V(3) * style.beta);
    };
    const V a = slopeAt(low), b = slopeAt(high);
    const auto jumps = less_(low, style.phiE);
    return {select_(jumps, V(jump), abs_(b - a)), select_(jumps, V(jump), max_(abs_(a), abs_(b))),
            select_(jumps, V(0), V(1.0 / 8) * low)};
}

/// The upper end of the range of a mean, for all densities up to this one.
template <class Style, class V>
SUFFUSE_INLINE V rangeTop(const Style &, V density, V half)
{
    return density + half;
}

/// φ e^min(h/φ, 2)
template <class V>
SUFFUSE_INLINE V rangeTop(const Edge<V> &, V density, V half)
{
    const V e2(7.3891), positive = max_(density, V(0));
    const V narrow = mulAdd_(V(0.65) * half, half * reciprocal_(max_(density, V(1e-30))), density + half);
    return max_(select_(less_(half, V(0.5) * density), narrow, e2 * positive),
                V(0.5) * e2 * min_(half, V(2) * positive));
}

/// How much the opacity of a pixel may differ if its samples are told from its centre.
template <class V>
struct Doubt {
    V four; ///< if each of the four is told
    V one;  ///< if one takes the place of all, whose density is raised by their mean rise
    V high; ///< a bound of what a sample shows of φ; F may be zero up to there
};

template <class V>
struct Range {
    V low, high;
};

/// `spread`: the least of all nodes', px; `gamma`: γ over the pixel.
template <class Style, class V>
SUFFUSE_INLINE Doubt<V> doubtAbout(const Style &style, const Bent<V> &at, V spread, Range<V> gamma)
{
    const V g = V(2) * sqrt_(mulAdd_(at.slopeX, at.slopeX, at.slopeY * at.slopeY));
    const V bend = mulAdd_(V(4), abs_(at.xy), V(2) * max_(abs_(at.xx), abs_(at.yy)));
    // Of a Gaussian φ‴ = −4φ′/s² − 2uφ″/s, and φ⁗ = −6φ″/s² − 2uφ‴/s.
    const V inverse = V(2) * reciprocal_(spread);
    const V third = inverse * mulAdd_(inverse, g, bend), fourth = inverse * mulAdd_(V(1.5) * inverse, bend, third);
    // A sample lies √⅛ px from the centre, and is linear over ¼|∇φ| to both sides. Of its density the terms up to the
    // third order are known, from differences.
    const V missed = V(4e-4) * fourth;
    const V away = mulAdd_(V(0.354), g, mulAdd_(V(0.063), bend, V(0.0074) * third));
    const V half = mulAdd_(V(0.25), g, mulAdd_(V(0.089), bend, V(0.016) * third));
    const V low = gamma.low * (at.density - away - half),
            high = rangeTop(style, gamma.high * (at.density + away), gamma.high * half);
    const Course<V> course = courseOf(style, low, high);
    // Where F jumps what is missed moves the place of the jump.
    const V shown = min_(course.slope, reciprocal_(max_(g, V(1e-30))));
    // The terms of fourth order of the mean, by F⁗, F‴, F″ and F′.
    const V over = reciprocal_(max_(course.scale, V(1e-30))), g2 = g * g;
    const V second = course.change * reciprocal_(max_(high - low, V(1e-30)));
    const V terms = mulAdd_(g2 * over, mulAdd_(V(1.6e-4) * g2, over, V(1.0 / 340) * bend),
                            mulAdd_(V(1.0 / 512) * g, third, V(1.0 / 600) * bend * bend));
    return {missed * shown, mulAdd_(second, terms, V(1.0 / 3072) * course.slope * fourth), high};
}

/// By how much the four samples rise above the density at the centre, on the average.
template <class Style, class V>
SUFFUSE_INLINE V riseOf(const Style &, const Bent<V> &at, V)
{
    return V(1.0 / 16) * (at.xx + at.yy);
}

/// Over ln φ a density is taken to grow like e^x already, as far as paint is not lifted.
template <class V>
SUFFUSE_INLINE V riseOf(const Edge<V> &, const Bent<V> &at, V lifted)
{
    const V g2 = V(4) * mulAdd_(at.slopeX, at.slopeX, at.slopeY * at.slopeY);
    return V(1.0 / 16) * (at.xx + at.yy) - V(1.0 / 32) * (V(1) - lifted) * g2 * reciprocal_(max_(at.density, V(1e-18)));
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
