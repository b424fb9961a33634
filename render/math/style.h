// Density to opacity: styles (eq 17-19) and the closed-form mean of F over a pixel. docs/solver.md derives it.
#if defined(SUFFUSE_RENDER_MATH_STYLE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_STYLE_H
#undef SUFFUSE_RENDER_MATH_STYLE_H
#else
#define SUFFUSE_RENDER_MATH_STYLE_H
#endif

#include "render/math/compat.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

inline constexpr double log2e = 1.4426950408889634;
inline constexpr double ln2 = 0.6931471805599453;

// A pixel shows the mean of F over densities φ ± h. Over a short range that is a Taylor series about φ, in h² alone
// (odd terms cancel); over a long one a difference of antiderivatives. Each sample takes its own form, so that its
// value does not depend on its neighbours; a form that no sample needs is left out.
//
// Each style has: level(): F is zero where the whole range lies below (`vanishes`, shade_params.h); seen(φ, h²): false
// only where the mean is exactly zero; simple(φ, h²): simpleMean suffices; simpleMean(φ, h²): zero for φ = 0;
// longMean(φ, h). Where many samples are in turn, simpleMean = finish(begin(φ), φ, h²) in two passes is faster: half of
// it fits a processor's window several times, the whole waits for its own results.

template <class Style, class V>
SUFFUSE_INLINE V meanOf(const Style &style, V phi, V h2)
{
    const auto simple = style.simple(phi, h2), seen = style.seen(phi, h2);
    const V f = style.simpleMean(phi, h2);
    return select_(seen, all_(simple) ? f : select_(simple, f, style.longMean(phi, sqrt_(h2))), V(0));
}

/// 1 for NaN, which is ∞·0 where a range lies so far above ξ1 that its square overflows.
template <class V>
SUFFUSE_INLINE V clamp01(V x)
{
    return max_(min_(x, V(1)), V(0));
}

/// h < a, from h².
template <class V>
SUFFUSE_INLINE auto below_(V h2, V a)
{
    const V positive = max_(a, V(0));
    return less_(h2, positive * positive);
}

/// The same where paint may be lifted (`lifted`: as in Modulated). Only the mean of a style with a rim depends on it.
template <class Style, class V>
SUFFUSE_INLINE V meanWhere(const Style &style, V phi, V h2, V)
{
    return meanOf(style, phi, h2);
}

/// Uniform colouring (17), F̃: zero below φ₀ = max(0, ξ1 − 8ξ2). F̃ = gain·f − loss, with f₀ = loss/gain.
template <class V>
struct Uniform {
    V xi1, xi2, inverseXi2, phi0, loss, gain, slope, offset, shortLimit, reachesZero, fullFrom;

