// How density becomes coverage (eq 17-19), in double precision, for tools, panels and importers. Pictures are made by
// render/math, which also has means over pixels, in the number types of its kernels. render/reference checks both.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse {

inline constexpr std::array styleKinds{StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge};

/// How many of ξ1, ξ2, ξ3 a kind of style has.
constexpr int xiCount(StyleKind kind)
{
    return kind == StyleKind::Edge ? 3 : 2;
}

/// Whether strokes of a style end in a jump, at a dark rim around a lighter inside (19).
constexpr bool hasRim(StyleKind kind)
{
    return kind == StyleKind::Edge;
}

/// F(φ′) in [0, 1] with the edges as they are defined: exactly 0 up to φ₀ = max(0, ξ1 − 8ξ2) of (17), and below φ_e of
/// (19).
double densityFunction(const Style &style, double density);
/// The same for ξ in double precision, as means over segments are.
double densityFunction(StyleKind kind, const std::array<double, 3> &xi, double density);

/// The density at which the visible stroke ends: where (17) and (18) are ½, and φ_e of (19).
double visibleCut(const Style &style);

/// The least coverage between the rim and the far inside, ξ3(1 − ξ2⁶/(4ξ1⁶)), for a style with a rim.
double leastInsideRim(const Style &style);

/// Where a plot of F may end: beyond it nothing happens, except that a rim's far side slowly comes back.
double plottedDensity(const Style &style);

} // namespace suffuse
