#include "model/formats/svg/svg_painter.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace suffuse {

namespace {

constexpr std::size_t mostCurvesInAll = 2'000'000;
constexpr double exactness = 0.005; ///< of outlines, canvas units

/// Whether curves do not all lie on one straight line.
bool enclosesArea(const std::vector<Cubic> &curves)
{
    const Point from = curves.front().p[0];
    Point farthest;
    const auto visit = [&](auto see) {
        for (const Cubic &cubic : curves)
            for (const Point &p : cubic.p)
                see(p - from);
    };
    visit([&](Point arm) { farthest = length(arm) > length(farthest) ? arm : farthest; });
    double widest = 0;
    visit([&](Point arm) { widest = std::max(widest, std::abs(farthest.x * arm.y - farthest.y * arm.x)); });
    return widest > 1e-9 * (farthest.x * farthest.x + farthest.y * farthest.y);
}

void setLoops(SvgPath &path, const SvgLoops &loops)
{
    path.curves.clear(), path.chains.clear();
    for (const std::vector<Cubic> &loop : loops) {
        if (!path.curves.empty())
            path.chains.push_back(path.curves.size());
        path.curves.insert(path.curves.end(), loop.begin(), loop.end());
    }
}

SvgLoops loopsOf(const SvgPath &path)
{
    SvgLoops loops(1);
    for (std::size_t k = 0; k < path.curves.size(); ++k) {
        if (std::ranges::binary_search(path.chains, k))
            loops.emplace_back();
        loops.back().push_back(path.curves[k]);
    }
    return loops;
}

Rect boxOf(const SvgLoops &loops)
{
    return Area{loops}.box();
}

/// How much of it lets through; of a shade the mean.
double opacityOf(const SvgPath &path)
{
    const double first = (path.stroke ? *path.stroke : *path.fill)[3];
    return path.shade ? 0.5 * (first + path.shade->colour[3]) : first;
}

void setOpacity(SvgPath &path, double factor)
{
    (path.stroke ? *path.stroke : *path.fill)[3] *= factor;
    if (path.shade)
        path.shade->colour[3] *= factor;
}

Rect reachOf(const SvgPath &path)
{
    return boxOf({path.curves}).grown(path.stroke ? 0.5 * path.strokeWidth : 0);
}

} // namespace

template <class Work>
auto SvgPainter::withEffort(Work work)
{
    const std::uint64_t part = m_effort.left() / 4;
    AreaEffort effort(part);
    auto result = work(effort);
    m_effort.spend(part - effort.left());
    m_out.losses.outlines += effort.isSpent() ? 1 : 0;
    return result;
}

bool SvgPainter::isFull() const
{
    return m_curves > mostCurvesInAll;
}

bool SvgPainter::countCurves(std::size_t curves)
{
    m_curves += curves;
    m_out.losses.isCut = m_out.losses.isCut || isFull();
    return !isFull();
}

double SvgPainter::tolerance() const
{
    return exactness / m_out.scale;
}

/// How finely gradients are divided: where a drawing has very many of them, the later ones are coarser, rather than
/// gone.
int SvgPainter::finestSteps() const
{
    return m_effort.left() > mostEffort / 2 ? 128 : m_effort.left() > mostEffort / 4 ? 64 : 0;
}

void SvgPainter::paint(const SvgShape &shape)
{
    if (!shape.style.isVisible || (shape.clip && shape.clip->area.isEmpty()))
        return;
    std::size_t curves = 0;
    for (const PenLine &line : shape.lines)
        curves += 1 + line.curves.size();
    if (!countCurves(curves))
        return;
    if (shape.isLetter)
        return paintParts(shape);
    // One shape is taken and moved as one thing: where it is several paths, they are a group. It comes before the
    // groups within it.
    const std::size_t before = m_out.paths.size(), group = m_out.groups.size();
    m_out.groups.push_back({shape.name, shape.group});
    SvgShape own = shape;
    own.group = int(group);
    paintParts(own);
    if (m_out.paths.size() - before > 1 || m_out.groups.size() - group > 1)
        return;
    m_out.groups.pop_back();
    for (std::size_t i = before; i < m_out.paths.size(); ++i)
        m_out.paths[i].group = shape.group;
}

void SvgPainter::paintParts(const SvgShape &shape)
{
    const QString &order = shape.style.order;
    const qsizetype fill = order.indexOf(QLatin1String("fill")), stroke = order.indexOf(QLatin1String("stroke"));
    const bool isStrokeFirst = stroke >= 0 && (fill < 0 || stroke < fill);
    if (isStrokeFirst)
        paintStroke(shape);
    paintFill(shape);
    if (!isStrokeFirst)
        paintStroke(shape);
}

void SvgPainter::paintFill(const SvgShape &shape)
{
    const SvgStyle &style = shape.style;
    const SvgPaint paint = svgPaint(style.inContext(style.fill), style.fillOpacity, style.current, m_tree);
    if (!paint.colour) {
        noteUnpainted(paint);
        return;
    }
    if (const SvgLoops loops = svgLoops(shape.lines, style.matrix); std::ranges::any_of(loops, enclosesArea))
        addArea(shape, loops, style.isEvenOdd, paint, style.fillOpacity);
}

