// One cubic through many points: least squares with the directions at its ends given.
#pragma once

#include "model/painting/geometry.h"

#include <vector>

namespace suffuse {

/// Points of a path, in order, with a parameter each: at first its share of the way. Canvas units.
class CurveFit {
public:
    /// Points on curves that follow each other, `each` of a curve.
    explicit CurveFit(const std::vector<Cubic> &curves, int each = 16);
    /// Points between two ends, which are not among them.
    CurveFit(Point from, std::vector<Point> between, Point to);

    /// Length of the way through the points.
    double total() const { return m_total; }

    /// Handles along the directions (both along the way, of length 1) that come nearest to the points in the sense of
    /// least squares (P. J. Schneider, An Algorithm for Automatically Fitting Digitized Curves, 1990). Where these
    /// would be no handles, both are a third of the way.
    Cubic fitted(Point direction, Point arrival) const;
    /// Puts the points' parameters where the curve is nearest (one step of Newton's).
    void reparametrise(const Cubic &curve);
    /// The greatest distance of a point to the curve's place at its parameter: at least its distance to the curve.
    double error(const Cubic &curve) const;

private:
    void measure();

    Point m_from, m_to;
    std::vector<Point> m_points;
    std::vector<double> m_parameters;
    double m_total = 0;
};

/// The cubic that comes of several rounds of both.
Cubic fittedCubic(CurveFit &fit, Point direction, Point arrival, int rounds = 8);

/// Cubics through points, each no farther from them than `tolerance`, which go on from each other in one direction.
/// Two points or more; the directions at both ends are of length 1, or 0: that of the points.
std::vector<Cubic> cubicsThrough(const std::vector<Point> &points, Point direction, Point arrival, double tolerance);

} // namespace suffuse
