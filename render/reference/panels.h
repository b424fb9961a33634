// A segment as Gauss-Legendre panels so fine that their sum is the integral (eq 13), for whole pictures.
#pragma once

#include "render/reference/density.h"

#include <array>
#include <functional>
#include <vector>

namespace suffuse::reference {

/// A piece of the curve on which the 10-point Gauss rule is exact in double precision.
struct Panel {
    Cubic piece;
    Rect box; ///< around its control points
};

/// A point of the curve, with the arc length that it represents.
struct Node {
    Point at;
    double weight = 0;
};

/// Returns true for the box of a piece's control points if the piece cannot matter, so that it need not be computed.
using PanelFilter = std::function<bool(const Rect &)>;

/// Cuts the cubic where its speed has extrema, and halves it until every panel is at most one spread long and the
/// 10-point rule agrees with the 20-point rule to 1e-13 of the peak at probe points on and beside it (density and
/// gradient). Appends the panels that `skip` leaves.
void appendPanels(const Cubic &cubic, const Kernel &kernel, const PanelFilter &skip, std::vector<Panel> &panels);

/// The nodes of a panel, whose Gaussians sum up to its part of ∫ e^(−|A(x − c)|²) |c′| dp.
std::array<Node, 10> nodesOf(const Panel &panel);

/// φ_k(x) and its gradient from panels.
DensityAndGradient panelDensity(const std::vector<Panel> &panels, const Kernel &kernel, double density, Point x);

} // namespace suffuse::reference
