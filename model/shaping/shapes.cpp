#include "model/shaping/shapes.h"

#include "model/brush/brush_width.h"

#include <cmath>

namespace suffuse {

namespace {

constexpr double quarter = 0.5 * std::numbers::pi;

Cubic straight(Point a, Point b)
{
    return {{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b}};
}

/// The way from a to b that leaves towards `corner` and arrives from it, as a quarter of a circle does at a square's.
Cubic roundCorner(Point a, Point corner, Point b)
{
    constexpr double reach = 0.5522847498307936; // 4/3·(√2 − 1)
    return {{a, a + reach * (corner - a), b + reach * (corner - b), b}};
}

/// A closed way through corners, of which each is cut off by so much of its sides' halves and rounded.
std::vector<Cubic> throughCorners(const std::vector<Point> &corners, const std::vector<double> &cut)
{
    std::vector<Cubic> curves;
    const std::size_t n = corners.size();
    const auto towards = [&](std::size_t i, std::size_t j) {
        return corners[i] + (0.5 * cut[i]) * (corners[j] - corners[i]);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        if (cut[i] < 1 || cut[next] < 1)
            curves.push_back(straight(towards(i, next), towards(next, i)));
        if (cut[next] > 0)
            curves.push_back(roundCorner(towards(next, i), corners[next], towards(next, (next + 1) % n)));
    }
    return curves;
}

std::vector<Cubic> rectangle(const ShapeForm &form, Point a, Point b)
{
    const double left = std::min(a.x, b.x), right = std::max(a.x, b.x);
    const double top = std::min(a.y, b.y), bottom = std::max(a.y, b.y);
    const double radius = std::clamp(form.radius, 0.0, 0.5 * std::min(right - left, bottom - top));
    if (radius == 0)
        return throughCorners({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, {0, 0, 0, 0});
    // The radius is the same on sides of different lengths, so the corners are not cut by shares.
    std::vector<Cubic> curves;
    const auto side = [&](Point from, Point to) {
        if (from != to)
            curves.push_back(straight(from, to));
    };
    side({left + radius, top}, {right - radius, top});
    curves.push_back(roundCorner({right - radius, top}, {right, top}, {right, top + radius}));
    side({right, top + radius}, {right, bottom - radius});
    curves.push_back(roundCorner({right, bottom - radius}, {right, bottom}, {right - radius, bottom}));
    side({right - radius, bottom}, {left + radius, bottom});
    curves.push_back(roundCorner({left + radius, bottom}, {left, bottom}, {left, bottom - radius}));
    side({left, bottom - radius}, {left, top + radius});
    curves.push_back(roundCorner({left, top + radius}, {left, top}, {left + radius, top}));
    return curves;
}

std::vector<Cubic> ellipse(const ShapeForm &form, Point a, Point b)
{
    const Point middle = 0.5 * (a + b), r{0.5 * std::abs(b.x - a.x), 0.5 * std::abs(b.y - a.y)};
    const double sweep = std::clamp(form.sweep, 0.0, 4 * quarter);
    const int count = std::max(1, int(std::ceil(sweep / quarter - 1e-9)));
    const double step = sweep / count, reach = 4.0 / 3 * std::tan(step / 4);
    const auto at = [&](double angle, double along) { // a point of the ellipse and so much of its derivative
        return middle + Point{r.x * (std::cos(angle) - along * std::sin(angle)),
                              r.y * (std::sin(angle) + along * std::cos(angle))};
    };
    std::vector<Cubic> curves;
    for (int i = 0; i < count; ++i) {
        const double from = form.from + i * step, to = from + step;
        curves.push_back({{i == 0 ? at(from, 0) : curves.back().p[3], at(from, reach), at(to, -reach), at(to, 0)}});
    }
    const Point start = curves.front().p[0], end = curves.back().p[3];
    if (sweep >= 4 * quarter - 1e-9) {
        curves.back().p[3] = start;
    } else if (form.isPie) {
        curves.push_back(straight(end, middle));
        curves.push_back(straight(middle, start));
    } else {
        curves.push_back(straight(end, start));
    }
    return curves;
}

std::vector<Cubic> polygon(const ShapeForm &form, Point middle, Point tip)
{
    const bool isStar = form.kind == ShapeKind::Star;
    const int tips = std::clamp(form.corners, ShapeForm::leastCorners, ShapeForm::mostCorners);
    const int count = isStar ? 2 * tips : tips;
    const Point arm = tip - middle;
    std::vector<Point> corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 4 * quarter * i / count;
        const double share = isStar && i % 2 == 1 ? std::clamp(form.inner, 0.01, 1.0) : 1;
        const double c = share * std::cos(angle), s = share * std::sin(angle);
        corners.push_back(middle + Point{c * arm.x - s * arm.y, s * arm.x + c * arm.y});
    }
    return throughCorners(corners, std::vector<double>(corners.size(), std::clamp(form.rounding, 0.0, 1.0)));
}

/// Whether a curve goes on in the direction in which the one before it has arrived.
bool goesOn(const Cubic &before, const Cubic &next)
{
    const Point in = before.derivative(1), out = next.derivative(0);
    const double lengths = length(in) * length(out);
    return lengths > 0 && in.x * out.x + in.y * out.y >= (1 - 1e-9) * lengths;
}

} // namespace

std::vector<Cubic> outlineOf(const ShapeForm &form, Point a, Point b)
{
    if (isFromMiddle(form.kind) ? a == b : a.x == b.x || a.y == b.y)
        return {};
    switch (form.kind) {
    case ShapeKind::Rectangle:
        return rectangle(form, a, b);
    case ShapeKind::Ellipse:
        return ellipse(form, a, b);
    case ShapeKind::Polygon:
    case ShapeKind::Star:
        break;
    }
    return polygon(form, a, b);
}

Stroke strokeAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born)
{
    Stroke stroke;
    stroke.id = id;
    stroke.style = brush.style;
    stroke.mix = brush.mix;
    stroke.brush = brush.name;
    if (!curves.empty())
        stroke.origin = curves.front().p[0];
    Segment segment = valuesAtFullPressure(brush);
    segment.born = born;
    const Cubic *before = curves.empty() || curves.front().p[0] != curves.back().p[3] ? nullptr : &curves.back();
    for (const Cubic &curve : curves) {
        for (std::size_t i = 0; i < 4; ++i)
            segment.bezier[i] = toOffset(curve.p[i], stroke.origin);
        if (!stroke.segments.empty())
            segment.bezier[0] = stroke.segments.back().bezier[3];
        if (std::ranges::all_of(segment.bezier, [&](Offset o) { return o == segment.bezier[0]; }))
            continue;
        segment.node = before && goesOn(*before, curve) ? NodeKind::Smooth : NodeKind::Corner;
        stroke.segments.push_back(segment);
        before = &curve;
    }
    return stroke;
}

} // namespace suffuse
