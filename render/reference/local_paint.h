// What a stroke is at one spot, and the paint that comes of it (eq 15-21).
#pragma once

#include "render/reference/colour.h"
#include "render/reference/style.h"

namespace suffuse::reference {

/// A kind of style at a spot: Σφ_k/φ over its segments and the mean ξ̄ over them.
struct StyleShare {
    StyleKind kind = StyleKind::Uniform;
    double share = 1;
    Xi xi{};
};

struct LocalDensity {
    double density = 0;     ///< φ⁺ − φ⁻, of the segments that lay paint and of those that lift it; may be < 0
    double slope = 0;       ///< |∇(φ⁺ − φ⁻)|
    double lifted = 0;      ///< φ⁻/φ⁺
    double granulation = 1; ///< ω̄ (15)
    std::array<double, 4> colour{};     ///< C̄ (20): R, Y, B, opacity
    std::array<StyleShare, 3> styles{}; ///< of the kinds there are
    int styleCount = 0;
};

/// γ = (1 − ω̄)η + ω̄ (16).
double modulation(double granulation, double eta);

/// F(φ′), φ′ = γφ: its mean over a spot of size `px` in the slope's unit, 0 for the spot itself. In [0, 1].
double localDensityFunction(const LocalDensity &local, double eta, double px);

/// w = F·C̄_opacity (21) with C̄.
Paint paintOf(const LocalDensity &local, double eta, double px);

} // namespace suffuse::reference
