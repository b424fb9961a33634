#include "render/contours/contour_fit.h"

#include "model/shaping/curves/curve_fit.h"

namespace suffuse::contours {

namespace {

constexpr std::size_t mostPoints = 96;                                // that one cubic is tried on
constexpr double widestTurn = 1.9, sharpStep = 0.5, gentleStep = 0.2; // radians
constexpr std::size_t manySteps = 6;
constexpr double closest = 0.15;    // of the usual distance from point to point
constexpr double pointShare = 0.6;  // of the tolerance, for how near the points lie,
constexpr double triedShare = 0.75; // and for where the field itself is asked

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
        // Neighbouring sides of squares may be crossed in almost the same place, and not in their order.
        double way = 0;
        for (std::size_t i = 0; i < chain.size(); ++i)
            way += length(chain[i].at - chain[(i + 1) % chain.size()].at);
        const double least = std::max(0.05 * tolerance, closest * way / double(chain.size()));
        for (const ContourPoint &p : chain)
            if (m_points.empty() || length(p.at - m_points.back()) > least) {
                m_points.push_back(p.at);
                m_directions.push_back(directionOf(p.slope));
            }
        while (m_points.size() > 1 && length(m_points.back() - m_points.front()) <= least) {
            m_points.pop_back();
            m_directions.pop_back();
        }
        const std::size_t count = m_points.size();
        for (std::size_t i = 0; i < count && count > 2; ++i) {
            const Point around = m_points[(i + 1) % count] - m_points[(i + count - 1) % count];
            const double size = length(around);
            if (size > 0 && !(dot(m_directions[i], around) > 0.3 * size)) // Where the field jumps slopes say little.
                m_directions[i] = (1 / size) * around;
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
        double turn = 0, sharpest = 0;
        for (std::size_t i = from; i < to; ++i) {
            const double step =
                std::atan2(cross(directionAt(i), directionAt(i + 1)), dot(directionAt(i), directionAt(i + 1)));
            // Where it turns much from point to point, nothing tells of what lies between but trying.
            if (std::abs(step) > sharpStep && to > from + 2)
                return {};
            turn += step;
            sharpest = std::max(sharpest, std::abs(step));
        }
        if (std::abs(turn) > widestTurn)
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
        if (fit.error(cubic) > pointShare * m_tolerance || !follows(cubic, to - from > manySteps, sharpest))
            return {};
        return cubic;
    }

    /// Whether the contour passes near enough to a cubic. Where that was drawn through many points there is less to
    /// try, and where it turns sharply from one to the next there is more.
    bool follows(const Cubic &cubic, bool isThroughMany, double sharpest) const
    {
        const auto isNearAll = [&](std::initializer_list<double> places) {
            return std::ranges::all_of(places, [&](double t) { return isNear(cubic, t); });
        };
        if (!isNearAll({0.5, 0.11, 0.89}))
            return false;
        if (sharpest >= gentleStep)
            return isNearAll({0.3, 0.7, 0.04, 0.2, 0.4, 0.6, 0.8, 0.96});
        return isThroughMany || isNearAll({0.3, 0.7});
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
        if (depth == 6 || way < 0.25 * m_tolerance ||
            follows(cubic, false, std::abs(std::atan2(cross(direction, arrival), dot(direction, arrival))))) {
            m_cubics.push_back(cubic);
            return;
        }
        const Point middle = 0.5 * (from + to);
        const std::optional<ContourPoint> between = onContour(middle, (1 / way) * (to - from), 2 * way);
        if (!between) {
            m_cubics.push_back({{from, from + (1.0 / 3) * (to - from), to - (1.0 / 3) * (to - from), to}});
            return;
        }
        Point along = directionOf(between->slope);
        if (!(dot(along, to - from) > 0)) // Where the field jumps slopes say little.
            along = (1 / way) * (to - from);
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
