// Filled strokes for the render tests.
#pragma once

#include "tests/render/erasing/lifted.h"

namespace suffuse::test {

/// A segment that bounds a fill and lays no paint.
inline Segment bound(std::array<Point, 4> points)
{
    Segment g;
    for (std::size_t i = 0; i < 4; ++i)
        g.bezier[i] = toOffset(points[i], {});
    g.density = 0;
    return g;
}

inline Segment boundLine(Point a, Point b)
{
    return bound({a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b});
}

/// Adds a chain of straight lines that a fill closes.
inline void addPolygon(Stroke &stroke, const std::vector<Point> &corners)
{
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        Segment g = boundLine(corners[k], corners[k + 1]);
        g.start = k == 0 && !stroke.segments.empty();
        if (k > 0)
            g.bezier[0] = stroke.segments.back().bezier[3];
        stroke.segments.push_back(g);
    }
}

inline void addRectangle(Stroke &stroke, const Rect &r, bool reversed = false)
{
    std::vector<Point> corners{{r.left, r.top}, {r.right, r.top}, {r.right, r.bottom}, {r.left, r.bottom}};
    if (reversed)
        std::reverse(corners.begin(), corners.end());
    addPolygon(stroke, corners);
}

/// Adds an ellipse, as near as four cubics come to one.
inline void addEllipse(Stroke &stroke, Point centre, double width, double height, bool reversed = false)
{
    constexpr double k = 0.5522847498307936;
    const auto at = [&](double x, double y) { return centre + Point{x * width, y * height}; };
    std::vector<std::array<Point, 4>> arcs{{at(1, 0), at(1, k), at(k, 1), at(0, 1)},
                                           {at(0, 1), at(-k, 1), at(-1, k), at(-1, 0)},
                                           {at(-1, 0), at(-1, -k), at(-k, -1), at(0, -1)},
                                           {at(0, -1), at(k, -1), at(1, -k), at(1, 0)}};
    if (reversed) {
        std::reverse(arcs.begin(), arcs.end());
        for (auto &arc : arcs)
            std::reverse(arc.begin(), arc.end());
    }
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        Segment g = bound(arcs[i]);
        g.start = i == 0 && !stroke.segments.empty();
        if (i > 0)
            g.bezier[0] = stroke.segments.back().bezier[3];
        stroke.segments.push_back(g);
    }
}

/// A stroke without segments, filled with density 1 and a spread at full age.
inline Stroke emptyFill(StrokeId id, double spread, const Style &style, Colour colour = {0.1f, 0.7f, 0.9f, 0.9f})
{
    Stroke s;
    s.id = id;
    s.style = style;
    Fill fill;
    fill.diffusion = float(spread * spread / 4);
    fill.colour = colour;
    s.fill = fill;
    return s;
}

template <class Change>
void changeFill(Stroke &stroke, Change change)
{
    Fill fill = *stroke.fill;
    change(fill);
    stroke.fill = fill;
}