    SUFFUSE_INLINE Uniform(V x1, V x2)
        : xi1(x1), xi2(x2), inverseXi2(V(1) / x2), phi0(max_(V(0), x1 - V(8) * x2)),
          loss(exp2_(V(-log2e) * (x1 - phi0) * inverseXi2)), gain(V(1) + loss), slope(V(-log2e) * inverseXi2),
          offset(V(log2e) * xi1 * inverseXi2), shortLimit(V(0.64) * x2 * x2),
          reachesZero(select_(less_(V(0), phi0), V(1e36), V(0))), fullFrom(x1 + V(10) * x2)
    {}
    SUFFUSE_INLINE V level() const { return phi0; }
    SUFFUSE_INLINE auto seen(V phi, V h2) const
    {
        return or_(less_(phi0, phi), less_((phi0 - phi) * (phi0 - phi), h2));
    }
    /// Full: 1 − F < 5e-5 throughout; the series is that near then, too. Short: h < 0.8 ξ2, and above φ = 0; φ₀ may lie
    /// in the range, F is flat there (less than 7e-5 is lost).
    SUFFUSE_INLINE auto simple(V phi, V h2) const
    {
        const auto isShort = less_(h2, min_(shortLimit, mulAdd_(phi, phi, reachesZero)));
        return or_(or_(isShort, below_(h2, phi - fullFrom)), not_(seen(phi, h2)));
    }
    SUFFUSE_INLINE V simpleMean(V phi, V h2) const { return finish(begin(phi), phi, h2); }
    SUFFUSE_INLINE V begin(V phi) const { return exp2_(mulAdd_(phi, slope, offset)); }
    SUFFUSE_INLINE V finish(V begun, V, V h2) const
    {
        return clamp01(shortMean(begun, h2 * (inverseXi2 * inverseXi2)));
    }
    SUFFUSE_INLINE V longMean(V phi, V h) const
    {
        const auto scaled = [this](V density) { return min_((max_(density, phi0) - xi1) * inverseXi2, V(1e37)); };
        const V a = scaled(phi - h), b = scaled(phi + h), range = b - a, half = V(0.5) * range;
        // ln(1 + e^x) = max(x, 0) + ln(1 + e^−|x|)
        const V ea = exp2_(V(-log2e) * abs_(a)), eb = exp2_(V(-log2e) * abs_(b));
        const V softplus = max_(b, V(0)) - max_(a, V(0)) + V(ln2) * log2_((V(1) + eb) * reciprocal_(V(1) + ea));
        const auto wide = less_(V(0.8), half); // else the range ends near φ₀, and the difference would cancel
        V sum = negMulAdd_(range, loss, softplus * gain);
        if (!all_(wide))
            sum = select_(wide, sum, shortMean(exp2_(V(-log2e) * (a + half)), half * half) * range);
        return clamp01(sum * xi2 * reciprocal_(max_(V(2) * h, V(1e-30))));
    }

private:
    /// Of (f − f₀)/(1 − f₀) over x ± q, to fourth order in q: the sixth is below 1.4e-5. `power`: e^−x. Less 2e-7, so
    /// that nothing is left below φ₀.
    SUFFUSE_INLINE V shortMean(V power, V q2) const
    {
        const V f = reciprocal_(V(1) + power), rest = V(1) - f, g = f * rest;
        // f″ = g (1 − 2f), f⁗ = f″ (1 − 12 g)
        const V fourth = mulAdd_(q2 * V(1.0 / 20), mulAdd_(V(-12), g, V(1)), V(1));
        const V series = mulAdd_(q2 * V(1.0 / 6) * (g * (rest - f)), fourth, f);
        return mulAdd_(series, gain, V(-2e-7) - loss);
    }
};

/// Feathering (18): min(1, (φ/ξ1)^ξ2); zero where it is below 2⁻¹³ over the whole pixel, so that it ends somewhere.
template <class V>
struct Feathering {
    V xi1, xi2, inverseXi1, cut, second, fourth, narrow;

    SUFFUSE_INLINE Feathering(V x1, V x2)
        : xi1(x1), xi2(x2), inverseXi1(V(1) / x1), cut(x1 * exp2_(max_(V(-13) / x2, V(-100)))),
          second(x2 * (x2 - V(1)) * V(1.0 / 6)), fourth(second * (x2 - V(2)) * (x2 - V(3)) * V(1.0 / 20)),
          narrow(V(0.8) / max_(x2, V(2)))
    {}
    SUFFUSE_INLINE V level() const { return cut; }
    SUFFUSE_INLINE auto seen(V phi, V h2) const { return or_(less_(cut, phi), less_((cut - phi) * (cut - phi), h2)); }
    /// Full: F = 1 throughout (the series is at least that). Short: h < 0.8 φ/max(ξ2, 2), and F < 1 throughout.
    SUFFUSE_INLINE auto simple(V phi, V h2) const
    {
        const auto isShort = and_(below_(h2, narrow * phi), below_(h2, xi1 - phi));
        return or_(or_(isShort, full(phi, h2)), not_(seen(phi, h2)));
    }
    SUFFUSE_INLINE V simpleMean(V phi, V h2) const { return finish(begin(phi), phi, h2); }
    SUFFUSE_INLINE V begin(V phi) const { return logarithm(phi * inverseXi1); }
    SUFFUSE_INLINE V finish(V begun, V phi, V h2) const
    {
        const V f = clamp01(shortMean(begun, phi * inverseXi1, h2 * (inverseXi1 * inverseXi1)));
        return select_(less_(V(0), phi), f, V(0));
    }
    /// The range has a part below 0 (F = 0), one in [0, ξ1] (the power), one above (F = 1).
    SUFFUSE_INLINE V longMean(V phi, V h) const
    {
        const V x = phi * inverseXi1, reach = h * inverseXi1, a = x - reach, range = max_(V(2) * reach, V(1e-30));
        const V toZero = clamp01((V(0) - a) / range), toOne = clamp01((V(1) - a) / range);
        const V a1 = clamp01(a), b1 = clamp01(x + reach), middle = V(0.5) * (a1 + b1), half = V(0.5) * (b1 - a1);
        const V p1 = xi2 + V(1), low = select_(less_(V(0), a1), power(a1, p1), V(0));
        const V quotient = (power(b1, p1) - low) / (p1 * max_(b1 - a1, V(1e-30)));
        const V mean =
            select_(less_(half, narrow * middle), shortMean(logarithm(middle), middle, half * half), quotient);
        return clamp01((toOne - toZero) * mean + (V(1) - toOne));
    }

private:
    SUFFUSE_INLINE auto full(V phi, V h2) const { return below_(h2, phi - xi1); }
    static SUFFUSE_INLINE V logarithm(V x) { return log2_(max_(x, V(1e-36))); }
    static SUFFUSE_INLINE V power(V x, V p) { return exp2_(p * logarithm(x)); }
    /// Of x^ξ2 over x ± half, `log`: log₂ x, to fourth order: the sixth is below 5e-5 for half/x < 0.8/max(ξ2, 2).
    SUFFUSE_INLINE V shortMean(V log, V x, V half2) const
    {
        const V r2 = half2 * reciprocal_(max_(x * x, V(1e-36)));
        return exp2_(xi2 * log) * mulAdd_(mulAdd_(fourth, r2, second), r2, V(1));
    }
};

