#include "model/formats/svg/svg_paths.h"

#include "model/formats/svg/svg_frame.h"
#include "model/formats/svg/svg_gradient.h"
#include "model/formats/svg/svg_outlines.h"
#include "model/formats/svg/svg_shapes.h"
#include "model/formats/svg/svg_style.h"
#include "model/shaping/transform.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse {

namespace {

constexpr int deepestNesting = 256;
constexpr int deepestGroups = 32;
constexpr int mostDrawn = 200'000; ///< the greatest number of elements, including those of every <use>
constexpr int mostCopied = 50'000; ///< the greatest number of elements among these that a <use> repeats
constexpr std::size_t mostCurvesInAll = 2'000'000;
constexpr double tolerance = 0.005;              ///< of outlines, canvas units
constexpr std::uint64_t mostSteps = 300'000'000; ///< for the areas of all strokes, about a second

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

bool isOnlyDefined(const QString &element)
{
    static const std::set<QString> names{"defs",   "clipPath", "mask",  "pattern", "marker",
                                         "symbol", "metadata", "title", "desc",    "style"};
    return names.contains(element);
}

bool mayHaveMarkers(const QString &element)
{
    return element == QLatin1String("path") || element == QLatin1String("line") ||
           element == QLatin1String("polyline") || element == QLatin1String("polygon");
}

Rect boxOf(const std::vector<PenLine> &lines)
{
    Rect box;
    for (const PenLine &line : lines)
        for (const Cubic &curve : line.curves)
            box = box.united(curveBox(curve));
    return box;
}

/// The view box of the document, or its size.
Rect viewportOf(const SvgTree &tree)
{
    if (tree.root().children.empty())
        return {};
    const QXmlStreamAttributes &root = tree.root().children.front()->attributes;
    if (const Rect viewBox = svgViewBox(root); !viewBox.isEmpty())
        return viewBox;
    return Rect::of(0, 0, svgLength(root.value(QLatin1String("width")).toString()).value_or(0),
                    svgLength(root.value(QLatin1String("height")).toString()).value_or(0));
}

/// Collects what a document draws.
class Drawing {
public:
    explicit Drawing(SvgTree &tree) : m_tree(tree), m_viewport(viewportOf(tree)) {}

    SvgDrawing draw()
    {
        if (!m_tree.root().children.empty())
            takeSize(m_out, m_tree.root().children.front()->attributes);
        for (const auto &root : m_tree.root().children) {
            SvgStyle around;
            around.units.width = m_viewport.width(), around.units.height = m_viewport.height();
            const SvgStyle style = SvgStyle::of(*root, around, m_tree.sheet());
            if (root->name == QLatin1String("svg") && style.isDisplayed)
                drawChildren(*root, style, {});
            else
                draw(*root, around, {});
        }
        SvgLosses &losses = m_out.losses;
        for (const SvgElement *definition : m_lost)
            ++countOf(definition->name);
        losses.cycles = int(m_cycles.size());
        losses.rules = m_tree.sheet().unread();
        losses.isCut = losses.isCut || m_tree.isCut();
        dissolveGroups(m_out);
        return std::move(m_out);
    }

private:
    /// Where an element is drawn in the tree of groups, and how deep.
    struct Place {
        int depth = 0, groupDepth = 0, group = -1;
        bool isCopy = false;
        QString name; ///< the name of the <use> that draws it
    };

    int &countOf(const QString &definition)
    {
        SvgLosses &losses = m_out.losses;
        return definition.endsWith(QLatin1String("Gradient")) ? losses.gradients
               : definition == QLatin1String("pattern")       ? losses.patterns
               : definition == QLatin1String("clipPath")      ? losses.clipPaths
               : definition == QLatin1String("mask")          ? losses.masks
               : definition == QLatin1String("marker")        ? losses.markers
                                                              : losses.filters;
    }

    /// Notes that a definition of a kind is used and cannot be shown, if it exists.
    void lose(const QString &reference, const char *kind)
    {
        const SvgElement *definition = m_tree.find(svgReference(reference));
        if (definition && definition->name == QLatin1String(kind))
            m_lost.insert(definition);
    }

    void drawChildren(const SvgElement &element, const SvgStyle &style, const Place &place)
    {
        for (const auto &child : element.children)
            if (!isOnlyDefined(child->name))
                draw(*child, style, place);
    }

