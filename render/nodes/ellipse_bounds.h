// Maxima on the Bernstein ellipses of [0, 1] that Level 0 looks at (docs/solver.md, "Nodes").
#pragma once

#include <array>

namespace suffuse {

inline constexpr int ellipseCount = 17;
inline constexpr std::array<double, ellipseCount> ellipseRadii{1.15, 1.3, 1.5, 1.75, 2,  2.4, 2.9, 3.5, 4.2,
                                                               5,    6,   7.5, 9.5,  12, 16,  22,  30}; ///< ρ

/// Magnitudes of a cubic's Chebyshev coefficients and of its derivative's, in spreads; of a curve nearly straight and
/// evenly drawn.
struct EvenCurve {
    float first = 0, second = 0, third = 0; ///< of the curve
    float crossed = 0;                      ///< |first · second|
    float rest1 = 0, rest2 = 0;             ///< of g′, beside the constant one
    float perSpeed = 0;                     ///< 1 over the constant one
};
/// Nodes that the bound asks for, not rounded, the least over all ellipses; 1e30: nothing can be said. `logAllowed`:
/// how much more than the tolerance the constant speed is, as a logarithm.
float nodesOfEvenCurve(const EvenCurve &curve, float logAllowed);

/// Control points of a cubic from the first one, and differences of those of its measure, in spreads.
struct CurveDifferences {
    float x[4], y[4];
    float dx[3], dy[3];
};
/// Maxima over 16 points of each of the first `count` ellipses of |Im c|² and of |g′·g′|²; stops after the first whose
/// |Im c|² is not below 1e4 and returns how many lie before it.
int sampleEllipses(const CurveDifferences &curve, int count, float (&growth)[ellipseCount],
                   float (&speed)[ellipseCount]);

} // namespace suffuse
