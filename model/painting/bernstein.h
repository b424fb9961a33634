// Roots of polynomials in Bernstein form: where cubics meet lines and circles.
#pragma once

#include "model/painting/geometry.h"

#include <span>
#include <vector>

namespace suffuse {

/// Degree up to 6: Σ f_i·binomial(n, i)·p^i·(1 − p)^(n − i) for n + 1 coefficients.
double bernsteinAt(std::span<const double> f, double p);

/// The roots in [0, 1], increasing, to the last bits of double precision. A root of even order, where the polynomial
/// only touches 0, is found once, twice or, within rounding, not at all. None where the polynomial is 0 throughout.
std::vector<double> bernsteinRoots(std::span<const double> f);

/// Signed distance times |normal| from the line through `on`, as a polynomial of p.
std::array<double, 4> distanceFromLine(const Cubic &cubic, Point on, Point normal);
/// |c(p) − centre|² − r².
std::array<double, 7> powerOfCircle(const Cubic &cubic, Point centre, double radius);
/// (c(p) − point)·c′(p)/3: 0 where the distance from the point has an extremum.
std::array<double, 6> distanceSlope(const Cubic &cubic, Point point);

} // namespace suffuse
