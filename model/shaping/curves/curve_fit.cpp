#include "model/shaping/curves/curve_fit.h"

namespace suffuse {

CurveFit::CurveFit(const std::vector<Cubic> &curves, int each) : m_from(curves.front().p[0]), m_to(curves.back().p[3])
{
    m_points.reserve(curves.size() * std::size_t(each));
    for (const Cubic &curve : curves)
        for (int i = 0; i < each; ++i)
            m_points.push_back(curve.at((i + 0.5) / each));
    measure();
}

CurveFit::CurveFit(Point from, std::vector<Point> between, Point to)
    : m_from(from), m_to(to), m_points(std::move(between))
{
    measure();
}

void CurveFit::measure()
{
    m_parameters.clear();
    m_parameters.reserve(m_points.size());
    Point last = m_from;
    double way = 0;
    for (const Point &p : m_points) {
        way += length(p - last);
        m_parameters.push_back(way);
        last = p;
    }
    m_total = way + length(m_to - last);
    for (double &t : m_parameters)
        t = m_total > 0 ? t / m_total : 0;
}

Cubic CurveFit::fitted(Point direction, Point arrival) const
{
    double aa = 0, ab = 0, bb = 0, ax = 0, bx = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const double t = m_parameters[i], u = 1 - t;
        const Point a = (3 * u * u * t) * direction, b = (-3 * u * t * t) * arrival;
        const Point rest = m_points[i] - (u * u * (1 + 2 * t)) * m_from - (t * t * (1 + 2 * u)) * m_to;
        aa += dot(a, a), ab += dot(a, b), bb += dot(b, b), ax += dot(a, rest), bx += dot(b, rest);
    }
    const double determinant = aa * bb - ab * ab;
    double start = (ax * bb - bx * ab) / determinant, end = (aa * bx - ab * ax) / determinant;
    const auto isSound = [this](double l) { return l > 1e-3 * m_total && l < 3 * m_total; };
    if (!isSound(start) || !isSound(end))
        start = end = m_total / 3;
    return {{m_from, m_from + start * direction, m_to - end * arrival, m_to}};
}

void CurveFit::reparametrise(const Cubic &curve)
{
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const double t = m_parameters[i];
        const Point d = curve.at(t) - m_points[i], first = curve.derivative(t);
        const Point second = (6 * (1 - t)) * (curve.p[2] - 2.0 * curve.p[1] + curve.p[0]) +
                             (6 * t) * (curve.p[3] - 2.0 * curve.p[2] + curve.p[1]);
        const double slope = dot(first, first) + dot(d, second);
        if (slope > 0)
            m_parameters[i] = std::clamp(t - dot(d, first) / slope, 0.0, 1.0);
    }
}

double CurveFit::error(const Cubic &curve) const
{
    double most = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const Point d = curve.at(m_parameters[i]) - m_points[i];
        most = std::max(most, dot(d, d));
    }
    return std::sqrt(most);
}

Cubic fittedCubic(CurveFit &fit, Point direction, Point arrival, int rounds)
{
    Cubic result = fit.fitted(direction, arrival);
    for (int round = 0; round < rounds; ++round) {
        fit.reparametrise(result);
        result = fit.fitted(direction, arrival);
    }
    return result;
}

namespace {

/// The direction of the path at one of its points, from the points within a distance around it.
Point directionAmong(const std::vector<Point> &points, std::size_t i, double within)
{
    std::size_t from = i, to = i;
    while (from > 0 && length(points[from] - points[i]) < within)
        --from;
    while (to + 1 < points.size() && length(points[to] - points[i]) < within)
        ++to;
    const Point way = points[to] - points[from];
    const double l = length(way);
    return l > 0 ? (1 / l) * way : Point{1, 0};
}

void appendCubics(const std::vector<Point> &points, std::size_t first, std::size_t last, Point direction, Point arrival,
                  double tolerance, std::vector<Cubic> &cubics)
{
    constexpr int rounds = 6;
    const auto at = [&](std::size_t i) { return points.begin() + std::ptrdiff_t(i); };
    CurveFit fit(points[first], {at(first + 1), at(last)}, points[last]);
    Cubic cubic = fit.fitted(direction, arrival);
    for (int round = 0; round < rounds && fit.error(cubic) > tolerance; ++round) {
        fit.reparametrise(cubic);
        cubic = fit.fitted(direction, arrival);
    }
    if (last - first < 3 || fit.error(cubic) <= tolerance) {
        cubics.push_back(cubic);
        return;
    }
    const std::size_t middle = first + (last - first) / 2;
    const Point through = directionAmong(points, middle, 4 * tolerance);
    appendCubics(points, first, middle, direction, through, tolerance, cubics);
    appendCubics(points, middle, last, through, arrival, tolerance, cubics);
}

} // namespace

std::vector<Cubic> cubicsThrough(const std::vector<Point> &points, Point direction, Point arrival, double tolerance)
{
    std::vector<Cubic> cubics;
    if (points.size() < 2)
        return cubics;
    if (direction == Point())
        direction = directionAmong(points, 0, 4 * tolerance);
    if (arrival == Point())
        arrival = directionAmong(points, points.size() - 1, 4 * tolerance);
    appendCubics(points, 0, points.size() - 1, direction, arrival, tolerance, cubics);
    return cubics;
}

std::vector<std::size_t> cornersOfWay(const std::vector<Point> &way, std::size_t arm, double angle)
{
    const std::size_t n = way.size();
    std::vector<std::size_t> corners;
    if (n < 4 * arm)
        return corners;
    std::vector<double> turns(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Point in = way[i] - way[(i + n - arm) % n], out = way[(i + arm) % n] - way[i];
        turns[i] = std::abs(std::atan2(cross(in, out), dot(in, out)));
    }
    for (std::size_t i = 0; i < n; ++i) {
        bool isCorner = turns[i] > angle;
        for (std::size_t k = 1; k <= arm && isCorner; ++k) // Of neighbours that turn alike the first one counts.
            isCorner = turns[i] >= turns[(i + k) % n] && turns[i] > turns[(i + n - k) % n];
        if (isCorner)
            corners.push_back(i);
    }
    return corners;
}

} // namespace suffuse