/// A pattern that no colour takes the place of is lost all the same.
void SvgPainter::noteUnpainted(const SvgPaint &paint)
{
    if (paint.replaced && !paint.gradient)
        m_lost.insert(paint.replaced);
}

/// A stroke that cannot be a stroke of a painting is the area that its pen covers.
void SvgPainter::paintStroke(const SvgShape &shape)
{
    const SvgStyle &style = shape.style;
    const SvgPaint paint = svgPaint(style.inContext(style.stroke), style.strokeOpacity, style.current, m_tree);
    if (!(style.pen.width > 0))
        return;
    if (!paint.colour) {
        noteUnpainted(paint);
        return;
    }
    if (paint.replaced || !isRoundStroke(shape.lines, style) || !isWholeSeen(shape)) {
        const std::optional<Area> area =
            withEffort([&](AreaEffort &effort) { return svgPenArea(shape.lines, style, tolerance(), effort); });
        if (area) {
            if (!area->isEmpty() && countCurves(area->curves()))
                addArea(shape, area->loops, false, paint, style.strokeOpacity);
            return;
        }
        if (paint.replaced)
            m_lost.insert(paint.replaced);
    }
    for (PenLine &line : svgMapped(shape.lines, style.matrix)) {
        if (line.curves.empty())
            continue;
        SvgPath path;
        path.name = shape.name, path.group = shape.group, path.lead = shape.lead;
        path.stroke = paint.colour;
        path.strokeWidth = style.pen.width * (style.keepsWidth ? 1 : style.matrix.scale());
        path.curves = std::move(line.curves);
        m_out.paths.push_back(std::move(path));
    }
}

/// Whether a clip shows a stroke as far as its pen reaches.
bool SvgPainter::isWholeSeen(const SvgShape &shape)
{
    const SvgStyle &style = shape.style;
    const double reach = 0.5 * style.pen.width * (style.keepsWidth ? 1 : style.matrix.scale());
    if (!shape.clip || shape.clip->holds(svgBox(svgMapped(shape.lines, style.matrix)).grown(reach)))
        return true;
    const std::optional<Area> area =
        withEffort([&](AreaEffort &effort) { return svgPenArea(shape.lines, style, tolerance(), effort); });
    return area && !seenOf(area->loops, false, shape.clip);
}

/// What of an area a clip shows. No value if that is all of it.
std::optional<Area> SvgPainter::seenOf(const SvgLoops &loops, bool isEvenOdd, const SvgClipPtr &clip)
{
    if (!clip || clip->holds(boxOf(loops)))
        return {};
    return withEffort([&](AreaEffort &effort) {
        const Area whole = areaOf(svgClosed(loops), isEvenOdd ? FillRule::EvenOdd : FillRule::NonZero, &effort);
        const Area seen = intersection(whole, clip->area, &effort);
        const bool isAll = effort.isSpent() || sizeOf(seen) >= (1 - 1e-9) * sizeOf(whole);
        return isAll ? std::nullopt : std::optional(seen);
    });
}

void SvgPainter::addArea(const SvgShape &shape, const SvgLoops &whole, bool isEvenOdd, const SvgPaint &paint,
                         double opacity)
{
    const std::optional<Area> seen = seenOf(whole, isEvenOdd, shape.clip);
    const SvgLoops &loops = seen ? seen->loops : whole;
    if (loops.empty())
        return;
    SvgPath area;
    area.name = shape.name, area.group = shape.group, area.lead = shape.lead;
    area.fill = paint.colour;
    area.isEvenOdd = isEvenOdd && !seen;
    setLoops(area, loops);
    if (paint.replaced && paint.gradient) {
        const SvgStyle &style = shape.style;
        const std::optional<std::vector<SvgShade>> shades =
            svgShades({*paint.gradient, shape.box ? *shape.box : svgBox(shape.lines), style.matrix, style.units,
                       boxOf(loops), opacity, style.isFaded, finestSteps()},
                      m_tree);
        if (shades) {
            addShades(shape, area, loops, paint, *shades);
            return;
        }
    }
    if (paint.replaced)
        m_lost.insert(paint.replaced);
    m_out.paths.push_back(std::move(area));
}

