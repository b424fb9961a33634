// Fits one cubic to many points by least squares, with the directions at its ends given.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// The points of a path in order, in canvas units. Each has a parameter, at first its share of the way.
class CurveFit {
public:
    /// Takes `each` points of every curve; the curves follow each other.
    explicit CurveFit(const std::vector<Cubic> &curves, int each = 16);
    /// Takes points between two ends. The ends are not among them.
    CurveFit(Point from, std::vector<Point> between, Point to);

    /// The length of the way through the points.
    double total() const { return m_total; }

    /// The cubic whose handles, along the given directions (both along the way, of length 1), bring it nearest to the
    /// points in the sense of least squares (P. J. Schneider, An Algorithm for Automatically Fitting Digitized Curves,
    /// 1990). If a handle would point backwards, both handles are a third of the way long.
    Cubic fitted(Point direction, Point arrival) const;
    /// Moves each point's parameter to where the curve is nearest to it, by one step of Newton's method.
    void reparametrise(const Cubic &curve);
    /// The greatest distance of a point to the curve's place at its parameter. It is no less than the point's distance
    /// to the curve.
    double error(const Cubic &curve) const;

private:
    void measure();

    Point m_from, m_to;
    std::vector<Point> m_points;
    std::vector<double> m_parameters;
    double m_total = 0;
};

/// Fits and moves parameters in turn for some rounds, and returns the last cubic.
Cubic fittedCubic(CurveFit &fit, Point direction, Point arrival, int rounds = 8);

/// Cubics through points (two or more), none of which is farther from them than `tolerance`. Each goes on in the
/// direction of the one before. The directions at both ends have length 1; where one is 0, the direction of the points
/// is taken.
std::vector<Cubic> cubicsThrough(const std::vector<Point> &points, Point direction, Point arrival, double tolerance);

/// The points of a closed way at which it turns by more than an angle, looked at so many points before and behind them.
std::vector<std::size_t> cornersOfWay(const std::vector<Point> &way, std::size_t arm, double angle);

} // namespace suffuse
