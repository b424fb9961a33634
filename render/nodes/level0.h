// This computes how many Gauss-Legendre nodes a cubic source needs (docs/solver.md, "Nodes").
#pragma once

#include "model/painting/geometry.h"

namespace suffuse {

/// One rule has at most this many nodes. A panel is a piece of a curve that gets one rule; a curve that needs more
/// nodes is split into several.
inline constexpr int maxPanelNodes = 10;

/// Holds a Gauss-Legendre rule on [0, 1].
struct QuadratureRule {
    std::array<double, maxPanelNodes> x{};
    std::array<double, maxPanelNodes> weight{};
};
/// Returns the rule of n points, n in [1, maxPanelNodes].
const QuadratureRule &gaussLegendre(int n);

/// Returns the smallest n for which n nodes integrate e^(−|x − c(p)|²) |g′(p)| over [0, 1] to within tolerance · √π at
/// every x, by the Bernstein-ellipse bound, or 0 if more than maxPanelNodes are needed. `whitened` is the curve in
/// coordinates in which the Gaussian is e^(−r²) (canvas / s if isotropic). `metric` is the curve whose speed |g′| is
/// the measure, in the same scale (equal to `whitened` if isotropic).
int panelNodes(const Cubic &whitened, const Cubic &metric, double tolerance);

} // namespace suffuse
