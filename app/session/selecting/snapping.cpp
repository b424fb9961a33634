#include "app/session/selecting/snapping.h"

#include "model/shaping/nodes/reshape.h"

#include <limits>

namespace suffuse {

Snapping::Snapping(const Painting &painting, const CanvasAids &aids, const LeftOut &leftOut)
    : m_step(aids.snapToGrid ? aids.gridStep : 0)
{
    if (!aids.snapToNodes)
        return;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isVisible(*stroke))
            continue;
        for (int k = 0; k < nodeCount(*stroke); ++k)
            if (!leftOut || !leftOut(*stroke, k))
                m_nodes.push_back(nodePosition(*stroke, k));
    }
}

Snapping::Snapping(const Painting &painting, const CanvasAids &aids, const std::vector<Guide> &guides,
                   const LeftOut &leftOut)
    : Snapping(painting, aids, leftOut)
{
    if (aids.showGuides && aids.snapToGuides)
        m_guides = guides;
}

const Point *Snapping::nearestNode(Point point, double limit, double *distance) const
{
    const Point *nearest = nullptr;
    double least = limit * limit;
    for (const Point &node : m_nodes) {
        const Point d = node - point;
        if (const double squared = dot(d, d); squared < least) {
            least = squared;
            nearest = &node;
        }
    }
    if (nearest)
        *distance = std::sqrt(least);
    return nearest;
}

double Snapping::toLine(double v, bool upright) const
{
    double way = m_step > 0 ? m_step * std::round(v / m_step) - v : std::numeric_limits<double>::infinity();
    for (const Guide &guide : m_guides)
        if (guide.upright == upright && std::abs(guide.place - v) < std::abs(way))
            way = guide.place - v;
    return way;
}

Snap Snapping::snap(Point point, const View &view, double dpr) const
{
    const Snap move = snapMove({point}, {}, view, dpr);
    return {point + move.point, move.to};
}

Snap Snapping::snapMove(const std::vector<Point> &points, Point by, const View &view, double dpr, Point *at) const
{
    const double limit = reach * dpr / view.scale;
    Snap best{by};
    double least = limit;
    for (const Point &point : points) {
        const Point *node = nearestNode(point + by, least, &least);
        if (!node)
            continue;
        best = {*node - point, SnapTo::Node};
        if (at)
            *at = *node;
    }
    if (best.to != SnapTo::Nothing || (!(m_step > 0) && m_guides.empty()))
        return best;
    // There are lines across and lines down. Along each axis the point that is nearest to a line decides.
    double dx = limit, dy = limit;
    Point mark = points.empty() ? by : points.front() + by;
    for (const Point &point : points) {
        const Point moved = point + by;
        if (const double d = toLine(moved.x, true); std::abs(d) < std::abs(dx)) {
            dx = d;
            mark.x = moved.x + d;
        }
        if (const double d = toLine(moved.y, false); std::abs(d) < std::abs(dy)) {
            dy = d;
            mark.y = moved.y + d;
        }
    }
    if (dx == limit && dy == limit)
        return best;
    if (at)
        *at = mark;
    return {by + Point{dx == limit ? 0 : dx, dy == limit ? 0 : dy}, SnapTo::Line};
}

} // namespace suffuse
