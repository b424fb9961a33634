#include "model/shaping/nodes/node_path.h"

#include "model/area/offset_curve.h"

#include <cmath>
#include <numbers>

namespace suffuse {

std::vector<Cubic> curvesThrough(const std::vector<PathNode> &nodes, bool isClosed)
{
    std::vector<Cubic> curves;
    const auto add = [&curves](const PathNode &a, const PathNode &b) {
        const bool isStraight = a.out == a.at && b.in == b.at;
        curves.push_back(isStraight ? straightCubic(a.at, b.at) : Cubic{{a.at, a.out, b.in, b.at}});
    };
    for (std::size_t i = 1; i < nodes.size(); ++i)
        add(nodes[i - 1], nodes[i]);
    if (isClosed && !nodes.empty() && (nodes.size() > 1 || nodes.front().out != nodes.front().in))
        add(nodes.back(), nodes.front());
    return curves;
}

Point inSteps(Point origin, Point place)
{
    constexpr double step = std::numbers::pi / 12;
    const Point way = place - origin;
    const double angle = step * std::round(std::atan2(way.y, way.x) / step);
    return origin + length(way) * Point{std::cos(angle), std::sin(angle)};
}

} // namespace suffuse
