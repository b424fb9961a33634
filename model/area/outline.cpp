#include "model/area/outline.h"

namespace suffuse {

namespace {

Cubic straightLine(Point a, Point b)
{
    return {{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b}};
}

bool hasExtent(const Cubic &c)
{
    return c.p[1] != c.p[0] || c.p[2] != c.p[0] || c.p[3] != c.p[0];
}

/// On which sides of a window a curve passes by, as bits.
unsigned passedSides(const Cubic &curve, const Rect &window)
{
    const Rect box = curve.controlBox();
    return (box.right < window.left ? 1u : 0u) | (box.left > window.right ? 2u : 0u) |
           (box.bottom < window.top ? 4u : 0u) | (box.top > window.bottom ? 8u : 0u);
}

} // namespace

std::vector<std::vector<Cubic>> shortenedAround(const Rect &window, const std::vector<std::vector<Cubic>> &loops)
{
    std::vector<std::vector<Cubic>> out;
    for (const std::vector<Cubic> &loop : loops) {
        std::vector<Cubic> shortened;
        for (std::size_t k = 0; k < loop.size();) {
            std::size_t end = k;
            for (unsigned sides = ~0u; end < loop.size() && (sides &= passedSides(loop[end], window)) != 0;)
                ++end;
            if (end < k + 2) {
                shortened.push_back(loop[k++]);
                continue;
            }
            if (const Cubic line = straightLine(loop[k].p[0], loop[end - 1].p[3]); hasExtent(line))
                shortened.push_back(line);
            k = end;
        }
        if (!shortened.empty())
            out.push_back(std::move(shortened));
    }
    return out;
}

std::vector<std::vector<Cubic>> closedOutline(const Stroke &stroke)
{
    std::vector<std::vector<Cubic>> loops;
    std::vector<Cubic> loop;
    const auto add = [&](const Cubic &curve) {
        if (!loop.empty() && loop.back().p[3] != curve.p[0])
            loop.push_back(straightLine(loop.back().p[3], curve.p[0]));
        if (hasExtent(curve))
            loop.push_back(curve);
    };
    const auto close = [&] {
        if (loop.empty())
            return;
        if (loop.back().p[3] != loop.front().p[0])
            loop.push_back(straightLine(loop.back().p[3], loop.front().p[0]));
        loops.push_back(std::move(loop));
        loop.clear();
    };
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        if (stroke.beginsChain(k))
            close();
        if (!stroke.segments[k].takesPaint())
            add(offsetsOf(stroke.segments[k]));
    }
    close();
    return loops;
}

Rect outlineBox(const Stroke &stroke)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint())
            for (const Offset &o : segment.bezier)
                box.include(Point() + o);
    return box;
}

bool onlyBounds(const Stroke &stroke, std::size_t segment)
{
    const Segment &s = stroke.segments[segment];
    return stroke.fill && !s.takesPaint() && !(s.density > 0);
}

bool isFillAlone(const Stroke &stroke)
{
    return stroke.fill &&
           std::ranges::all_of(stroke.segments, [](const Segment &s) { return s.takesPaint() || !(s.density > 0); });
}

bool sameOutline(const Stroke &a, const Stroke &b)
{
    const auto same = [](const Segment &s, const Segment &t) {
        return s.bezier == t.bezier && s.start == t.start && s.takesPaint() == t.takesPaint();
    };
    return std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(), same);
}

} // namespace suffuse
