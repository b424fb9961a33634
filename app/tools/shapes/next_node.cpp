#include "app/tools/shapes/next_node.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

void NextNode::type(Number number, double value)
{
    const bool isWay = number == Number::Length || number == Number::Angle;
    for (const Number other : isWay ? std::array{Number::X, Number::Y} : std::array{Number::Length, Number::Angle})
        forget(other);
    m_typed[std::size_t(number)] = value;
}

bool NextNode::isAnyTyped() const
{
    return std::ranges::any_of(m_typed, [](const auto &number) { return number.has_value(); });
}

bool NextNode::needsPointer(bool isFirst) const
{
    return !isAnyTyped() || (isFirst && !(typed(Number::X) && typed(Number::Y)));
}

Point NextNode::place(Point pointed, std::optional<Point> from) const
{
    if (!from || !isWayTyped())
        return {typed(Number::X).value_or(pointed.x), typed(Number::Y).value_or(pointed.y)};
    const Point way = pointed - *from;
    const double angle = typed(Number::Angle).value_or(std::atan2(way.y, way.x));
    return *from + typed(Number::Length).value_or(length(way)) * Point{std::cos(angle), std::sin(angle)};
}

} // namespace suffuse
