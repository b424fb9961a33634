// The mean of a style's F over a pixel (style.h), with its derivatives. docs/solver.md, "The gradient of the picture".
#if defined(SUFFUSE_RENDER_MATH_STYLE_SLOPES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_STYLE_SLOPES_H
#undef SUFFUSE_RENDER_MATH_STYLE_SLOPES_H
#else
#define SUFFUSE_RENDER_MATH_STYLE_SLOPES_H
#endif

#include "render/math/style.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

/// Holds M, the mean of F over φ ± h, and its derivatives. They are taken by h², not by h: h = ½γ|∇φ| has a kink where
/// the density is level, and h² has none.
template <class V>
struct MeanSlopes {
    V mean, byDensity, bySquare; ///< M, ∂M/∂φ, ∂M/∂h²
    V byXi[3];                   ///< ∂M/∂ξ; only if they were asked for
};

/// Says from where on differences of antiderivatives take the place of series, and where a tail ends. Where one form
/// takes the place of the other, M must not jump by more than its derivatives may be off by.
///
/// Doubles take each form where it is exact. In floats, where some samples of a vector need the difference, all of them
/// take it, over a range that is not shorter than `least`: there its digits are enough, and M changes by less than
/// 1e-5.
template <class V>
struct SlopeLimits {
    static constexpr bool exact = false;
    static constexpr double uniform = 0.5, leastUniform = 0.02;       // h/ξ2
    static constexpr double feathering = 0.4, leastFeathering = 0.02; // h/φ, times max(ξ2, 2)
    static constexpr double edge = 0.3, leastEdge = 0.01;             // h/φ
    static constexpr double full = 12;                                // (φ − h − ξ1)/ξ2 beyond which F is 1
    static constexpr double tail = 17;                                // −log₂ of the opacity at which a style ends
    static constexpr double nearZero = 1e-30;
};
template <>
struct SlopeLimits<double> {
    static constexpr bool exact = true;
    static constexpr double uniform = 0.03, leastUniform = 0;
    static constexpr double feathering = 0.03, leastFeathering = 0;
    static constexpr double edge = 0.1, leastEdge = 0;
    static constexpr double full = 40;
    static constexpr double tail = 40;
    static constexpr double nearZero = 1e-300;
};

/// Takes the series where all samples that count may have it, else the difference: for each sample that needs it, or
/// for all of them.
template <class V, class Short, class Long, class Select>
SUFFUSE_INLINE auto eitherForm(const decltype(less_(V(0), V(0))) &isShort, const decltype(less_(V(0), V(0))) &counts,
                               Short series, Long difference, Select select)
{
    if (all_(or_(isShort, not_(counts))))
        return series();
    if constexpr (SlopeLimits<V>::exact)
        return select(isShort, series(), difference());
    else
        return difference();
}

/// What a difference of antiderivatives A gives: `rise` is A(φ+h) − A(φ−h), `high` and `low` are F at both ends. M does
/// not depend on h where the range is that of a greater one.
template <class V>
SUFFUSE_INLINE MeanSlopes<V> slopesOfDifference(V rise, V low, V high, V half, V least)
{
    const V inverse = V(0.5) * reciprocal_(max_(half, V(1e-18))), mean = rise * inverse;
    const V bySquare = V(2) * inverse * inverse * (V(0.5) * (high + low) - mean);
    return {mean,
            (high - low) * inverse,
            SlopeLimits<V>::exact ? bySquare : select_(less_(least, half), bySquare, V(0)),
            {}};
}

template <class V>
SUFFUSE_INLINE MeanSlopes<V> select_slopes(const decltype(less_(V(0), V(0))) &which, const MeanSlopes<V> &a,
                                           const MeanSlopes<V> &b)
{
    return {select_(which, a.mean, b.mean),
            select_(which, a.byDensity, b.byDensity),
            select_(which, a.bySquare, b.bySquare),
            {select_(which, a.byXi[0], b.byXi[0]), select_(which, a.byXi[1], b.byXi[1]),
             select_(which, a.byXi[2], b.byXi[2])}};
}