    bool isTooMuch(const Place &place)
    {
        m_drawn += 1, m_copied += place.isCopy ? 1 : 0;
        const bool tooMuch =
            place.depth > deepestNesting || m_drawn > mostDrawn || m_copied > mostCopied || m_curves > mostCurvesInAll;
        m_out.losses.isCut = m_out.losses.isCut || tooMuch;
        return tooMuch;
    }

    void draw(const SvgElement &element, const SvgStyle &parent, Place place)
    {
        if (isTooMuch(place))
            return;
        ++place.depth;
        const SvgStyle style = SvgStyle::of(element, parent, m_tree.sheet());
        if (!style.isDisplayed)
            return;
        const auto is = [&element](const char *name) { return element.name == QLatin1String(name); };
        const std::size_t before = m_out.paths.size();
        if (is("use"))
            use(element, style, place);
        else if (is("text"))
            m_out.losses.texts += style.isVisible ? 1 : 0;
        else if (is("image") || is("foreignObject"))
            m_out.losses.images += style.isVisible ? 1 : 0;
        else if (const QString data = svgPathData(element.name, element.attributes, style.units); !data.isEmpty())
            addShape(element, style, data, place);
        else if (is("g") || is("a") || is("svg") || is("switch"))
            drawGroup(element, is("svg") ? inViewport(element, style, element) : style, place);
        if (m_out.paths.size() > before)
            for (const auto &[reference, kind] :
                 {std::pair(style.clipPath, "clipPath"), {style.mask, "mask"}, {style.filter, "filter"}})
                lose(reference, kind);
    }

    void drawGroup(const SvgElement &element, const SvgStyle &style, Place place)
    {
        if (place.groupDepth < deepestGroups) {
            m_out.groups.push_back({place.name.isEmpty() ? element.givenName() : place.name, place.group});
            place.group = int(m_out.groups.size()) - 1;
            ++place.groupDepth;
        }
        place.name.clear();
        drawChildren(element, style, place);
    }

    /// The style inside a nested <svg> or a <symbol>, which has a rectangle of its own. `placing` says where that is,
    /// and `element` what of it is shown.
    static SvgStyle inViewport(const SvgElement &element, SvgStyle style, const SvgElement &placing)
    {
        const auto length = [&](const char *name) {
            const std::optional<double> given = svgLength(placing.attribute(name));
            return given ? given : svgLength(element.attribute(name));
        };
        if (&placing == &element)
            style.matrix = style.matrix * SvgMatrix{1, 0, 0, 1, length("x").value_or(0), length("y").value_or(0)};
        const Rect viewBox = svgViewBox(element.attributes);
        if (viewBox.isEmpty())
            return style;
        const Rect port =
            Rect::of(0, 0, length("width").value_or(viewBox.width()), length("height").value_or(viewBox.height()));
        style.matrix = style.matrix * svgViewport(viewBox, port, element.attribute("preserveAspectRatio"));
        return style;
    }

    void use(const SvgElement &element, SvgStyle style, Place place)
    {
        const SvgElement *target = m_tree.target(element);
        if (element.isCycle)
            m_cycles.insert(&element);
        if (!target || element.isCycle)
            return;
        const auto at = [&element](const char *name) { return svgLength(element.attribute(name)).value_or(0); };
        style.matrix = style.matrix * SvgMatrix{1, 0, 0, 1, at("x"), at("y")};
        place.isCopy = true;
        place.name = element.givenName();
        if (target->name != QLatin1String("symbol")) {
            draw(*target, style, place);
            return;
        }
        const SvgStyle own = SvgStyle::of(*target, style, m_tree.sheet());
        if (!isTooMuch(place) && own.isDisplayed)
            drawGroup(*target, inViewport(*target, own, element),
                      {place.depth + 1, place.groupDepth, place.group, true, place.name});
    }

    void addShape(const SvgElement &element, const SvgStyle &style, const QString &data, const Place &place)
    {
        const SvgPaint stroke = svgPaint(style.stroke, style.strokeOpacity * style.opacity, style.current, m_tree);
        const SvgPaint fill = svgPaint(style.fill, style.fillOpacity * style.opacity, style.current, m_tree);
        const bool hasStroke = stroke.colour && style.pen.width > 0;
        if (!style.isVisible || (!hasStroke && !fill.colour))
            return;
        const std::vector<PenLine> lines = svgLines(data);
        for (const PenLine &line : lines)
            if (m_curves += 1 + line.curves.size(); m_curves > mostCurvesInAll) {
                m_out.losses.isCut = true;
                return;
            }
        Look look{boxOf(lines), style, {}};
        look.path.name = place.name.isEmpty() ? element.givenName() : place.name;
        look.path.group = place.group;
        if (mayHaveMarkers(element.name))
            for (const QString &marker : style.markers)
                lose(marker, "marker");
        if (const SvgLoops loops = svgLoops(lines, style.matrix);
            fill.colour && std::ranges::any_of(loops, enclosesArea))
            addArea(loops, style.isEvenOdd, fill, style.fillOpacity, look);
        if (hasStroke)
            addStroke(lines, stroke, look);
    }

