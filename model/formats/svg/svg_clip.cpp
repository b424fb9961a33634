#include "model/formats/svg/svg_clip.h"

#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/paths/svg_shapes.h"
#include "model/shaping/transform.h"

namespace suffuse {

namespace {

constexpr int deepestClip = 8;           ///< clip paths that are clipped by others
constexpr std::size_t mostAreas = 1'000; ///< that are kept for the next element

/// The rectangle that an area is, if it is one.
std::optional<Rect> rectOf(const Area &area)
{
    const Rect box = area.box();
    const bool isRect = area.loops.size() == 1 && area.curves() <= 8 && box.width() > 0 && box.height() > 0 &&
                        sizeOf(area) >= (1 - 1e-12) * box.width() * box.height();
    return isRect ? std::optional(box) : std::nullopt;
}

} // namespace

SvgClipPtr SvgClips::both(const SvgClipPtr &outer, Area area)
{
    if (outer)
        area = intersection(outer->area, area, &m_effort);
    if (m_effort.isSpent())
        return outer;
    const std::optional<Rect> rect = rectOf(area);
    return std::make_shared<const SvgClip>(SvgClip{std::move(area), rect});
}

SvgClipPtr SvgClips::within(const SvgClipPtr &outer, const Rect &port, const SvgMatrix &matrix)
{
    const std::vector<PenLine> lines = svgLines(QStringLiteral("M%1 %2H%3V%4H%1Z")
                                                    .arg(port.left, 0, 'g', 17)
                                                    .arg(port.top, 0, 'g', 17)
                                                    .arg(port.right, 0, 'g', 17)
                                                    .arg(port.bottom, 0, 'g', 17));
    return both(outer, areaOf(svgClosed(svgLoops(lines, matrix)), FillRule::NonZero, &m_effort));
}

SvgClipPtr SvgClips::within(const SvgClipPtr &outer, const SvgElement &clipPath, const SvgStyle &style,
                            const std::function<Rect()> &boxOf)
{
    std::optional<Area> area = areaOfPath(clipPath, style, boxOf, 0);
    return area ? both(outer, std::move(*area)) : outer;
}

/// No value if the effort is spent.
std::optional<Area> SvgClips::areaOfPath(const SvgElement &clipPath, const SvgStyle &style,
                                         const std::function<Rect()> &boxOf, int depth)
{
    if (m_effort.isSpent())
        return {};
    if (depth > deepestClip) // It clips itself, which shows nothing.
        return Area();
    SvgStyle around; // Nothing is inherited from what is clipped.
    around.matrix = style.matrix, around.units = style.units;
    SvgStyle own = SvgStyle::of(clipPath, around, m_tree.sheet());
    if (clipPath.attribute("clipPathUnits") == QLatin1String("objectBoundingBox")) {
        const Rect box = boxOf();
        if (box.isEmpty())
            return Area();
        own.matrix = own.matrix * SvgMatrix{box.width(), 0, 0, box.height(), box.left, box.top};
        own.units.width = own.units.height = 1;
    }
    const SvgMatrix &m = own.matrix;
    const Key key{&clipPath, {m.a, m.b, m.c, m.d, m.e, m.f}};
    if (const auto known = m_found.find(key); known != m_found.end())
        return known->second;
    SvgLoops loops;
    for (const auto &child : clipPath.children) {
        const std::optional<Area> area = areaOfChild(*child, own, depth);
        if (!area)
            return {};
        loops.insert(loops.end(), area->loops.begin(), area->loops.end());
    }
    Area area = areaOf(loops, FillRule::NonZero, &m_effort);
    if (const SvgElement *further = m_tree.find(svgReference(own.clipPath));
        further && further->name == QLatin1String("clipPath")) {
        const std::optional<Area> bound = areaOfPath(*further, style, boxOf, depth + 1);
        if (!bound)
            return {};
        area = intersection(area, *bound, &m_effort);
    }
    if (m_effort.isSpent())
        return {};
    if (m_found.size() < mostAreas)
        m_found.emplace(key, area);
    return area;
}

/// A shape, or the letters of a text.
std::vector<PenLine> SvgClips::linesOf(const SvgElement &shape, const SvgStyle &style)
{
    if (shape.name != QLatin1String("text"))
        return svgLines(svgPathData(shape.name, shape.attributes, style.units));
    std::vector<PenLine> lines;
    if (const std::optional<SvgSetText> set = m_texts.set(shape, style))
        for (const SvgLetter &letter : set->letters)
            lines.insert(lines.end(), letter.lines.begin(), letter.lines.end());
    return lines;
}

/// What a shape in a clip path, or one that is used there, adds to it.
std::optional<Area> SvgClips::areaOfChild(const SvgElement &child, const SvgStyle &around, int depth)
{
    SvgStyle style = SvgStyle::of(child, around, m_tree.sheet());
    if (!style.isDisplayed)
        return Area();
    const SvgElement *shape = &child;
    SvgStyle own = style;
    if (child.name == QLatin1String("use")) {
        shape = m_tree.target(child);
        if (!shape || child.isCycle)
            return Area();
        const auto at = [&](const char *name, SvgAxis axis) {
            return svgLength(child.attribute(name), style.units, axis).value_or(0);
        };
        SvgStyle placed = style;
        placed.matrix = placed.matrix * SvgMatrix{1, 0, 0, 1, at("x", SvgAxis::Across), at("y", SvgAxis::Down)};
        own = SvgStyle::of(*shape, placed, m_tree.sheet());
    }
    const std::vector<PenLine> lines = linesOf(*shape, own);
    if (!own.isDisplayed || !own.isVisible)
        return Area();
    Area area = areaOf(svgClosed(svgLoops(lines, own.matrix)),
                       own.isClipEvenOdd ? FillRule::EvenOdd : FillRule::NonZero, &m_effort);
    std::vector<const SvgStyle *> clipped{&own};
    if (shape != &child)
        clipped.push_back(&style);
    for (const SvgStyle *by : clipped) {
        const SvgElement *further = m_tree.find(svgReference(by->clipPath));
        if (!further || further->name != QLatin1String("clipPath"))
            continue;
        const std::optional<Area> bound = areaOfPath(
            *further, *by, [&] { return svgBox(lines); }, depth + 1);
        if (!bound)
            return {};
        area = intersection(area, *bound, &m_effort);
    }
    return area;
}

} // namespace suffuse