/// Edge darkening (19), in v = ln(φ/φ_e): F = ξ3(α e^(−6v) − β e^(−3v) + 1) for v ≥ 0, else 0. The mean is taken over
/// v ± q, q = min(h/φ, 2).
template <class V>
struct Edge {
    V xi3, phiE, inversePhiE, alpha, beta;

    SUFFUSE_INLINE Edge(V x1, V x2, V x3) : xi3(x3)
    {
        // With r = (ξ2/ξ1)³: (ξ1/φ_e)³ = (r + √(r² + 4(1/ξ3 − 1)))/2.
        const V ratio = x2 / x1, r = ratio * ratio * ratio;
        const V q = V(0.5) * (r + sqrt_(r * r + V(4) * (V(1) / x3 - V(1))));
        alpha = q * q;
        beta = r * q;
        phiE = x1 * exp2_(V(-1.0 / 3) * log2_(max_(q, V(1e-30))));
        inversePhiE = V(1) / phiE;
    }
    SUFFUSE_INLINE V level() const { return phiE; }
    /// φ e^q > φ_e, by e^q ≤ 1/(1 − q) and e^q < 7.5. With p = φ/φ_e: p > 1 − h/φ.
    SUFFUSE_INLINE auto seen(V phi, V h2) const
    {
        const V p = phi * inversePhiE, a = p * (V(1) - p);
        const auto reached = less_(a * a, h2 * inversePhiE * inversePhiE);
        return or_(less_(V(1), p), and_(less_(V(1), V(7.5) * p), reached));
    }
    /// Short: φ − h > φ_e (then φ e^−q > φ_e) and q < 0.4.
    SUFFUSE_INLINE auto simple(V phi, V h2) const
    {
        return or_(and_(less_(h2, V(0.16) * phi * phi), below_(h2, phi - phiE)), not_(seen(phi, h2)));
    }
    SUFFUSE_INLINE V simpleMean(V phi, V h2) const { return finish(begin(phi), phi, h2); }
    SUFFUSE_INLINE V begin(V phi) const { return reciprocal_(max_(phi, V(1e-18))); }
    SUFFUSE_INLINE V finish(V inverse, V phi, V h2) const
    {
        return select_(less_(V(0), phi), clamp01(shortMean(phiE * inverse, h2 * inverse * inverse)), V(0));
    }
    SUFFUSE_INLINE V longMean(V phi, V h) const
    {
        const V p = max_(phi, V(1e-36)), v = V(ln2) * log2_(p * inversePhiE), q = min_(h / p, V(2));
        const V a = max_(v - q, V(0)), b = max_(v + q, V(0)), range = b - a, half = V(0.5) * range;
        const V ea = exp2_(V(-3 * log2e) * a), eb = exp2_(V(-3 * log2e) * b);
        const V quotient =
            xi3 * (V(1) + ((ea - eb) * (V(1.0 / 6) * alpha * (ea + eb) - V(1.0 / 3) * beta)) / max_(range, V(1e-30)));
        const V middle = exp2_(V(-log2e) * (a + half));
        const V f = select_(less_(range, V(0.1)), shortMean(middle, half * half), quotient);
        // Part of the range that lies inside; 1 also where q is 0.
        const V share = select_(less_(v, q), range / max_(V(2) * q, V(1e-30)), V(1));
        const V whole = select_(less_(v, V(0)), select_(less_(V(0), range), V(1), V(0)), V(1));
        return clamp01(whole * max_(V(0), f) * min_(share, V(1)));
    }