    /// What a shape's fill and stroke have in common.
    struct Look {
        Rect box; ///< in user units
        const SvgStyle &style;
        SvgPath path; ///< with its name and group
    };

    /// A stroke that cannot be a stroke of a painting is the area that its pen covers.
    void addStroke(const std::vector<PenLine> &lines, const SvgPaint &paint, const Look &look)
    {
        const SvgStyle &style = look.style;
        if (paint.replaced || !isRoundStroke(lines, style)) {
            AreaEffort effort(m_effort.left() / 4);
            const std::optional<Area> area = svgPenArea(lines, style, tolerance / m_out.scale, effort);
            m_effort.spend(m_effort.left() / 4 - effort.left());
            if (area && (m_curves += area->curves()) <= mostCurvesInAll) {
                if (!area->isEmpty())
                    addArea(area->loops, false, paint, style.strokeOpacity, look);
                return;
            }
            ++m_out.losses.outlines;
            if (paint.replaced)
                m_lost.insert(paint.replaced);
        }
        for (PenLine &line : svgMapped(lines, style.matrix)) {
            if (line.curves.empty())
                continue;
            m_out.paths.push_back(look.path);
            m_out.paths.back().stroke = paint.colour;
            m_out.paths.back().strokeWidth = style.pen.width * (style.keepsWidth ? 1 : style.matrix.scale());
            m_out.paths.back().curves = std::move(line.curves);
        }
    }

    /// Shades of an area that lie over each other are a group.
    void addArea(const SvgLoops &loops, bool isEvenOdd, const SvgPaint &paint, double opacity, const Look &look)
    {
        SvgPath area = look.path;
        area.fill = paint.colour;
        area.isEvenOdd = isEvenOdd;
        for (const std::vector<Cubic> &loop : loops) {
            if (!area.curves.empty())
                area.chains.push_back(area.curves.size());
            area.curves.insert(area.curves.end(), loop.begin(), loop.end());
        }
        std::vector<SvgShade> shades;
        if (paint.replaced && paint.gradient)
            shades = svgShades(*paint.gradient, look.box, look.style.matrix, m_viewport, opacity * look.style.opacity,
                               look.style.current, m_tree);
        if (shades.empty()) {
            if (paint.replaced)
                m_lost.insert(paint.replaced);
            m_out.paths.push_back(std::move(area));
            return;
        }
        if (shades.size() > 1) {
            m_out.groups.push_back({area.name, area.group});
            area.group = int(m_out.groups.size()) - 1;
        }
        for (const SvgShade &shade : shades) {
            area.fill = shade.first;
            area.shade.reset();
            if (shade.first != shade.last)
                area.shade = {shade.from, shade.to, shade.last};
            if ((*area.fill)[3] > 0 || area.shade)
                m_out.paths.push_back(area);
        }
    }

    SvgTree &m_tree;
    const Rect m_viewport; ///< what per cents count by
    SvgDrawing m_out;
    std::set<const SvgElement *> m_lost, m_cycles;
    int m_drawn = 0, m_copied = 0;
    std::size_t m_curves = 0;
    AreaEffort m_effort{mostSteps};
};

} // namespace

Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes)
{
    QXmlStreamReader xml(bytes);
    SvgTree tree;
    if (const QString problem = tree.read(xml); !problem.isEmpty())
        return Error{QCoreApplication::translate("SvgPaths", "SVG, line %1: %2").arg(xml.lineNumber()).arg(problem)};
    return Drawing(tree).draw();
}

Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes)
{
    Result<SvgDrawing> drawing = readSvgDrawing(bytes);
    if (!drawing)
        return Error{drawing.error()};
    for (SvgPath &path : drawing->paths)
        path.group = -1;
    return std::move(drawing->paths);
}

} // namespace suffuse
