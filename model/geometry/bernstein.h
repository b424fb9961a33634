// Roots of polynomials in Bernstein form, as they arise where cubics meet lines and circles.
#pragma once

#include "model/geometry/geometry.h"

#include <span>
#include <vector>

namespace suffuse {

/// The polynomial Σ f_i·binomial(n, i)·p^i·(1 − p)^(n − i) at p, for n + 1 coefficients. Its degree is at most 6.
double bernsteinAt(std::span<const double> f, double p);

/// The roots in [0, 1] in rising order, to the last bits of double precision. A root of even order, where the
/// polynomial only touches 0, is found once, twice or, within rounding, not at all. There are none where the polynomial
/// is 0 throughout.
std::vector<double> bernsteinRoots(std::span<const double> f);

/// The signed distance of a cubic's point from the line through `on`, times |normal|, as a polynomial of p.
std::array<double, 4> distanceFromLine(const Cubic &cubic, Point on, Point normal);
/// |c(p) − centre|² − r², as a polynomial of p.
std::array<double, 7> powerOfCircle(const Cubic &cubic, Point centre, double radius);
/// (c(p) − point)·c′(p)/3, as a polynomial of p. It is 0 where the distance from the point has an extremum.
std::array<double, 6> distanceSlope(const Cubic &cubic, Point point);

} // namespace suffuse
