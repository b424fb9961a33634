#include "model/geometry/affine.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double evenness = 1e-12; // relative rounding errors that a similarity may have

} // namespace

Affine Affine::about(Point fixed, double a, double b, double c, double d)
{
    Affine map{a, b, c, d, {}};
    map.offset = fixed - map.turned(fixed);
    return map;
}

Affine Affine::rotation(Point fixed, double angle)
{
    // Quarter turns must be exact.
    const double quarters = angle / (0.5 * 3.14159265358979323846);
    double c = std::cos(angle), s = std::sin(angle);
    if (std::abs(quarters - std::round(quarters)) < 1e-15 * std::max(1.0, std::abs(quarters))) {
        c = std::round(c);
        s = std::round(s);
    }
    return about(fixed, c, -s, s, c);
}

Affine Affine::between(const Rect &from, const Rect &to)
{
    Affine map;
    map.a = from.width() > 0 ? to.width() / from.width() : 1;
    map.d = from.height() > 0 ? to.height() / from.height() : 1;
    map.offset = {to.left - map.a * from.left, to.top - map.d * from.top};
    return map;
}

bool Affine::isSimilarity() const
{
    const double size = std::max({std::abs(a), std::abs(b), std::abs(c), std::abs(d)});
    const auto none = [size](double x, double y) { return std::abs(x) + std::abs(y) <= evenness * size; };
    return none(a - d, b + c) || none(a + d, b - c);
}

std::optional<Affine> Affine::inverse() const
{
    const double det = determinant();
    if (det == 0 || !std::isfinite(1 / det))
        return std::nullopt;
    Affine map{d / det, -b / det, -c / det, a / det, {}};
    map.offset = -1.0 * map.turned(offset);
    return map;
}

Affine operator*(const Affine &after, const Affine &before)
{
    const Point x = after.turned({before.a, before.c}), y = after.turned({before.b, before.d});
    return {x.x, y.x, x.y, y.y, after(before.offset)};
}

} // namespace suffuse
