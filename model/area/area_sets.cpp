#include "model/area/area_sets.h"

#include "model/area/boundary.h"
#include "model/area/offset_curve.h"

#include <map>
#include <optional>

namespace suffuse {

namespace {

using Loops = std::vector<std::vector<Cubic>>;

Cubic turnedAround(const Cubic &c)
{
    return {{c.p[3], c.p[2], c.p[1], c.p[0]}};
}

/// Walks along a boundary with the inside always on the same side. Arcs and flats that meet do so in equal numbers, and
/// as many of them lead to a place as lead away from it, so each walk comes back to its start.
class BoundaryWalk {
public:
    explicit BoundaryWalk(const AreaBoundary &boundary)
    {
        for (const BoundaryArc &part : boundary.arcs)
            m_ways.push_back(part.enters > 0 ? part.arc.curve : turnedAround(part.arc.curve));
        for (const BoundaryFlat &flat : boundary.flats)
            for (int i = 0; i < std::abs(flat.jump); ++i) {
                const Point left{flat.left, flat.y}, right{flat.right, flat.y};
                m_ways.push_back(flat.jump > 0 ? straightCubic(right, left) : straightCubic(left, right));
            }
        m_walked.resize(m_ways.size());
        leaveOutSlits();
        for (std::size_t i = m_ways.size(); i-- > 0;) // The first ones are taken first.
            if (!m_walked[i])
                m_from[keyOf(m_ways[i].p[0])].push_back(i);
    }

    Loops loops()
    {
        Loops loops;
        for (std::size_t i = 0; i < m_ways.size(); ++i)
            if (!m_walked[i])
                loops.push_back(from(i));
        return loops;
    }

private:
    using Key = std::pair<double, double>;
    static Key keyOf(Point p) { return {p.y + 0.0, p.x + 0.0}; } // −0 is 0.

    /// What leads there and back on the same curve encloses nothing.
    void leaveOutSlits()
    {
        const auto pointsOf = [](const Cubic &c) {
            std::array<Key, 4> points;
            for (std::size_t i = 0; i < 4; ++i)
                points[i] = keyOf(c.p[i]);
            return points;
        };
        std::map<std::array<Key, 4>, std::vector<std::size_t>> open;
        for (std::size_t i = 0; i < m_ways.size(); ++i) {
            const auto back = open.find(pointsOf(turnedAround(m_ways[i])));
            if (back == open.end() || back->second.empty()) {
                open[pointsOf(m_ways[i])].push_back(i);
                continue;
            }
            m_walked[i] = m_walked[back->second.back()] = true;
            back->second.pop_back();
        }
    }

    std::vector<Cubic> from(std::size_t first)
    {
        std::vector<Cubic> loop;
        const Key home = keyOf(m_ways[first].p[0]);
        for (std::optional<std::size_t> way = first; way; way = next(m_ways[*way].p[3], home)) {
            m_walked[*way] = true;
            loop.push_back(m_ways[*way]);
        }
        return loop;
    }
    std::optional<std::size_t> next(Point at, const Key &home)
    {
        if (keyOf(at) == home)
            return {};
        std::vector<std::size_t> &ways = m_from[keyOf(at)];
        while (!ways.empty() && m_walked[ways.back()])
            ways.pop_back();
        return ways.empty() ? std::nullopt : std::optional(ways.back());
    }

    std::vector<Cubic> m_ways;
    std::vector<bool> m_walked;
    std::map<Key, std::vector<std::size_t>> m_from;
};

Area areaWhere(const Loops &loops, int least, AreaEffort *effort)
{
    return {BoundaryWalk(boundaryWhere(loops, least, effort)).loops()};
}

Loops together(Loops loops, const Loops &others)
{
    loops.insert(loops.end(), others.begin(), others.end());
    return loops;
}

bool areApart(const Area &a, const Area &b)
{
    return a.isEmpty() || b.isEmpty() || !a.box().intersects(b.box());
}

} // namespace

Rect Area::box() const
{
    Rect box;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &curve : loop)
            box = box.united(curve.controlBox());
    return box;
}

std::size_t Area::curves() const
{
    std::size_t count = 0;
    for (const std::vector<Cubic> &loop : loops)
        count += loop.size();
    return count;
}

double sizeOf(const Area &area)
{
    double twice = 0;
    for (const std::vector<Cubic> &loop : area.loops)
        for (const Cubic &c : loop)
            for (const double place : {-1.0, 0.0, 1.0}) { // Gauss: exact for the fifth degree
                const double t = 0.5 + place * std::sqrt(0.15);
                twice += (place == 0 ? 8.0 / 18 : 5.0 / 18) * cross(c.at(t), c.derivative(t));
            }
    return 0.5 * std::abs(twice);
}

Area areaOf(const Loops &loops, FillRule rule, AreaEffort *effort)
{
    return {BoundaryWalk(boundaryOf(loops, rule, effort)).loops()};
}

// The winding numbers of two areas add up, and that of an area whose loops run the other way is subtracted.

Area intersection(const Area &a, const Area &b, AreaEffort *effort)
{
    return areApart(a, b) ? Area() : areaWhere(together(a.loops, b.loops), 2, effort);
}

Area difference(const Area &a, const Area &b, AreaEffort *effort)
{
    if (areApart(a, b))
        return a;
    Loops hole;
    for (const std::vector<Cubic> &loop : b.loops) {
        hole.emplace_back();
        for (auto it = loop.rbegin(); it != loop.rend(); ++it)
            hole.back().push_back(turnedAround(*it));
    }
    return areaWhere(together(a.loops, hole), 1, effort);
}

Area united(const Area &a, const Area &b, AreaEffort *effort)
{
    return areaWhere(together(a.loops, b.loops), 1, effort);
}

Area exclusion(const Area &a, const Area &b, AreaEffort *effort)
{
    return areaOf(together(a.loops, b.loops), FillRule::EvenOdd, effort);
}

} // namespace suffuse
