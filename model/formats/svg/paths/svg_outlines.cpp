#include "model/formats/svg/paths/svg_outlines.h"

#include "model/area/offset_curve.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/transform.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// Whether a matrix stretches by the same factor in all directions.
bool isEven(const SvgMatrix &m)
{
    const double size = std::max({std::abs(m.a), std::abs(m.b), std::abs(m.c), std::abs(m.d)});
    return (std::abs(m.a - m.d) <= 1e-6 * size && std::abs(m.b + m.c) <= 1e-6 * size) ||
           (std::abs(m.a + m.d) <= 1e-6 * size && std::abs(m.b - m.c) <= 1e-6 * size);
}

/// Whether a line goes on without a corner from one curve to the next.
bool isSmooth(const Cubic &before, const Cubic &after)
{
    const Point a = endDirection(before), b = startDirection(after);
    return dot(a, b) > 0 && std::abs(cross(a, b)) < 0.02;
}

bool hasCorners(const PenLine &line)
{
    for (std::size_t k = 1; k < line.curves.size(); ++k)
        if (!isSmooth(line.curves[k - 1], line.curves[k]))
            return true;
    return line.isClosed && !line.curves.empty() && !isSmooth(line.curves.back(), line.curves.front());
}

} // namespace

bool isReckonable(Point p)
{
    constexpr double most = 1e15;
    return std::abs(p.x) < most && std::abs(p.y) < most; // not so for what is no number
}

std::vector<PenLine> svgMapped(std::vector<PenLine> lines, const SvgMatrix &matrix)
{
    std::erase_if(lines, [&matrix](PenLine &line) {
        line.point = matrix.map(line.point);
        bool isFine = isReckonable(line.point);
        for (Cubic &curve : line.curves)
            for (Point &p : curve.p) {
                p = matrix.map(p);
                isFine = isFine && isReckonable(p);
            }
        return !isFine;
    });
    return lines;
}

SvgLoops svgLoops(const std::vector<PenLine> &lines, const SvgMatrix &matrix)
{
    SvgLoops loops;
    for (PenLine &line : svgMapped(lines, matrix))
        if (!line.curves.empty())
            loops.push_back(std::move(line.curves));
    return loops;
}

SvgLoops svgClosed(SvgLoops loops)
{
    for (std::vector<Cubic> &loop : loops)
        if (const Point last = loop.back().p[3]; last != loop.front().p[0])
            loop.push_back(straightCubic(last, loop.front().p[0]));
    return loops;
}

Rect svgBox(const std::vector<PenLine> &lines)
{
    Rect box;
    for (const PenLine &line : lines)
        for (const Cubic &curve : line.curves)
            box = box.united(curveBox(curve));
    return box;
}

std::vector<PenLine> svgLinesOf(const Rect &box)
{
    PenLine line;
    const Point a{box.left, box.top}, b{box.right, box.top}, c{box.right, box.bottom}, d{box.left, box.bottom};
    line.curves = {straightCubic(a, b), straightCubic(b, c), straightCubic(c, d), straightCubic(d, a)};
    return {line};
}

void closeLine(PenLine &line)
{
    if (const auto &c = line.curves; !line.isClosed && !c.empty() && c.back().p[3] != c.front().p[0])
        line.curves.push_back(straightCubic(c.back().p[3], c.front().p[0]));
    line.isClosed = true;
}

bool isRoundStroke(const std::vector<PenLine> &lines, const SvgStyle &style)
{
    const Pen &pen = style.pen;
    if (std::ranges::any_of(pen.dashes, [](double length) { return length > 0; }) ||
        !(style.keepsWidth || isEven(style.matrix)))
        return false;
    return std::ranges::all_of(lines, [&pen](const PenLine &line) {
        return !line.curves.empty() && (line.isClosed || pen.cap == LineCap::Round) &&
               (pen.join == LineJoin::Round || !hasCorners(line));
    });
}

std::optional<Area> svgPenArea(const std::vector<PenLine> &lines, const SvgStyle &style, double tolerance,
                               AreaEffort &effort)
{
    const SvgMatrix &m = style.matrix;
    // The pen is moved in user units, and what it covers is mapped.
    const std::vector<PenLine> own = svgMapped(lines, style.keepsWidth ? m : SvgMatrix());
    const double stretch = style.keepsWidth ? 1 : std::max(std::hypot(m.a, m.b), std::hypot(m.c, m.d));
    if (own.size() != lines.size() || !isReckonable({style.pen.width, stretch}) || !(stretch > 1e-12))
        return {};
    SvgLoops loops = penOutline(own, style.pen, tolerance / stretch, &effort);
    for (std::vector<Cubic> &loop : loops)
        for (Cubic &curve : loop)
            for (Point &p : curve.p) {
                p = style.keepsWidth ? p : m.map(p);
                if (!isReckonable(p))
                    return {};
            }
    Area area = areaOf(loops, FillRule::NonZero, &effort);
    return effort.isSpent() ? std::nullopt : std::optional(std::move(area));
}

} // namespace suffuse
