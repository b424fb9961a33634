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

/// Mean of f over [a, b] by two Gauss points: for ranges so short that a difference of antiderivatives would cancel.
template <class V, class F>
SUFFUSE_INLINE V gaussMean(V a, V b, F f)
{
    const V middle = V(0.5) * (a + b), offset = V(0.28867513459481287) * (b - a);
    return V(0.5) * (f(middle - offset) + f(middle + offset));
}

/// Uniform colouring (17), F̃: zero below φ₀ = max(0, ξ1 − 8ξ2).
template <class V>
struct Uniform {
    V xi1, xi2, inverseXi2, phi0, f0, gain;

    SUFFUSE_INLINE Uniform(V x1, V x2)
        : xi1(x1), xi2(x2), inverseXi2(V(1) / x2), phi0(max_(V(0), x1 - V(8) * x2)),
          f0(V(1) / (V(1) + exp2_(V(log2e) * (x1 - phi0) * inverseXi2))), gain(V(1) / (V(1) - f0))
    {
    }
    SUFFUSE_INLINE V value(V phi) const
    {
        const V x = max_((xi1 - phi) * inverseXi2, V(-80));
        const V f = V(1) / (V(1) + exp2_(V(log2e) * min_(x, V(80))));
        return max_(V(0), (f - f0) * gain);
    }
    /// F is zero wherever φ and h are at most these.
    SUFFUSE_INLINE bool vanishes(V phi, V h) const { return phi + h <= phi0; }
    /// False only where the mean is exactly zero.
    SUFFUSE_INLINE auto visible(V phi, V h) const { return less_(phi0, phi + h); }
    /// ln(1 + e^x)
    static SUFFUSE_INLINE V softplus(V x)
    {
        return max_(x, V(0)) + V(ln2) * log2_(V(1) + exp2_(V(-log2e) * min_(abs_(x), V(80))));
    }
    /// Mean over [φ − h, φ + h].
    SUFFUSE_INLINE V mean(V phi, V h) const
    {
        const V a = max_(phi - h, phi0), b = max_(phi + h, phi0);
        const V range = (b - a) * inverseXi2;
        const V inside = gaussMean(a, b, [this](V x) { return value(x); });
        const V x = (a - xi1) * inverseXi2;
        const V quotient = ((softplus(x + range) - softplus(x)) / max_(range, V(1e-30)) - f0) * gain;
        const V f = select_(less_(range, V(0.6)), inside, quotient);
        // Part of [φ − h, φ + h] that lies above φ₀; 1 also where h is 0.
        const V share = select_(less_(phi - h, phi0), (b - a) / max_(V(2) * h, V(1e-30)), V(1));
        return select_(less_(V(16), x), V(1), min_(V(1), max_(V(0), f * share)));
    }
};

/// Feathering (18): min(1, (φ/ξ1)^ξ2); zero where it is below 2⁻¹³ over the whole pixel, so that it ends somewhere.
template <class V>
struct Feathering {
    V xi1, xi2, inverseXi1, cut;

    SUFFUSE_INLINE Feathering(V x1, V x2)
        : xi1(x1), xi2(x2), inverseXi1(V(1) / x1), cut(x1 * exp2_(max_(V(-13) / x2, V(-100))))
    {
    }
    SUFFUSE_INLINE bool vanishes(V phi, V h) const { return phi + h <= cut; }
    SUFFUSE_INLINE auto visible(V phi, V h) const { return less_(cut, phi + h); }
    static SUFFUSE_INLINE V power(V x, V p) { return exp2_(max_(V(-120), p * log2_(max_(x, V(1e-36))))); }