/// Uniform colouring (17).
template <class V>
struct UniformSlopes {
    V xi1, xi2, inverse, start, loss, gain;
    V cut;    ///< opacity is below 2^−tail up to there
    V inLoss; ///< how f₀ changes with ξ1 where φ₀ = 0; else 0

    SUFFUSE_INLINE UniformSlopes(V x1, V x2, V)
        : xi1(x1), xi2(x2), inverse(V(1) / x2), start(max_(V(0), x1 - V(8) * x2)),
          loss(exp2_(V(-log2e) * (x1 - start) * inverse)), gain(V(1) + loss),
          cut(max_(start, x1 - x2 * V(ln2) * log2_(gain / (exp2_(V(-SlopeLimits<V>::tail)) + loss) - V(1)))),
          inLoss(select_(less_(V(0), x1 - V(8) * x2), V(0), loss * inverse / gain))
    {}
    SUFFUSE_INLINE auto seen(V phi, V h2) const { return or_(less_(cut, phi), less_((cut - phi) * (cut - phi), h2)); }
    /// True only where F is 1 over the whole range, but for less than anybody sees.
    SUFFUSE_INLINE auto full(V phi, V h2) const { return below_(h2, phi - mulAdd_(V(SlopeLimits<V>::full), xi2, xi1)); }
    template <bool xi>
    SUFFUSE_INLINE MeanSlopes<V> slopes(V phi, V h2) const
    {
        const V limit = V(SlopeLimits<V>::uniform) * xi2, room = max_(phi - start, V(0));
        const auto isShort = less_(h2, min_(limit * limit, room * room));
        MeanSlopes<V> m = eitherForm<V>(
            isShort, seen(phi, h2), [&] { return shortSlopes(phi, h2); }, [&] { return longSlopes(phi, h2); },
            [](const auto &which, const auto &a, const auto &b) { return select_slopes(which, a, b); });
        if (xi) {
            const V share = m.byXi[0];
            // M depends on φ − ξ1 but for f₀; and it stays if φ, h, ξ1 and ξ2 are multiplied by one number.
            m.byXi[0] = inLoss * (share - m.mean) - m.byDensity;
            m.byXi[1] = V(0) - (phi * m.byDensity + V(2) * h2 * m.bySquare + xi1 * m.byXi[0]) * inverse;
            m.byXi[2] = V(0);
        }
        return m;
    }

private:
    /// The mean over x ± q, x = (φ − ξ1)/ξ2, and its derivatives by x and q².
    struct Series {
        V mean, byX, bySquare;
    };
    /// From the derivatives of the logistic function f, which are polynomials in it.
    SUFFUSE_INLINE Series seriesAt(V x, V q2) const
    {
        const V f = logistic(x), rest = V(1) - f, g = f * rest, bend = g * (rest - f), g2 = g * g;
        const V third = g * mulAdd_(V(-6), g, V(1)), fourth = bend * mulAdd_(V(-12), g, V(1));
        const V fifth = g * (V(1) - V(30) * g + V(120) * g2), sixth = bend * (V(1) - V(60) * g + V(360) * g2);
        const V seventh = g * (V(1) - V(126) * g + V(1680) * g2 - V(5040) * g2 * g);
        const auto sum = [q2](V c0, V c2, V c4, V c6) { return mulAdd_(q2, mulAdd_(q2, mulAdd_(q2, c6, c4), c2), c0); };
        const V mean = sum(f, V(1.0 / 6) * bend, V(1.0 / 120) * fourth, V(1.0 / 5040) * sixth);
        const V byX = sum(g, V(1.0 / 6) * third, V(1.0 / 120) * fifth, V(1.0 / 5040) * seventh);
        const V bySquare = sum(V(1.0 / 6) * bend, V(1.0 / 60) * fourth, V(1.0 / 1680) * sixth, V(0));
        return {mulAdd_(mean, gain, V(0) - loss), gain * byX, gain * bySquare};
    }
    /// Instead of ∂M/∂ξ1 this and longSlopes give the share of the range that lies above φ₀.
    SUFFUSE_INLINE MeanSlopes<V> shortSlopes(V phi, V h2) const
    {
        const Series s = seriesAt((phi - xi1) * inverse, h2 * inverse * inverse);
        return {s.mean, s.byX * inverse, s.bySquare * inverse * inverse, {V(1), V(0), V(0)}};
    }
    SUFFUSE_INLINE MeanSlopes<V> longSlopes(V phi, V h2) const
    {
        // Where F bends, at φ₀, a longer range would blur it.
        const V room = max_(phi - start, V(0.05 * SlopeLimits<V>::leastUniform) * xi2);
        const V least = min_(V(SlopeLimits<V>::leastUniform) * xi2, room), h = max_(sqrt_(h2), least);
        const V low = max_(phi - h, start), high = max_(phi + h, start);
        const V a = (low - xi1) * inverse, b = (high - xi1) * inverse;
        const V ea = exp2_(V(-log2e) * abs_(a)), eb = exp2_(V(-log2e) * abs_(b));
        const V ra = reciprocal_(V(1) + ea), rb = reciprocal_(V(1) + eb);
        // ln(1 + e^x) = max(x, 0) + ln(1 + e^−|x|)
        const V softplus = max_(b, V(0)) - max_(a, V(0)) + V(ln2) * log2_((V(1) + eb) * ra);
        const V fa = select_(less_(a, V(0)), ea * ra, ra), fb = select_(less_(b, V(0)), eb * rb, rb);
        const V range = (high - low) * inverse, half = V(0.5) * range; // a and b have no digits for a short one
        V rise = negMulAdd_(range, loss, softplus * gain), top = mulAdd_(fb, gain, V(0) - loss);
        const V bottom = select_(less_(start, phi - h), mulAdd_(fa, gain, V(0) - loss), V(0));
        // A short range begins at φ₀, where F is 0, and differences would cancel.
        const auto wide = less_(V(SlopeLimits<V>::uniform), half);
        if (SlopeLimits<V>::exact && !all_(wide)) {
            const Series s = seriesAt(a + half, half * half);
            rise = select_(wide, rise, range * s.mean);
            top = select_(wide, top, range * s.byX);
        }
        MeanSlopes<V> m = slopesOfDifference(xi2 * rise, bottom, top, h, least);
        m.byXi[0] = (high - low) * V(0.5) * reciprocal_(max_(h, V(1e-18)));
        m.byXi[1] = m.byXi[2] = V(0);
        return m;
    }
    static SUFFUSE_INLINE V logistic(V x)
    {
        const V e = exp2_(V(-log2e) * abs_(x)), r = reciprocal_(V(1) + e);
        return select_(less_(x, V(0)), e * r, r);
    }
};