    /// The mean over φ ± h, not over v: for paint that is lifted, which ends in a density that falls through 0.
    SUFFUSE_INLINE V meanOverDensity(V phi, V h) const
    {
        const V reach = h * inversePhiE, p = phi * inversePhiE;
        const auto within = [](V t) { return min_(max_(t, V(1)), V(1e18)); };
        const V low = within(p - reach), top = within(p + reach), range = top - low;
        // The antiderivative ξ3(t + β/(2t²) − α/(5t⁵)), t = φ/φ_e, loses digits where the range is short.
        const V a = reciprocal_(low), b = reciprocal_(top), a2 = a * a, b2 = b * b;
        const V quotient =
            V(1) + (V(0.5) * beta * (b2 - a2) - V(0.2) * alpha * (b2 * b2 * b - a2 * a2 * a)) / max_(range, V(1e-30));
        const V middle = reciprocal_(V(0.5) * (low + top)), third = middle * middle * middle;
        const V f = mulAdd_(mulAdd_(alpha, third, V(0) - beta), third, V(1));
        // The second derivative's part: 42 α t⁻⁸ − 12 β t⁻⁵, times a 24th of the range's square.
        const V bend = third * middle * middle * mulAdd_(V(42) * alpha, third, V(-12) * beta);
        const V shortMean = mulAdd_(bend * range, range * V(1.0 / 24), f);
        const V mean = xi3 * select_(less_(range, V(0.06) * low), shortMean, quotient);
        const V share = clamp01(((p - V(1)) + reach) / max_(V(2) * reach, V(1e-30))); // of the pixel, inside the edge
        return clamp01(share * mean);
    }

private:
    /// The mean of e^(−kv) over v ± q is e^(−kv) sinh(kq)/(kq). `ratio`: e^−v.
    SUFFUSE_INLINE V shortMean(V ratio, V q2) const
    {
        const V e = ratio * ratio * ratio, z = V(9) * q2;
        return xi3 * mulAdd_(mulAdd_(alpha * e, sinhOver(V(4) * z), V(0) - beta * sinhOver(z)), e, V(1));
    }
    /// sinh(x)/x from x², to 6e-6 for x ≤ 2.4.
    static SUFFUSE_INLINE V sinhOver(V x2)
    {
        V s(1.0 / 39916800);
        for (const double c : {1.0 / 362880, 1.0 / 5040, 1.0 / 120, 1.0 / 6, 1.0})
            s = mulAdd_(s, x2, V(c));
        return s;
    }
};

/// Of the means over ln φ ± q and over φ ± h, where paint is lifted; the second counts the more the more is.
template <class V>
SUFFUSE_INLINE V blended(V overLogarithm, V overDensity, V lifted)
{
    const V between = mulAdd_(lifted, overDensity - overLogarithm, overLogarithm);
    return select_(less_(lifted, V(1)), between, overDensity);
}

/// Where paint is lifted the mean over φ ± h takes the place of that over ln φ ± q.
template <class V>
SUFFUSE_INLINE V meanWhere(const Edge<V> &style, V phi, V h2, V lifted)
{
    const V f = meanOf(style, phi, h2);
    if (all_(not_(less_(V(0), lifted))))
        return f;
    return blended(f, style.meanOverDensity(phi, sqrt_(h2)), lifted);
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
