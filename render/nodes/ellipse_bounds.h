// Level 0 bounds the error of a Gauss rule by maxima on Bernstein ellipses of [0, 1], which have their foci at 0 and 1
// (docs/solver.md, "Nodes"). The functions here find these maxima.
#pragma once

#include <array>

namespace suffuse {

inline constexpr int ellipseCount = 17;
/// The size of an ellipse is ρ, twice the sum of its half-axes.
inline constexpr std::array<double, ellipseCount> ellipseRadii{1.15, 1.3, 1.5, 1.75, 2,  2.4, 2.9, 3.5, 4.2,
                                                               5,    6,   7.5, 9.5,  12, 16,  22,  30};

/// Describes a curve that is nearly straight and evenly drawn by the magnitudes of Chebyshev coefficients, in spreads.
struct EvenCurve {
    float first = 0, second = 0, third = 0; ///< those of the curve
    float crossed = 0;                      ///< |c₁ · c₂|, where c₁ and c₂ are the first two as vectors
    float rest1 = 0, rest2 = 0;             ///< those of the derivative g′ of its measure, but for the constant one
    float perSpeed = 0;                     ///< 1 divided by the constant coefficient of g′
};
/// Returns the number of nodes that the bound demands, not rounded, which is the least over all ellipses. 1e30 means
/// that nothing can be said. `logAllowed` is how much greater the constant speed is than the tolerance, as a logarithm.
float nodesOfEvenCurve(const EvenCurve &curve, float logAllowed);

/// Holds the control points of a cubic relative to the first one, and the differences between the control points of the
/// curve g whose speed |g′| is the measure (level0.h), in spreads.
struct CurveDifferences {
    float x[4], y[4];
    float dx[3], dy[3];
};
/// Finds the maxima of |Im c|² and of |g′·g′|² over 16 points of each of the first `count` ellipses. It stops after the
/// first ellipse with |Im c|² of at least 1e4, and returns the number of those before it.
int sampleEllipses(const CurveDifferences &curve, int count, float (&growth)[ellipseCount],
                   float (&speed)[ellipseCount]);

} // namespace suffuse
