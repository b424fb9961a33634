// How density becomes coverage (eq 17-19), in double precision: for tools, panels and importers. Pictures come from
// render/math, which has means over pixels besides, in the number types of its kernels; render/reference checks both.
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

/// Whether its stroke ends in a jump, at a dark rim that lies around a lighter inside (19).
constexpr bool hasRim(StyleKind kind)
{
    return kind == StyleKind::Edge;
}

/// F(φ′) in [0, 1], with the defined edges: exactly 0 up to φ₀ = max(0, ξ1 − 8ξ2) of (17) and below φ_e of (19).
double densityFunction(const Style &style, double density);
/// The same of a kind with ξ that need not be float32: means over segments.
double densityFunction(StyleKind kind, const std::array<double, 3> &xi, double density);

/// Density at which the visible stroke ends: where (17) and (18) reach ½, φ_e of (19).
double visibleCut(const Style &style);

/// Least coverage between the rim and what is far inside, ξ3(1 − ξ2⁶/(4ξ1⁶)); for a style with a rim.
double leastInsideRim(const Style &style);

/// Where a plot of F may end: beyond it nothing happens but that what is far behind a rim comes back slowly.
double plottedDensity(const Style &style);

} // namespace suffuse