    SUFFUSE_INLINE V mean(V phi, V h) const
    {
        // In x = φ/ξ1 the range [a, a + range] has a part below 0 (F = 0), one in [0, 1] (the power), one above (F = 1).
        const V a = (phi - h) * inverseXi1, range = max_(V(2) * h * inverseXi1, V(1e-30));
        const V toZero = min_(V(1), max_(V(0), (V(0) - a) / range));
        const V toOne = min_(V(1), max_(V(0), (V(1) - a) / range));
        const V a1 = min_(max_(a, V(0)), V(1)), b1 = min_(max_((phi + h) * inverseXi1, V(0)), V(1));
        const V inside = gaussMean(a1, b1, [this](V x) { return power(x, xi2); });
        const V p1 = xi2 + V(1);
        const V low = select_(less_(V(0), a1), power(a1, p1), V(0));
        const V quotient = (power(b1, p1) - low) / (p1 * max_(b1 - a1, V(1e-30)));
        const V mean = select_(less_((b1 - a1) * max_(p1, V(2)), V(0.5) * b1), inside, quotient);
        const V f = min_(V(1), max_(V(0), (toOne - toZero) * mean + (V(1) - toOne)));
        return select_(less_(cut, phi + h), f, V(0));
    }
};

/// Edge darkening (19), in v = ln(φ/φ_e): F = ξ3(α e^(−6v) − β e^(−3v) + 1) for v ≥ 0, else 0.
template <class V>
struct Edge {
    V xi3, phiE, alpha, beta;

    SUFFUSE_INLINE Edge(V x1, V x2, V x3) : xi3(x3)
    {
        // With r = (ξ2/ξ1)³: (ξ1/φ_e)³ = (r + √(r² + 4(1/ξ3 − 1)))/2.
        const V ratio = x2 / x1, r = ratio * ratio * ratio;
        const V q = V(0.5) * (r + sqrt_(r * r + V(4) * (V(1) / x3 - V(1))));
        alpha = q * q;
        beta = r * q;
        phiE = x1 * exp2_(V(-1.0 / 3) * log2_(max_(q, V(1e-30))));
    }
    /// At most e² = 7.39 times the density counts (q ≤ 2).
    SUFFUSE_INLINE auto visible(V phi, V) const { return less_(phiE, V(7.5) * phi); }
    /// φ e^min(h/φ, 2) ≤ φ_e for all φ, h up to these: it is greatest at the ends of the range, or where h/φ = 2.
    SUFFUSE_INLINE bool vanishes(V phi, V h) const
    {
        const V atEnd = phi * exp2_(V(log2e) * min_(V(2), h / max_(phi, V(1e-36))));
        return atEnd <= phiE && V(7.38905609893065) * min_(phi, V(0.5) * h) <= phiE;
    }
    SUFFUSE_INLINE V value(V v) const
    {
        const V e = exp2_(V(-3 * log2e) * min_(v, V(20)));
        return xi3 * ((alpha * e - beta) * e + V(1));
    }
    /// Mean over u ∈ [ln φ − q, ln φ + q], q = min(h/φ, 2).
    SUFFUSE_INLINE V mean(V phi, V h) const
    {
        const V p = max_(phi, V(1e-36));
        const V v = V(ln2) * log2_(p / phiE), q = min_(h / p, V(2));
        const V a = max_(v - q, V(0)), b = max_(v + q, V(0)), range = b - a;
        const V inside = gaussMean(a, b, [this](V x) { return value(x); });
        const V ea = exp2_(V(-3 * log2e) * min_(a, V(20))), eb = exp2_(V(-3 * log2e) * min_(b, V(20)));
        const V quotient =
            xi3 * (V(1) + ((ea - eb) * (V(1.0 / 6) * alpha * (ea + eb) - V(1.0 / 3) * beta)) / max_(range, V(1e-30)));
        const V f = select_(less_(range, V(0.1)), inside, quotient);
        const V share = select_(less_(v, q), range / max_(V(2) * q, V(1e-30)), V(1));
        const V whole = select_(less_(v, V(0)), select_(less_(V(0), range), V(1), V(0)), V(1));
        return whole * min_(V(1), max_(V(0), f * min_(share, V(1))));
    }
};

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
