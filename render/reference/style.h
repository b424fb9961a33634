// Density functions F (eq 17-19) as the documentation and the contract define their edges, and their means over a
// pixel.
#pragma once

#include "model/painting/style.h"

#include <array>

namespace suffuse::reference {

using Xi = std::array<double, 3>; ///< ξ1, ξ2, ξ3

/// φ₀ = max(0, ξ1 − 8ξ2), below which uniform strokes are exactly 0.
double uniformCut(const Xi &xi);
/// φ_e, where edge darkening (19), coming from inside, first reaches 1, and where strokes end.
double edgeCut(const Xi &xi);

/// F̃ (17), F (18) or F (19) at a density φ′ ≥ 0; in [0, 1].
double densityFunction(StyleKind kind, const Xi &xi, double density);

/// The mean of F over φ ∈ [φ′ − h, φ′ + h] for (17) and (18), and over ln φ ∈ [ln φ′ ± min(h/φ′, 2)] for (19). h ≥ 0,
/// and h = 0 gives F itself. It uses closed forms, and Gauss quadrature of the smooth pieces where their difference
/// would cancel. φ′ may be below 0, where F is 0. `lifted` is φ⁻/φ⁺. If it is above 0, the mean of (19) is also taken
/// over φ and counts by min(1, 2φ⁻/φ⁺), since paint that is lifted ends in a density that falls through 0, and not in
/// one that fades.
double densityFunctionMean(StyleKind kind, const Xi &xi, double density, double h, double lifted = 0);

} // namespace suffuse::reference
