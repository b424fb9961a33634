// What a stroke is at one sample, and the way back through it: from the derivatives of a loss by the colours above a
// stroke to those by its sums. docs/solver.md, "The gradient of the picture".
#if defined(SUFFUSE_RENDER_MATH_PAINT_SLOPES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SUFFUSE_RENDER_MATH_PAINT_SLOPES_H
#undef SUFFUSE_RENDER_MATH_PAINT_SLOPES_H
#else
#define SUFFUSE_RENDER_MATH_PAINT_SLOPES_H
#endif

#include "render/math/colour_slopes.h"
#include "render/math/style_slopes.h"

SUFFUSE_MATH_BEGIN
namespace suffuse::SUFFUSE_MATH {

/// R, Y, B, opacity, ω.
inline constexpr int paintValues = 5;

/// A stroke at a sample.
template <class V>
struct PaintSample {
    V phi, square;  ///< φ′ and h², with the paper in them
    V gamma, plain; ///< γ, and h² without it
    V inverse;      ///< 1/φ⁺ where values vary
    V value[paintValues];
    V left; ///< e^(−φ_f), which is left of the opacity

    SUFFUSE_INLINE PaintSample() {} // The implicit one would not be compiled for the target.
    /// From φ, −½∂φ/∂x, −½∂φ/∂y. `value` must be there before `takePaper`.
    SUFFUSE_INLINE PaintSample(V density, V gx, V gy) : phi(density), gamma(V(1)), inverse(V(0)), left(V(1))
    {
        plain = square = mulAdd_(gx, gx, gy * gy);
    }
    /// Sets the i-th value to the mean of those of the nodes.
    SUFFUSE_INLINE void takeMean(int i, V sum) { value[i] = min_(sum * inverse, V(1)); }
    SUFFUSE_INLINE void takePaper(V eta)
    {
        const V omega = value[paintValues - 1];
        gamma = mulAdd_(V(1) - omega, eta, omega);
        phi = phi * gamma;
        square = square * gamma * gamma;
    }
};

/// Derivatives by what a stroke is at a sample.
template <class V>
struct PaintSlopes {
    V byPhi, bySquare, byMean; ///< by φ and h² without paper, and by M
    V byFading;                ///< by φ_f
    V value[paintValues];

    SUFFUSE_INLINE PaintSlopes() {}
};

/// Replaces ∂L/∂(R, Y, B) above a stroke, `by`, by those below it. `m` has M and its derivatives at the sample, `below`
/// the colour below the stroke, `density` φ without paper.
template <bool paper, class V>
SUFFUSE_INLINE PaintSlopes<V> paintBack(const PaintSample<V> &p, const MeanSlopes<V> &m, V keep, const V (&below)[3],
                                        V density, V eta, V (&by)[3])
{
    PaintSlopes<V> out;
    const V w = m.mean * p.value[3] * p.left;
    V byW(0);
    for (int c = 0; c < 3; ++c) {
        const MixSlopes<V> slopes = mixSlopes(below[c], p.value[c], w, keep, by[c]);
        by[c] = slopes.byBackdrop;
        out.value[c] = slopes.byColour;
        byW = byW + slopes.byOpacity;
    }
    out.byMean = byW * p.value[3] * p.left;
    out.byFading = V(0) - byW * w;
    out.byPhi = out.byMean * m.byDensity, out.bySquare = out.byMean * m.bySquare;
    out.value[3] = byW * m.mean * p.left;
    out.value[4] = V(0);
    if (paper) {
        const V byGamma = mulAdd_(out.byPhi, density, V(2) * out.bySquare * p.gamma * p.plain);
        out.value[4] = byGamma * (V(1) - eta);
        out.byPhi = out.byPhi * p.gamma;
        out.bySquare = out.bySquare * p.gamma * p.gamma;
    }
    return out;
}

} // namespace suffuse::SUFFUSE_MATH
SUFFUSE_MATH_END

#endif