/// Feathering (18).
template <class V>
struct FeatheringSlopes {
    V xi1, xi2, inverse, cut, narrow, perPower; ///< the last: 1/(ξ2 + 1)
    V c2, c4, c6;                               ///< ξ2 (ξ2 − 1)/3!, … (ξ2 − 2)(ξ2 − 3)/5!, … /7!
    V d2, d4, d6;                               ///< their derivatives by ξ2

    SUFFUSE_INLINE FeatheringSlopes(V x1, V x2, V)
        : xi1(x1), xi2(x2), inverse(V(1) / x1), cut(x1 * exp2_(max_(V(-SlopeLimits<V>::tail) / x2, V(-100)))),
          narrow(V(SlopeLimits<V>::feathering) / max_(x2, V(2))), perPower(V(1) / (x2 + V(1))),
          c2(x2 * (x2 - V(1)) * V(1.0 / 6)), c4(c2 * (x2 - V(2)) * (x2 - V(3)) * V(1.0 / 20)),
          c6(c4 * (x2 - V(4)) * (x2 - V(5)) * V(1.0 / 42)), d2((V(2) * x2 - V(1)) * V(1.0 / 6)),
          d4((((V(4) * x2 - V(18)) * x2 + V(22)) * x2 - V(6)) * V(1.0 / 120)),
          d6((((((V(6) * x2 - V(75)) * x2 + V(340)) * x2 - V(675)) * x2 + V(548)) * x2 - V(120)) * V(1.0 / 5040))
    {}
    SUFFUSE_INLINE auto seen(V phi, V h2) const { return or_(less_(cut, phi), less_((cut - phi) * (cut - phi), h2)); }
    SUFFUSE_INLINE auto full(V phi, V h2) const { return below_(h2, phi - xi1); }
    template <bool xi>
    SUFFUSE_INLINE MeanSlopes<V> slopes(V phi, V h2) const
    {
        const V x = phi * inverse, room = max_(min_(narrow * x, V(1) - x), V(0)), r2 = h2 * inverse * inverse;
        const V above = max_(x - V(1), V(0));
        const auto isShort = less_(r2, room * room), isFull = less_(r2, above * above);
        MeanSlopes<V> m = eitherForm<V>(
            isShort, and_(seen(phi, h2), not_(isFull)), [&] { return shortSlopes<xi>(x, r2); },
            [&] { return longSlopes<xi>(x, r2); },
            [](const auto &which, const auto &one, const auto &other) { return select_slopes(which, one, other); });
        m = select_slopes(isFull, {V(1), V(0), V(0), {V(0), V(0), V(0)}}, m);
        m.byDensity = m.byDensity * inverse;
        m.bySquare = m.bySquare * inverse * inverse;
        if (xi) { // M stays if φ, h and ξ1 are multiplied by one number.
            m.byXi[0] = V(0) - (phi * m.byDensity + V(2) * h2 * m.bySquare) * inverse;
            m.byXi[2] = V(0);
        }
        return m;
    }

private:
    static SUFFUSE_INLINE V logarithm(V x) { return log2_(max_(x, V(SlopeLimits<V>::nearZero))); }
    template <bool xi>
    SUFFUSE_INLINE MeanSlopes<V> shortSlopes(V x, V r2) const
    {
        const V log = logarithm(x), over = reciprocal_(max_(x, V(1e-18))), f = exp2_(xi2 * log);
        const V q2 = min_(r2 * over * over, V(1)), slope = f * over;
        MeanSlopes<V> m{
            f * mulAdd_(q2, mulAdd_(q2, mulAdd_(q2, c6, c4), c2), V(1)),
            slope * mulAdd_(q2, mulAdd_(q2, mulAdd_(q2, c6 * (xi2 - V(6)), c4 * (xi2 - V(4))), c2 * (xi2 - V(2))), xi2),
            slope * over * mulAdd_(q2, mulAdd_(q2, V(3) * c6, V(2) * c4), c2),
            {V(0), V(0), V(0)}};
        if (xi)
            m.byXi[1] = mulAdd_(V(ln2) * log, m.mean, f * q2 * mulAdd_(q2, mulAdd_(q2, d6, d4), d2));
        return m;
    }
    /// The range has a part below 0 (F = 0), one in [0, ξ1] (the power), one above (F = 1).
    template <bool xi>
    SUFFUSE_INLINE MeanSlopes<V> longSlopes(V x, V r2) const
    {
        // Where F bends, at x = 1, a longer range would blur it.
        const V usual = V(SlopeLimits<V>::leastFeathering / SlopeLimits<V>::feathering) * narrow * x;
        const V least = min_(usual, max_(abs_(V(1) - x), V(0.05 * SlopeLimits<V>::leastFeathering)));
        const V reach = max_(sqrt_(r2), least), a = x - reach, b = x + reach, a1 = clamp01(a), b1 = clamp01(b);
        const V la = logarithm(a1), lb = logarithm(b1);
        const auto aThere = less_(V(0), a1), bThere = less_(V(0), b1);
        const V fa = select_(aThere, exp2_(xi2 * la), V(0)), fb = select_(bThere, exp2_(xi2 * lb), V(0));
        const V above = max_(b - V(1), V(0)) - max_(a - V(1), V(0));
        MeanSlopes<V> m = slopesOfDifference((b1 * fb - a1 * fa) * perPower + above, fa, fb, reach, least);
        m.byXi[0] = m.byXi[2] = V(0);
        m.byXi[1] = V(0);
        if (xi) { // x^ξ2 ln x has the antiderivative x^p (ln x/p − 1/p²).
            const V top = b1 * fb * (V(ln2) * lb - perPower) * perPower;
            const V bottom = a1 * fa * (V(ln2) * la - perPower) * perPower;
            m.byXi[1] = (top - bottom) * reciprocal_(max_(V(2) * reach, V(1e-18)));
        }
        return m;
    }
};