/// Random outlines of curves and lines that cross themselves, some with holes, gradients, tensors, both rules, paint on
/// their outline, and lifted paint.
inline Stroke randomFill(std::mt19937_64 &random, StrokeId id, double width, double height, double spread)
{
    std::uniform_real_distribution<double> u(0, 1);
    const auto channel = [&] { return float(u(random)); };
    Stroke s = emptyFill(id, spread, randomStyle(random), {channel(), channel(), channel(), channel()});
    if (random() % 2)
        s.mix = {MixMode::Beta, channel()};
    const auto anywhere = [&] { return Point{width * (1.4 * u(random) - 0.2), height * (1.4 * u(random) - 0.2)}; };
    for (std::uint64_t chains = 1 + random() % 3; chains > 0; --chains) {
        const std::uint64_t kind = random() % 4;
        if (kind == 0) {
            addEllipse(s, anywhere(), width * 0.5 * u(random), height * 0.5 * u(random), random() % 2);
        } else if (kind == 1) {
            const Point a = anywhere();
            addRectangle(s, Rect::of(a.x, a.y, width * 0.5 * u(random), height * 0.5 * u(random)), random() % 2);
        } else {
            Point at = anywhere();
            const std::size_t first = s.segments.size();
            for (std::uint64_t k = 2 + random() % 5; k > 0; --k) {
                const Point to = anywhere();
                Segment g = kind == 2 ? boundLine(at, to) : bound({at, anywhere(), anywhere(), to});
                if (s.segments.size() > first)
                    g.bezier[0] = s.segments.back().bezier[3];
                else
                    g.start = first > 0;
                s.segments.push_back(g);
                at = to;
            }
        }
    }
    const bool painted = random() % 3 == 0;
    for (Segment &g : s.segments) {
        g.diffusion = float(4 + 8 * u(random));
        if (painted)
            g.density = float(4 * u(random));
        g.colour = {channel(), channel(), channel(), channel()};
    }
    changeFill(s, [&](Fill &f) {
        f.density = float(0.6 + u(random));
        f.rule = FillRule(random() % 2);
        f.granulation = random() % 3 ? 1 : channel();
        if (random() % 3 == 0)
            f.gradient = {toOffset(anywhere(), {}), toOffset(anywhere(), {}), {channel(), channel(), channel(), 1}};
        if (random() % 4 == 0)
            f.anisotropyRatio = float(std::exp2(6 * u(random) - 3)), f.anisotropyAngle = float(3 * u(random));
    });
    if (random() % 4 == 0)
        (id % 3 == 0 ? fadeAlong : liftAlong)(s, anywhere(), anywhere(), 4 * spread + 1, 0.3 + u(random), 4);
    return s;
}

/// Fills of all kinds and some strokes without.
inline PaintingPtr mixedFills(std::mt19937_64 &random, int fills, double width, double height, PaperKind paper)
{
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Stroke> strokes = randomStrokes(random, 2, width, height);
    for (int k = 0; k < fills; ++k) {
        const double spread = random() % 4 == 0 ? 1e-4 : 1.5 * std::pow(10, u(random));
        strokes.push_back(randomFill(random, StrokeId(k + 10), width, height, spread));
    }
    return painting(std::move(strokes), width, height, {paper, 1, 16, 0.7f, {}});
}

/// The painting with another stroke at a place.
inline PaintingPtr withStroke(const PaintingPtr &p, std::size_t index, const Stroke &s)
{
    auto q = std::make_shared<Painting>(*p);
    q->strokes[index] = std::make_shared<const Stroke>(s);
    return q;
}

/// One random edit of a fill: of its outline, its values, or whether there is one.
inline PaintingPtr withEditedFill(const PaintingPtr &p, std::mt19937_64 &random)
{
    std::uniform_real_distribution<double> u(0, 1);
    const std::size_t j = random() % p->strokes.size();
    Stroke s = *p->strokes[j];
    if (!s.fill || random() % 12 == 0) {
        s.fill = s.fill ? SharedFill() : SharedFill(Fill{});
        return withStroke(p, j, s);
    }
    const std::size_t k = random() % s.segments.size();
    Segment &g = s.segments[k];
    switch (random() % 8) {
    case 0:
    case 1: // a node
        if (!s.beginsChain(k)) {
            const Offset to{g.bezier[0].x + float(10 * u(random) - 5), g.bezier[0].y + float(10 * u(random) - 5)};
            g.bezier[0] = s.segments[k - 1].bezier[3] = to;
        }
        break;
    case 2:
        g.bezier[1].x += float(6 * u(random));
        break;
    case 3:
        changeFill(s, [&](Fill &f) { f.density *= float(0.8 + 0.4 * u(random)); });
        break;
    case 4:
        changeFill(s, [&](Fill &f) { f.colour.red = float(u(random)); });
        break;
    case 5:
        changeFill(s, [&](Fill &f) { f.rule = FillRule(1 - int(f.rule)); });
        break;
    case 6:
        changeFill(s, [&](Fill &f) { f.born += 100'000; });
        break;
    case 7:
        s.origin.x += double(random() % 3);
        break;
    }
    return withStroke(p, j, s);
}

} // namespace suffuse::test
