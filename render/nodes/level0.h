// How many Gauss-Legendre nodes a cubic source needs (docs/solver.md, "Nodes").
#pragma once

#include "model/painting/geometry.h"

namespace suffuse {

/// Greatest number of nodes of one panel; a longer curve is split.
inline constexpr int maxPanelNodes = 10;

/// A Gauss-Legendre rule on [0, 1].
struct QuadratureRule {
    std::array<double, maxPanelNodes> x{};
    std::array<double, maxPanelNodes> weight{};
};
/// n in [1, maxPanelNodes].
const QuadratureRule &gaussLegendre(int n);

/// Smallest n for which n nodes integrate e^(−|x − c(p)|²) |g′(p)| over [0, 1] to within tolerance · √π at every x, by
/// the Bernstein-ellipse bound; 0 if more than maxPanelNodes would be needed.
/// `whitened`: the curve in coordinates in which the Gaussian is e^(−r²) (canvas / s where isotropic); `metric`: the
/// curve whose speed |g′| is the measure, in the same scale (equal to `whitened` where isotropic).
int panelNodes(const Cubic &whitened, const Cubic &metric, double tolerance);

} // namespace suffuse
