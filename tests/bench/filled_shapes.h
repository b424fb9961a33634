// Paintings of filled shapes for benches, on a sheet of 1024 × 768.
#pragma once

#include "model/painting/painting.h"

#include <numbers>
#include <random>

namespace suffuse::baseline {

inline void addCurve(Stroke &stroke, const std::array<Point, 4> &points, bool start)
{
    Segment g;
    for (std::size_t i = 0; i < 4; ++i)
        g.bezier[i] = toOffset(points[i], {});
    g.density = 0;
    g.start = start && !stroke.segments.empty();
    if (!start)
        g.bezier[0] = stroke.segments.back().bezier[3];
    stroke.segments.push_back(g);
}

/// A closed outline of curves around a point, whose distance from it changes by a share.
inline void addBlob(Stroke &stroke, Point centre, double radius, int segments, double uneven, std::mt19937 &random)
{
    std::uniform_real_distribution<double> u(1 - uneven, 1 + uneven);
    const double angle = 2 * std::numbers::pi / segments, handle = 4.0 / 3 * std::tan(angle / 4);
    const auto on = [&](double r, double a) { return centre + r * Point{std::cos(a), std::sin(a)}; };
    double from = radius * u(random);
    const double first = from;
    for (int k = 0; k < segments; ++k) {
        const double to = k + 1 == segments ? first : radius * u(random), a = k * angle, b = a + angle;
        const Point p = on(from, a), q = on(to, b);
        addCurve(stroke,
                 {p, p + handle * from * Point{-std::sin(a), std::cos(a)},
                  q - handle * to * Point{-std::sin(b), std::cos(b)}, q},
                 k == 0);
        from = to;
    }
}

inline Stroke filled(StrokeId id, double spread, StyleKind kind = StyleKind::Uniform)
{
    Stroke s;
    s.id = id;
    if (kind == StyleKind::Edge)
        s.style = {kind, {0.36f, 0.40f, 0.5f}};
    Fill fill;
    fill.diffusion = float(spread * spread / 4);
    fill.colour = {float(id % 7) / 7, float(id % 5) / 5, float(id % 3) / 3, 0.8f};
    s.fill = fill;
    return s;
}

inline PaintingPtr filledPainting(std::vector<Stroke> strokes)
{
    auto p = std::make_shared<Painting>();
    p->canvas.width = 1024, p->canvas.height = 768;
    for (Stroke &s : strokes)
        p->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
    return p;
}

/// A disc that nearly fills the sheet.
inline PaintingPtr disc(double spread)
{
    std::mt19937 random(1);
    Stroke s = filled(1, spread);
    addBlob(s, {512, 384}, 400, 4, 0, random);
    return filledPainting({s});
}

/// Many small shapes all over the sheet, a third of them with dark edges.
inline PaintingPtr shapes(int count, int segments, double spread)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Stroke> strokes;
    for (int k = 0; k < count; ++k) {
        Stroke s = filled(StrokeId(k + 1), spread, k % 3 == 0 ? StyleKind::Edge : StyleKind::Uniform);
        addBlob(s, {1024 * u(random), 768 * u(random)}, 10 + 20 * u(random), segments, 0.3, random);
        strokes.push_back(s);
    }
    return filledPainting(std::move(strokes));
}

/// An outline that is as uneven as its segments are long or, if `jagged`, a hundred times as much.
inline PaintingPtr coast(int segments, double spread, bool jagged = false)
{
    std::mt19937 random(3);
    Stroke s = filled(1, spread);
    addBlob(s, {512, 384}, 350, segments, jagged ? 3e-3 : 3e-5, random);
    return filledPainting({s});
}

/// The curves of a hand that scribbles all over the sheet, closed at the end: bends of some 40 px that cross what was
/// drawn before.
inline std::vector<Cubic> scribbleCurves(int segments)
{
    std::mt19937 random(4);
    std::normal_distribution<double> u(0, 1);
    constexpr double step = 12;
    double angle = 0, bend = 0;
    Point at{512, 384};
    std::vector<Cubic> curves;
    for (int k = 0; k < segments; ++k) {
        bend = 0.9 * bend + 0.1 * u(random);
        const Point toMiddle = Point{512, 384} - at;
        const double away = std::remainder(std::atan2(toMiddle.y, toMiddle.x) - angle, 2 * std::numbers::pi);
        const double next = angle + bend + (length(toMiddle) > 320 ? 0.2 * away : 0);
        const auto to = [](double a) { return Point{std::cos(a), std::sin(a)}; };
        Point end = at + step * to(0.5 * (angle + next));
        if (k + 1 == segments)
            end = curves.front().p[0];
        curves.push_back({{at, at + step / 3 * to(angle), end - step / 3 * to(next), end}});
        at = end, angle = next;
    }
    return curves;
}

/// A filled scribble, which crosses itself all over.
inline PaintingPtr scribble(int segments, double spread)
{
    Stroke s = filled(1, spread);
    bool start = true;
    for (const Cubic &curve : scribbleCurves(segments)) {
        addCurve(s, {curve.p[0], curve.p[1], curve.p[2], curve.p[3]}, start);
        start = false;
    }
    return filledPainting({s});
}

} // namespace suffuse::baseline