/// Edge darkening (19), in v = ln(φ/φ_e) and q = min(h/φ, 2), as Edge has it.
template <class V>
struct EdgeSlopes {
    V xi1, xi2, xi3, phiE, inversePhiE, alpha, beta;
    // How ln φ_e, α and β change with ln ξ2 and with ξ3.
    V edgeBy2, alphaBy2, betaBy2, edgeBy3, alphaBy3, betaBy3;

    SUFFUSE_INLINE EdgeSlopes(V x1, V x2, V x3) : xi1(x1), xi2(x2), xi3(x3)
    {
        const Edge<V> edge(x1, x2, x3);
        phiE = edge.phiE, inversePhiE = edge.inversePhiE, alpha = edge.alpha, beta = edge.beta;
        // q² − r q = 1/ξ3 − 1, α = q², β = r q, φ_e = ξ1 q^(−1/3), r = (ξ2/ξ1)³
        const V ratio = x2 / x1, r = ratio * ratio * ratio, q = sqrt_(alpha), steep = V(2) * q - r;
        const V qBy2 = V(3) * r * q / steep, qBy3 = V(-1) / (x3 * x3 * steep);
        edgeBy2 = V(-1.0 / 3) * qBy2 / q, alphaBy2 = V(2) * q * qBy2, betaBy2 = r * (V(3) * q + qBy2);
        edgeBy3 = V(-1.0 / 3) * qBy3 / q, alphaBy3 = V(2) * q * qBy3, betaBy3 = r * qBy3;
    }
    SUFFUSE_INLINE auto seen(V phi, V h2) const
    {
        const V p = phi * inversePhiE, a = p * (V(1) - p);
        const auto reached = less_(a * a, h2 * inversePhiE * inversePhiE);
        return or_(less_(V(1), p), and_(less_(V(1), V(7.5) * p), reached));
    }
    SUFFUSE_INLINE auto full(V phi, V) const { return less_(phi, V(-1)); } // never
    template <bool xi>
    SUFFUSE_INLINE MeanSlopes<V> slopes(V phi, V h2) const
    {
        const V p = max_(phi, V(1e-18)), over = reciprocal_(p), room = max_(phi - phiE, V(0));
        const V whole = h2 * over * over, q2 = min_(whole, V(4)),
                limit = V(SlopeLimits<V>::edge * SlopeLimits<V>::edge);
        const auto isShort = and_(less_(whole, limit), less_(h2, room * room));
        const Inner inner = eitherForm<V>(
            isShort, seen(phi, h2), [&] { return shortSlopes(phiE * over, min_(q2, limit)); },
            [&] { return longSlopes(V(ln2) * log2_(p * inversePhiE), q2); },
            [](const auto &which, const Inner &one, const Inner &other) {
                return Inner{select_slopes(which, one.m, other.m), select_(which, one.sixth, other.sixth),
                             select_(which, one.third, other.third)};
            });
        const MeanSlopes<V> &v = inner.m;                                 // by v and q²
        const V bySquare = select_(less_(whole, V(4)), v.bySquare, V(0)); // q stays 2
        MeanSlopes<V> m{v.mean, (v.byDensity - V(2) * whole * bySquare) * over, bySquare * over * over, {}};
        if (xi) {
            // M = ξ3 (α·sixth − β·third + share)
            const auto by = [&](V edge, V a, V b) {
                return xi3 * (a * inner.sixth - b * inner.third) - v.byDensity * edge;
            };
            const V byLog2 = by(edgeBy2, alphaBy2, betaBy2);
            m.byXi[1] = byLog2 / xi2;
            m.byXi[2] = by(edgeBy3, alphaBy3, betaBy3) + v.mean / xi3;
            // M stays if φ, h, ξ1 and ξ2 are multiplied by one number.
            m.byXi[0] = V(0) - (phi * m.byDensity + V(2) * h2 * m.bySquare + byLog2) / xi1;
        }
        return m;
    }

private:
    struct Inner {
        MeanSlopes<V> m;
        V sixth, third; ///< the means of e^(−6v) and e^(−3v) over the part of the range with v ≥ 0
    };
    SUFFUSE_INLINE Inner shortSlopes(V ratio, V q2) const
    {
        const V e = ratio * ratio * ratio, e2 = e * e, z = V(9) * q2;
        const V s6 = sinhOver(V(4) * z), s3 = sinhOver(z), b = beta * e, a = alpha * e2;
        return {{xi3 * (a * s6 - b * s3 + V(1)),
                 xi3 * (V(3) * b * s3 - V(6) * a * s6),
                 xi3 * (V(36) * a * sinhOverSlope(V(4) * z) - V(9) * b * sinhOverSlope(z)),
                 {}},
                e2 * s6,
                e * s3};
    }
    SUFFUSE_INLINE Inner longSlopes(V v, V q2) const
    {
        const V least(SlopeLimits<V>::leastEdge), q = max_(sqrt_(q2), least);
        const V low = v - q, a = max_(low, V(0)), b = max_(v + q, V(0));
        const V ea = exp2_(V(-3 * log2e) * a), eb = exp2_(V(-3 * log2e) * b),
                inverse = V(0.5) * reciprocal_(max_(q, V(1e-18)));
        const V third = (ea - eb) * V(1.0 / 3), sixth = (ea - eb) * (ea + eb) * V(1.0 / 6);
        const V rise = xi3 * ((b - a) + alpha * sixth - beta * third);
        const V bottom = select_(less_(V(0), low), of(ea), V(0)), top = select_(less_(V(0), v + q), of(eb), V(0));
        return {slopesOfDifference(rise, bottom, top, q, least), sixth * inverse, third * inverse};
    }
    SUFFUSE_INLINE V of(V e) const { return xi3 * mulAdd_(mulAdd_(alpha, e, V(0) - beta), e, V(1)); }
    /// sinh(x)/x from x², and its derivative by x², for x ≤ 1.8.
    static SUFFUSE_INLINE V sinhOver(V x2)
    {
        const V tenth = mulAdd_(V(1.0 / 6227020800.0), x2, V(1.0 / 39916800)), eighth = mulAdd_(tenth, x2, V(1.0 / 362880));
        const V fourth = mulAdd_(mulAdd_(eighth, x2, V(1.0 / 5040)), x2, V(1.0 / 120));
        return mulAdd_(mulAdd_(fourth, x2, V(1.0 / 6)), x2, V(1.0));
    }
    static SUFFUSE_INLINE V sinhOverSlope(V x2)
    {
        const V tenth = mulAdd_(V(6.0 / 6227020800.0), x2, V(5.0 / 39916800)), eighth = mulAdd_(tenth, x2, V(4.0 / 362880));
        return mulAdd_(mulAdd_(mulAdd_(eighth, x2, V(3.0 / 5040)), x2, V(2.0 / 120)), x2, V(1.0 / 6));
    }
};

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
