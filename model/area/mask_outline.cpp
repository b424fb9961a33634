// The outlines of masks.
#include "model/area/mask.h"
#include "model/shaping/curves/curve_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double maskTolerance = 0.75;           ///< pixels
constexpr std::size_t arm = 5;                   ///< points on both sides that say how a way turns
constexpr double sharp = 0.3 * std::numbers::pi; ///< a way that turns so much within its arms has a corner

/// Walks around pixels along their sides, with what is 1 on the right hand.
class MaskWalk {
public:
    explicit MaskWalk(const Mask &mask) : m_mask(mask), m_walked(mask.pixels.size()) {}

    /// The middles of the sides of each closed way, in its order.
    std::vector<std::vector<Point>> ways()
    {
        std::vector<std::vector<Point>> ways;
        for (int y = 0; y < m_mask.height; ++y)
            for (int x = 0; x < m_mask.width; ++x)
                if (isTop(x, y) && !m_walked[m_mask.index(x, y)])
                    ways.push_back(from(x, y));
        return ways;
    }

private:
    bool isTop(int x, int y) const { return m_mask.at(x, y) && !m_mask.at(x, y - 1); }

    /// Begins with the upper side of a pixel, which is walked to the right. Each way has such a side.
    std::vector<Point> from(int startX, int startY)
    {
        constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        std::vector<Point> way;
        int x = startX, y = startY, direction = 0; // the corner where a side begins
        do {
            const int dx = steps[std::size_t(direction)][0], dy = steps[std::size_t(direction)][1];
            if (direction == 0)
                m_walked[m_mask.index(x, y)] = true;
            way.push_back({x + 0.5 * dx, y + 0.5 * dy});
            x += dx, y += dy;
            direction = turn(x, y, direction);
        } while (x != startX || y != startY || direction != 0);
        std::reverse(way.begin(), way.end()); // so that it winds once around what is 1
        return way;
    }

    /// The direction in which the way goes on from a corner between four pixels.
    int turn(int x, int y, int direction) const
    {
        // The pixels around a corner, to the right below, left below, left above and right above.
        const bool around[] = {m_mask.at(x, y), m_mask.at(x - 1, y), m_mask.at(x - 1, y - 1), m_mask.at(x, y - 1)};
        // Going on in a direction, the pixel to the right is around[direction], that to the left around[direction + 3].
        for (const int turned : {1, 0, 3}) { // to the right first
            const int next = (direction + turned) % 4;
            if (around[next] && !around[(next + 3) % 4])
                return next;
        }
        return (direction + 2) % 4;
    }

    const Mask &m_mask;
    std::vector<bool> m_walked; ///< of pixels whose upper side was walked along
};

double enclosedBy(const std::vector<Point> &way)
{
    double twice = 0;
    for (std::size_t i = 0; i < way.size(); ++i)
        twice += cross(way[i], way[(i + 1) % way.size()]);
    return 0.5 * std::abs(twice);
}

/// The corner of the pixels at a point of a way, where the way turns there.
Point sharpened(const std::vector<Point> &way, std::size_t i)
{
    const std::size_t n = way.size();
    const Point from = way[(i + n - arm) % n], chord = way[(i + arm) % n] - from;
    Point best = way[i];
    for (const std::size_t first : {(i + n - 1) % n, i}) {
        const Point a = way[first], b = way[(first + 1) % n];
        const bool isLevel = a.y == std::round(a.y);
        const Point corner = isLevel ? Point{b.x, a.y} : Point{a.x, b.y};
        if (std::abs(cross(chord, corner - from)) > std::abs(cross(chord, best - from)))
            best = corner;
    }
    return best;
}

/// The points without the steps of the pixels: means of neighbours on both sides, as many as there are up to the ends.
std::vector<Point> withoutSteps(const std::vector<Point> &points, bool isClosed)
{
    constexpr std::size_t most = 4;
    const std::size_t n = points.size();
    std::vector<Point> smooth(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t each = isClosed ? std::min(most, (n - 2) / 2) : std::min({most, i, n - 1 - i});
        Point sum = points[i];
        for (std::size_t k = 1; k <= each; ++k) // The last point of a closed way is the first one.
            sum = sum + points[(i + k) % (n - (isClosed ? 1 : 0))] + points[(i + (n - 1) - k) % (n - 1)];
        smooth[i] = (1 / double(2 * each + 1)) * sum;
    }
    return smooth;
}

std::vector<Cubic> smoothAlong(const std::vector<Point> &way)
{
    const std::size_t n = way.size();
    const std::vector<std::size_t> corners = cornersOfWay(way, arm, sharp);
    if (corners.empty()) {
        std::vector<Point> points(way.begin(), way.end());
        points.push_back(way.front());
        points = withoutSteps(points, true);
        const std::size_t near = std::min(arm, n / 3);
        const Point across = points[near] - points[n - near];
        const Point direction = (1 / std::max(length(across), 1e-300)) * across; // at the begin, which is the end
        return cubicsThrough(points, direction, direction, maskTolerance);
    }
    std::vector<Cubic> curves;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::size_t from = corners[c], to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
        std::vector<Point> points{sharpened(way, from)};
        for (std::size_t i = from + 1; i < to; ++i)
            points.push_back(way[i % n]);
        points.push_back(sharpened(way, to % n));
        for (const Cubic &curve : cubicsThrough(withoutSteps(points, false), {}, {}, maskTolerance))
            curves.push_back(curve);
    }
    return curves;
}

} // namespace

std::vector<std::vector<Cubic>> outlinesOf(const Mask &mask, double least)
{
    std::vector<std::vector<Cubic>> loops;
    for (const std::vector<Point> &way : MaskWalk(mask).ways())
        if (enclosedBy(way) >= least)
            loops.push_back(smoothAlong(way));
    return loops;
}

} // namespace suffuse
