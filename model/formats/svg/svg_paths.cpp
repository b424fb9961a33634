#include "model/formats/svg/svg_paths.h"

#include "model/formats/svg/svg_gradient.h"
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

/// The subpaths of path data under a matrix, without those that are not finite.
std::vector<std::vector<Cubic>> placed(const QString &data, const SvgMatrix &matrix)
{
    std::vector<std::vector<Cubic>> subpaths = parsePathData(data);
    std::erase_if(subpaths, [&matrix](std::vector<Cubic> &curves) {
        bool isFinite = true;
        for (Cubic &cubic : curves)
            for (Point &p : cubic.p) {
                p = matrix.map(p);
                isFinite = isFinite && std::isfinite(p.x) && std::isfinite(p.y);
            }
        return !isFinite;
    });
    return subpaths;
}

/// The box of path data.
Rect boxOf(const QString &data)
{
    Rect box;
    for (const std::vector<Cubic> &subpath : parsePathData(data))
        for (const Cubic &curve : subpath)
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
        for (const auto &root : m_tree.root().children) {
            const SvgStyle style = SvgStyle::of(*root, SvgStyle(), m_tree.sheet());
            if (root->name == QLatin1String("svg") && style.isDisplayed)
                drawChildren(*root, style, {});
            else
                draw(*root, SvgStyle(), {});
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
        else if (const QString data = svgPathData(element.name, element.attributes); !data.isEmpty())
            addPaths(element, style, data, place);
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

    void addPaths(const SvgElement &element, const SvgStyle &style, const QString &data, const Place &place)
    {
        const SvgPaint stroke = svgPaint(style.stroke, style.strokeOpacity * style.opacity, style.current, m_tree);
        const SvgPaint fill = svgPaint(style.fill, style.fillOpacity * style.opacity, style.current, m_tree);
        SvgPath line;
        line.strokeWidth = style.strokeWidth * (style.keepsWidth ? 1 : style.matrix.scale());
        if (line.strokeWidth > 0)
            line.stroke = stroke.colour;
        if (!style.isVisible || (!line.stroke && !fill.colour))
            return;
        line.name = place.name.isEmpty() ? element.givenName() : place.name;
        line.group = place.group;
        std::vector<std::vector<Cubic>> subpaths = placed(data, style.matrix);
        std::size_t curves = 0;
        for (const std::vector<Cubic> &subpath : subpaths)
            curves += subpath.size();
        if ((m_curves += curves) > mostCurvesInAll || curves == 0) {
            m_out.losses.isCut = m_out.losses.isCut || curves > 0;
            return;
        }
        SvgLosses &losses = m_out.losses;
        const bool hasFill = fill.colour && std::ranges::any_of(subpaths, enclosesArea);
        losses.dashes += line.stroke && style.isDashed ? 1 : 0;
        std::vector<SvgShade> shades;
        if (hasFill && fill.replaced && fill.gradient)
            shades = svgShades(*fill.gradient, boxOf(data), style.matrix, m_viewport, style.fillOpacity * style.opacity,
                               style.current, m_tree);
        const SvgElement *lost = hasFill && shades.empty() ? fill.replaced : nullptr;
        for (const SvgElement *replaced : {line.stroke ? stroke.replaced : nullptr, lost})
            if (replaced)
                m_lost.insert(replaced);
        if (mayHaveMarkers(element.name))
            for (const QString &marker : style.markers)
                lose(marker, "marker");
        if (hasFill)
            addAreas(subpaths, line, *fill.colour, shades, style.isEvenOdd);
        if (!line.stroke)
            return;
        for (std::vector<Cubic> &subpath : subpaths) {
            m_out.paths.push_back(line);
            m_out.paths.back().curves = std::move(subpath);
        }
    }

    /// The area lies below the lines of the same element, whose name and group it has. Shades of it that lie over each
    /// other are a group.
    void addAreas(const std::vector<std::vector<Cubic>> &subpaths, const SvgPath &line, const SvgColour &colour,
                  const std::vector<SvgShade> &shades, bool isEvenOdd)
    {
        SvgPath area = line;
        area.stroke.reset();
        area.fill = colour;
        area.isEvenOdd = isEvenOdd;
        for (const std::vector<Cubic> &subpath : subpaths) {
            if (!area.curves.empty())
                area.chains.push_back(area.curves.size());
            area.curves.insert(area.curves.end(), subpath.begin(), subpath.end());
        }
        if (shades.empty()) {
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

    /// Removes groups that have nothing in them, and those with only one thing, which gets the group's name if it has
    /// none.
    static void dissolveGroups(SvgDrawing &drawing)
    {
        std::vector<SvgGroup> &groups = drawing.groups;
        std::vector<int> held(groups.size(), 0), into(groups.size(), -1);
        for (const SvgPath &path : drawing.paths)
            if (path.group >= 0)
                ++held[std::size_t(path.group)];
        std::vector<QString> handed(groups.size());
        for (std::size_t i = groups.size(); i-- > 0;) // Groups come before those within them.
            if (held[i] > 0 && groups[i].parent >= 0)
                ++held[std::size_t(groups[i].parent)];
        const auto isKept = [&](std::size_t i) { return held[i] > 1; };
        std::vector<SvgGroup> kept;
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const int parent = groups[i].parent;
            const int outer = parent >= 0 ? into[std::size_t(parent)] : -1;
            const QString fromAbove = parent >= 0 ? handed[std::size_t(parent)] : QString();
            const QString name = groups[i].name.isEmpty() ? fromAbove : groups[i].name;
            into[i] = outer;
            handed[i] = isKept(i) ? QString() : name;
            if (!isKept(i))
                continue;
            into[i] = int(kept.size());
            kept.push_back({name, outer});
        }
        for (SvgPath &path : drawing.paths) {
            if (path.group < 0)
                continue;
            if (path.name.isEmpty())
                path.name = handed[std::size_t(path.group)];
            path.group = into[std::size_t(path.group)];
        }
        groups = std::move(kept);
    }

    SvgTree &m_tree;
    const Rect m_viewport; ///< what per cents count by
    SvgDrawing m_out;
    std::set<const SvgElement *> m_lost, m_cycles;
    int m_drawn = 0, m_copied = 0;
    std::size_t m_curves = 0;
};

/// A size of the document; no value for per cents and what is no size.
std::optional<double> sizeOf(const QXmlStreamAttributes &root, const char *name)
{
    const std::optional<double> size = svgLength(root.value(QLatin1String(name)).toString());
    return size && *size > 0 ? size : std::nullopt;
}

/// Finds area and scale. Where the document gives itself width and height, what they show of the view box is seen.
void takeSize(SvgDrawing &drawing, const QXmlStreamAttributes &root)
{
    const std::optional<double> width = sizeOf(root, "width"), height = sizeOf(root, "height");
    drawing.area = svgViewBox(root);
    if (drawing.area.isEmpty()) {
        if (width && height)
            drawing.area = Rect::of(0, 0, *width, *height);
        return;
    }
    const Rect box = drawing.area;
    const double byWidth = width.value_or(HUGE_VAL) / box.width(), byHeight = height.value_or(HUGE_VAL) / box.height();
    const double scale = std::min(byWidth, byHeight);
    drawing.scale = std::isfinite(scale) ? scale : 1;
    if (!width || !height)
        return;
    const SvgMatrix placing = svgViewport(box, Rect::of(0, 0, *width, *height),
                                          root.value(QLatin1String("preserveAspectRatio")).toString());
    if (placing.a != placing.d || !(placing.a > 0)) // "none" stretches, which a canvas cannot
        return;
    drawing.scale = placing.a;
    drawing.area = Rect::of(-placing.e / placing.a, -placing.f / placing.a, *width / placing.a, *height / placing.a);
}

} // namespace

Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes)
{
    QXmlStreamReader xml(bytes);
    SvgTree tree;
    if (const QString problem = tree.read(xml); !problem.isEmpty())
        return Error{QCoreApplication::translate("SvgPaths", "SVG, line %1: %2").arg(xml.lineNumber()).arg(problem)};
    SvgDrawing drawing = Drawing(tree).draw();
    if (!tree.root().children.empty())
        takeSize(drawing, tree.root().children.front()->attributes);
    return drawing;
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
