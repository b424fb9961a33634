// Maxima on those Bernstein ellipses of [0, 1] at which Level 0 looks (docs/solver.md, "Nodes").
#pragma once

#include <array>

namespace suffuse {

inline constexpr int ellipseCount = 17;
inline constexpr std::array<double, ellipseCount> ellipseRadii{1.15, 1.3, 1.5, 1.75, 2,  2.4, 2.9, 3.5, 4.2,
                                                               5,    6,   7.5, 9.5,  12, 16,  22,  30}; ///< ρ

/// The magnitudes of the Chebyshev coefficients of a cubic and of its derivative, in spreads, for a curve that is
/// nearly straight and evenly drawn.
struct EvenCurve {
    float first = 0, second = 0, third = 0; ///< of the curve
    float crossed = 0;                      ///< |first · second|
    float rest1 = 0, rest2 = 0;             ///< of g′, without the constant one
    float perSpeed = 0;                     ///< 1 divided by the constant one
};
/// The number of nodes that the bound demands, not rounded: the least over all ellipses. 1e30 means that nothing can be
/// said. `logAllowed` is how much greater the constant speed is than the tolerance, as a logarithm.
float nodesOfEvenCurve(const EvenCurve &curve, float logAllowed);

/// The control points of a cubic relative to the first one, and the differences of those of its measure, in spreads.
struct CurveDifferences {
    float x[4], y[4];
    float dx[3], dy[3];
};
/// The maxima of |Im c|² and of |g′·g′|² over 16 points of each of the first `count` ellipses. It stops after the first
/// ellipse with |Im c|² of at least 1e4, and returns the number of those before it.
int sampleEllipses(const CurveDifferences &curve, int count, float (&growth)[ellipseCount],
                   float (&speed)[ellipseCount]);

} // namespace suffuse
