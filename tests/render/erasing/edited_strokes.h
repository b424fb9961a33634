// Long strokes as pens make them, and what of their nodes an edit leaves as it is, for the render tests.
#pragma once

#include "render/nodes/blocks.h"
#include "render/nodes/node_builder.h"
#include "render/scene/scene.h"
#include "tests/render/erasing/lifted.h"

namespace suffuse::test {

/// What varies along a stroke beside its points and its density.
enum class Varies { Nothing, Colours, Gradient, Granulation, Spread, Tensors };
inline constexpr Varies allVarieties[] = {Varies::Nothing,     Varies::Colours, Varies::Gradient,
                                          Varies::Granulation, Varies::Spread,  Varies::Tensors};

/// A pen's way over an area, to and fro in bows, of so many short segments and of a spread in units.
inline Stroke penStroke(std::mt19937_64 &random, const Rect &area, int segments, double spread, const Style &style,
                        Varies what)
{
    std::uniform_real_distribution<double> u(0, 1);
    const double phase = 6.28 * u(random), passes = 3 + 3 * u(random);
    const auto at = [&](double k) {
        const double along = k / segments, across = std::sin(6.28 * passes * along + phase);
        return Point{area.left + area.width() * (0.5 + 0.5 * across) + std::sin(0.7 * k),
                     area.top + area.height() * (along + 0.05 * std::cos(9 * along + phase)) + std::cos(0.9 * k)};
    };
    Stroke s;
    s.id = 1;
    s.style = style;
    Offset last = toOffset(at(0), {});
    for (int k = 0; k < segments; ++k) {
        Segment g;
        const Point a = Point() + last, b = at(k + 1);
        g.bezier = {last, toOffset(a + (1.0 / 3) * (b - a), {}),
                    toOffset(a + (2.0 / 3) * (b - a) + Point{0.1, -0.1}, {}), toOffset(b, {})};
        last = g.bezier[3];
        const double own = what == Varies::Spread && k % 20 > 12 ? spread * (1 + 0.02 * (k % 20)) : spread;
        g.diffusion = float(own * own / 4);
        g.density = float((0.7 + 0.3 * std::sin(0.3 * k)) * double(style.xi[0]) * std::sqrt(std::numbers::pi) * own);
        g.colour = {0.1f, 0.7f, 0.9f, 0.9f};
        if (what == Varies::Colours)
            g.colour = {float(u(random)), float(u(random)), float(u(random)), float(0.5 + 0.5 * u(random))};
        if (what == Varies::Gradient)
            g.colour.red = float(k) / float(segments);
        if (what == Varies::Granulation)
            g.granulation = float(0.5 + 0.4 * std::sin(0.1 * k));
        if (what == Varies::Tensors && k % 70 > 62)
            g.anisotropyRatio = 3, g.anisotropyAngle = 0.4f;
        g.born = k * 5000;
        g.maxAge = 0.5f;
        s.segments.push_back(g);
    }
    return s;
}

/// Whether two groups stand for the same paint, to the bit.
inline bool isSameGroup(const StrokeNodes &a, const NodeGroup &g, const StrokeNodes &b, const NodeGroup &h)
{
    const auto rows = [](const NodeGroup &x) { return x.rowPerNode ? x.end - x.begin : 1; };
    return std::equal(a.nodes.begin() + g.begin, a.nodes.begin() + g.end, b.nodes.begin() + h.begin,
                      b.nodes.begin() + h.end) &&
           std::equal(a.rows.begin() + g.row, a.rows.begin() + g.row + rows(g), b.rows.begin() + h.row,
                      b.rows.begin() + h.row + rows(h)) &&
           std::equal(a.reaches.begin() + g.reachBegin, a.reaches.begin() + g.reachEnd,
                      b.reaches.begin() + h.reachBegin, b.reaches.begin() + h.reachEnd);
}

/// The groups of `a` that `b` does not have.
inline std::vector<NodeGroup> groupsOnlyIn(const StrokeNodes &a, const StrokeNodes &b)
{
    std::vector<NodeGroup> only;
    for (const NodeGroup &g : a.groups)
        if (std::ranges::none_of(b.groups, [&](const NodeGroup &h) { return isSameGroup(a, g, b, h); }))
            only.push_back(g);
    return only;
}

/// What an edit of a stroke changed.
struct EditReach {
    std::size_t farthest = 0;     ///< segments between a segment whose nodes changed and the nearest that was edited
    std::vector<PixelRect> areas; ///< where groups that came or went can be seen
};

/// `edited`: segments of the old stroke that are not in the new one as they were. All segments can be seen, and are
/// either all dry or all wet.
inline EditReach reachOfEdit(const Stroke &before, const Stroke &after, const std::vector<std::size_t> &edited,
                             Microseconds time, const View &view)
{
    const int octave = zoomOctave(view.scale);
    const auto a = buildNodes(before, time, octave, visibleBox(PictureGrid::ofPicture(view)));
    const auto b = buildNodes(after, time, octave, visibleBox(PictureGrid::ofPicture(view)));
    EditReach reach;
    for (const NodeGroup &g : groupsOnlyIn(*a, *b)) {
        reach.areas.push_back(pixelBounds(*a, g, before.origin, PictureGrid::ofPicture(view)));
        for (std::uint32_t k = g.reachBegin; k < g.reachEnd; ++k) { // a reach for each segment
            std::size_t nearest = before.segments.size();
            for (const std::size_t e : edited)
                nearest = std::min(nearest, e > k ? e - k : k - e);
            reach.farthest = std::max(reach.farthest, nearest);
        }
    }
    for (const NodeGroup &g : groupsOnlyIn(*b, *a))
        reach.areas.push_back(pixelBounds(*b, g, after.origin, PictureGrid::ofPicture(view)));
    return reach;
}

/// How many pixels differ that lie in none of the areas.
inline int pixelsChangedOutside(const FloatPicture &a, const FloatPicture &b, const std::vector<PixelRect> &areas)
{
    std::vector<char> inside(std::size_t(a.width) * std::size_t(a.height), 0);
    for (const PixelRect &r : areas)
        for (int y = r.y; y < r.y + r.height; ++y)
            std::fill_n(inside.begin() + std::ptrdiff_t(y) * a.width + r.x, r.width, char(1));
    int changed = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            changed += !inside[std::size_t(y) * std::size_t(a.width) + std::size_t(x)] &&
                       !std::equal(a.at(x, y), a.at(x, y) + 4, b.at(x, y));
    return changed;
}

} // namespace suffuse::test
