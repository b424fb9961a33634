// The density of one segment (eq 13) to 1e-12 of the peak, its gradient, and the closed forms with which tests compare
// it.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse::reference {

/// The Gaussian that spreads every point of a curve: norm · e^(−|A(x − c)|²), with M = AᵀA = D⁻¹/4t the inverse of the
/// diffusion tensor and norm = √detM/π. Isotropic: A = 1/s, norm = 1/(π s²).
struct Kernel {
    double a11 = 1, a12 = 0, a21 = 0, a22 = 1; ///< A
    double norm = 0;
    double smallerSpread = 1; ///< spread along the tensor's shorter axis
    double largerSpread = 1;  ///< along the longer
    bool isotropic = true;

    Point whiten(Point d) const { return {a11 * d.x + a12 * d.y, a21 * d.x + a22 * d.y}; }
    Cubic whiten(const Cubic &c) const { return {{whiten(c.p[0]), whiten(c.p[1]), whiten(c.p[2]), whiten(c.p[3])}}; }
};

/// s = √(4Dt) > 0.
Kernel isotropicKernel(double s);
/// The tensor D·ratio along `angle` (radians, from x towards y) and D across it; s = √(4Dt), the spread across.
Kernel anisotropicKernel(double s, double ratio, double angle);

struct DensityAndGradient {
    double density = 0;
    Point gradient; ///< per unit
};

/// Here e^(−r²) is below any double that matters (6e-36).
inline constexpr double adaptiveReach = 9;

/// φ_k(x) = φˢ·norm ∫₀¹ e^(−|A(x − c(p))|²) |c′(p)| dp (eq 13) and its gradient, by adaptive Gauss-Kronrod quadrature.
/// The curve is split where |c′| has a minimum (cusps), and halved until pieces are short relative to the spread, and
/// further until G7 and K15 agree to 1e-14 of the peak φˢ/(√π s). What is farther away than `adaptiveReach` spreads
/// counts as 0.
DensityAndGradient segmentDensity(const Cubic &cubic, const Kernel &kernel, double density, Point x);
/// φ_k(x) of an isotropic segment of spread s and density φˢ.
double segmentDensity(const Cubic &cubic, double s, double density, Point x);
/// ∇φ_k(x), per unit.
Point segmentDensityGradient(const Cubic &cubic, double s, double density, Point x);

/// The parameters in (0, 1), in increasing order, where the speed |c′| has a minimum or maximum: the real roots of
/// c′·c″. Cusps are among them.
std::vector<double> speedExtrema(const Cubic &cubic);
/// The cubic, cut at those parameters.
std::vector<Cubic> piecesBetweenSpeedExtrema(const Cubic &cubic);

/// erf(a) − erf(b) without cancellation, by erfc where both are on one side of 0.
double erfDifference(double a, double b);

/// The density of a straight segment of length L and even density φˢ, at u along it from its start and v across it.
double straightDensity(double length, double s, double density, double u, double v);
/// The same with a density φ0 + gℓ that grows linearly along the segment.
double rampDensity(double length, double s, double density, double slope, double u, double v);
/// The density of a straight segment from a to b under any kernel.
double straightDensity(Point a, Point b, const Kernel &kernel, double density, Point x);

} // namespace suffuse::reference
