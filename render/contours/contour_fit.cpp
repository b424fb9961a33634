#include "render/contours/contour_fit.h"

#include "model/shaping/curves/curve_fit.h"

namespace suffuse::contours {

namespace {

constexpr std::size_t mostPoints = 96; // that one cubic is tried on
constexpr double pointShare = 0.6;     // of the tolerance, for how near the points lie,
constexpr double triedShare = 0.75;    // and for where the field itself is asked

/// Along the contour: what is above the level lies left, as points are written with y up.
Point directionOf(Point slope)
{
    const double size = length(slope);
    return size > 0 ? (1 / size) * Point{slope.y, -slope.x} : Point{};
}

class LoopFit {
public:
    LoopFit(const ContourChain &chain, const Field &field, double level, double tolerance)
        : m_field(field), m_level(level), m_tolerance(tolerance), m_tried(triedShare * tolerance)
    {
        // Neighbouring sides of triangles may be crossed in almost the same place.
        for (const ContourPoint &p : chain)
            if (m_points.empty() || length(p.at - m_points.back()) > 0.05 * tolerance) {
                m_points.push_back(p.at);
                m_directions.push_back(directionOf(p.slope));
            }
        while (m_points.size() > 1 && length(m_points.back() - m_points.front()) <= 0.05 * tolerance) {
            m_points.pop_back();
            m_directions.pop_back();
        }
        const std::size_t count = m_points.size();
        for (std::size_t i = 0; i < count && count > 2; ++i) {
            const Point way = m_points[(i + 1) % count] - m_points[(i + count - 1) % count];
            const double size = length(way);
            if (size > 0 && !(dot(m_directions[i], way) > 0.5 * size)) // Where the field jumps slopes say little.
                m_directions[i] = (1 / size) * way;
        }
    }

    std::vector<Cubic> cubics()
    {
        const std::size_t count = m_points.size();
        if (count < 3)
            return {};
        for (std::size_t from = 0; from < count;) {
            const std::size_t limit = std::min({count, from + mostPoints, from + std::max<std::size_t>(count / 3, 1)});
            std::size_t good = from + 1, step = 4;
            std::optional<Cubic> best;
            std::size_t bad = limit + 1;
            for (std::size_t to = std::min(from + step, limit); to > good; to = std::min(from + step, limit)) {
                const std::optional<Cubic> cubic = fitted(from, to);
                if (!cubic) {
                    bad = to;
                    break;
                }
                best = cubic, good = to, step *= 2;
            }
            while (good + 1 < bad && bad <= limit) {
                const std::size_t middle = (good + bad) / 2;
                const std::optional<Cubic> cubic = fitted(from, middle);
                if (cubic)
                    best = cubic, good = middle;
                else
                    bad = middle;
            }
            if (best)
                m_cubics.push_back(*best);
            else
                appendStep(m_points[from], m_directions[from], at(from + 1), directionAt(from + 1), 0);
            from = good;
        }
        return std::move(m_cubics);
    }

private:
    Point at(std::size_t i) const { return m_points[i % m_points.size()]; }
    Point directionAt(std::size_t i) const { return m_directions[i % m_points.size()]; }

    std::optional<Cubic> fitted(std::size_t from, std::size_t to) const
    {
        // A cubic turns by less than half a circle.
        double turn = 0;
        for (std::size_t i = from; i < to; ++i)
            turn += std::atan2(cross(directionAt(i), directionAt(i + 1)), dot(directionAt(i), directionAt(i + 1)));
        if (std::abs(turn) > 1.9)
            return {};
        std::vector<Point> between;
        for (std::size_t i = from + 1; i < to; ++i)
            between.push_back(at(i));
        CurveFit fit(at(from), std::move(between), at(to));
        Cubic cubic = fit.fitted(directionAt(from), directionAt(to));
        for (int round = 0; round < 8 && fit.error(cubic) > pointShare * m_tolerance; ++round) {
            fit.reparametrise(cubic);
            cubic = fit.fitted(directionAt(from), directionAt(to));
        }
        if (fit.error(cubic) > pointShare * m_tolerance || !follows(cubic))
            return {};
        return cubic;
    }

    /// Whether the contour passes near enough to a cubic.
    bool follows(const Cubic &cubic) const
    {
        return isNear(cubic, 0.5) && isNear(cubic, 0.11) && isNear(cubic, 0.89) && isNear(cubic, 0.3) &&
               isNear(cubic, 0.7);
    }
    bool isNear(const Cubic &cubic, double t) const
    {
        const Point p = cubic.at(t);
        const Sloped here = m_field(p);
        const double steep = length(here.slope);
        if (std::abs(here.value - m_level) <= m_tried * steep)
            return true;
        const Point along = cubic.derivative(t);
        const double size = length(along);
        if (!(size > 0))
            return true;
        const Point across = (m_tried / size) * Point{-along.y, along.x};
        return (m_field(p + across).value >= m_level) != (m_field(p - across).value >= m_level);
    }

    /// From one point to the next, with more points of the contour between where a cubic does not follow it.
    void appendStep(Point from, Point direction, Point to, Point arrival, int depth)
    {
        const double way = length(to - from);
        const Cubic cubic{{from, from + way / 3 * direction, to - way / 3 * arrival, to}};
        if (depth == 5 || way < 0.25 * m_tolerance || follows(cubic)) {
            m_cubics.push_back(cubic);
            return;
        }
        const Point middle = 0.5 * (from + to);
        const std::optional<ContourPoint> between = onContour(middle, (1 / way) * (to - from), way);
        const Point along = between ? directionOf(between->slope) : Point{};
        if (!between || !(dot(along, to - from) > 0.3 * way)) {
            m_cubics.push_back({{from, from + (1.0 / 3) * (to - from), to - (1.0 / 3) * (to - from), to}});
            return;
        }
        appendStep(from, direction, between->at, along, depth + 1);
        appendStep(between->at, along, to, arrival, depth + 1);
    }
    /// The point of the contour beside a point, across a direction.
    std::optional<ContourPoint> onContour(Point p, Point along, double reach) const
    {
        const Point left = p + 0.5 * reach * Point{-along.y, along.x}, way = reach * Point{along.y, -along.x};
        const bool first = m_field(left).value >= m_level;
        if ((m_field(left + way).value >= m_level) == first)
            return {};
        double low = 0, high = 1;
        while ((high - low) * reach > 0.05 * m_tolerance) {
            const double t = 0.5 * (low + high);
            ((m_field(left + t * way).value >= m_level) == first ? low : high) = t;
        }
        const Point found = left + 0.5 * (low + high) * way;
        return ContourPoint{found, m_field(found).slope};
    }

    const Field &m_field;
    double m_level, m_tolerance, m_tried;
    std::vector<Point> m_points, m_directions;
    std::vector<Cubic> m_cubics;
};

} // namespace

std::vector<Cubic> fittedLoop(const ContourChain &chain, const Field &field, double level, double tolerance)
{
    return LoopFit(chain, field, level, tolerance).cubics();
}

} // namespace suffuse::contours
