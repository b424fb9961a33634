// This computes how many Gauss-Legendre nodes a cubic source needs (docs/solver.md, "Nodes").
#pragma once

#include "model/geometry/geometry.h"
#include "render/math/panels.h"

namespace suffuse {

/// One rule has at most this many nodes. A panel is a piece of a curve that gets one rule; a curve that needs more
/// nodes is split into several.
inline constexpr int maxPanelNodes = panels::mostNodes;

/// Holds a Gauss-Legendre rule on [0, 1].
struct QuadratureRule {
    std::array<double, maxPanelNodes> x{};
    std::array<double, maxPanelNodes> weight{};
};
/// Returns the rule of n points, n in [1, maxPanelNodes].
const QuadratureRule &gaussLegendre(int n);

/// Returns panels::nodesOf.
int panelNodes(const panels::Curve &whitened, const panels::Curve &metric, double tolerance);

inline panels::Curve panelCurve(const Cubic &c)
{
    return {{c.p[0].x, c.p[0].y}, {c.p[1].x, c.p[1].y}, {c.p[2].x, c.p[2].y}, {c.p[3].x, c.p[3].y}};
}

} // namespace suffuse