/// Several shades of an area are a group. If they take too much work, the mean of their colours stands for them.
void SvgPainter::addShades(const SvgShape &shape, const SvgPath &area, const SvgLoops &loops, const SvgPaint &paint,
                           const std::vector<SvgShade> &shades)
{
    const auto work = [&](AreaEffort &effort) {
        std::vector<SvgPath> paths;
        std::optional<Area> whole;
        for (const SvgShade &shade : shades) {
            SvgPath path = area;
            path.fill = shade.first;
            if (shade.first != shade.last)
                path.shade = {shade.from, shade.to, shade.last};
            if (!((*path.fill)[3] > 0 || path.shade))
                continue;
            if (!shade.within.empty()) {
                if (!whole)
                    whole = areaOf(svgClosed(loops), area.isEvenOdd ? FillRule::EvenOdd : FillRule::NonZero, &effort);
                const Area part = intersection(*whole, areaOf(shade.within, FillRule::EvenOdd, &effort), &effort);
                if (effort.isSpent())
                    return std::vector<SvgPath>();
                if (part.isEmpty())
                    continue;
                const bool isAll = sizeOf(part) >= (1 - 1e-9) * sizeOf(*whole);
                if (isAll && shade.first[3] == 1 && shade.last[3] == 1) // What lies below is hidden.
                    paths.clear();
                if (!isAll) {
                    path.isEvenOdd = false;
                    setLoops(path, part.loops);
                }
            }
            paths.push_back(std::move(path));
        }
        return paths;
    };
    std::vector<SvgPath> paths = withEffort(work);
    std::size_t curves = 0;
    for (const SvgPath &path : paths)
        curves += path.curves.size();
    if (!shades.empty() && paths.empty()) {
        m_lost.insert(paint.replaced);
        m_out.paths.push_back(area);
        return;
    }
    if (!countCurves(curves))
        return;
    if (paths.size() > 1) {
        m_out.groups.push_back({shape.name, shape.group});
        for (SvgPath &path : paths)
            path.group = int(m_out.groups.size()) - 1;
    }
    for (SvgPath &path : paths)
        m_out.paths.push_back(std::move(path));
}

Area SvgPainter::areaOfPath(const SvgPath &path, AreaEffort &effort) const
{
    if (path.fill)
        return areaOf(svgClosed(loopsOf(path)), path.isEvenOdd ? FillRule::EvenOdd : FillRule::NonZero, &effort);
    const Pen pen{path.strokeWidth, LineCap::Round, LineJoin::Round, 4, {}, 0};
    return areaOf(penOutline({{path.curves, false, {}, {1, 0}}}, pen, tolerance(), &effort), FillRule::NonZero,
                  &effort);
}

/// Divides the paths behind the first ones where others of them lie over them, so that together they have an opacity.
/// Empty if the effort is spent.
std::vector<SvgPath> SvgPainter::faded(std::size_t first, double opacity, AreaEffort &effort)
{
    struct Piece {
        Area area;
        double through = 1; ///< how much of it is seen through what lies over it
    };
    const std::span<const SvgPath> paths = std::span(m_out.paths).subspan(first);
    std::vector<Rect> boxes;
    for (const SvgPath &path : paths)
        boxes.push_back(reachOf(path));
    std::vector<std::optional<Area>> areas(paths.size());
    const auto area = [&](std::size_t i) -> const Area & {
        if (!areas[i])
            areas[i] = areaOfPath(paths[i], effort);
        return *areas[i];
    };
    std::vector<SvgPath> result;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        std::vector<Piece> pieces;
        bool isDivided = false;
        for (std::size_t k = i + 1; k < paths.size() && effort.spend(2); ++k) {
            if (!boxes[i].intersects(boxes[k]))
                continue;
            if (pieces.empty() && !isDivided)
                pieces.push_back({area(i)});
            std::vector<Piece> next;
            for (Piece &piece : pieces) {
                Area under = intersection(piece.area, area(k), &effort);
                if (sizeOf(under) <= 1e-9 * sizeOf(piece.area)) {
                    next.push_back(std::move(piece));
                    continue;
                }
                isDivided = true;
                if (Area beside = difference(piece.area, area(k), &effort); !beside.isEmpty())
                    next.push_back({std::move(beside), piece.through});
                if (const double through = piece.through * (1 - opacityOf(paths[k])); through > 0)
                    next.push_back({std::move(under), through});
            }
            pieces = std::move(next);
        }
        if (effort.isSpent())
            return {};
        if (!isDivided) {
            result.push_back(paths[i]);
            setOpacity(result.back(), opacity);
        } else {
            if (paths[i].group >= 0) // Its letters are not what they were.
                m_out.groups[std::size_t(paths[i].group)].text = {};
            for (const Piece &piece : pieces) {
                result.push_back(paths[i]);
                SvgPath &path = result.back();
                if (path.stroke)
                    path.fill = std::exchange(path.stroke, std::nullopt);
                path.isEvenOdd = false;
                setLoops(path, piece.area.loops);
                // Together with the faded paint over it, it lets through as much as the group does.
                setOpacity(path, opacity * piece.through / (1 - opacity * (1 - piece.through)));
            }
        }
    }
    return result;
}

void SvgPainter::fade(std::size_t first, double opacity)
{
    std::vector<SvgPath> &paths = m_out.paths;
    if (!(opacity < 1) || first >= paths.size())
        return;
    const auto begin = paths.begin() + std::ptrdiff_t(first);
    if (!(opacity > 0)) {
        paths.erase(begin, paths.end());
        return;
    }
    std::vector<SvgPath> result = withEffort([&](AreaEffort &effort) { return faded(first, opacity, effort); });
    if (result.empty()) { // It is too much work.
        for (std::size_t i = first; i < paths.size(); ++i)
            setOpacity(paths[i], opacity);
        return;
    }
    for (const SvgPath &path : result)
        countCurves(path.curves.size());
    paths.erase(begin, paths.end());
    std::ranges::move(result, std::back_inserter(paths));
}

} // namespace suffuse
