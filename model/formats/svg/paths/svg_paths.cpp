#include "model/formats/svg/paths/svg_paths.h"

#include "model/area/offset_curve.h"
#include "model/formats/svg/css/css_blending.h"
#include "model/formats/svg/paths/svg_markers.h"
#include "model/formats/svg/paths/svg_shapes.h"
#include "model/formats/svg/svg_clip.h"
#include "model/formats/svg/svg_elements.h"
#include "model/formats/svg/svg_frame.h"
#include "model/formats/svg/svg_painter.h"
#include "model/formats/svg/svg_style.h"
#include "model/formats/svg/text/svg_text.h"
#include "model/shaping/transform.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace suffuse {

namespace {

constexpr int deepestNesting = 256;
constexpr int deepestGroups = 32;
constexpr int mostDrawn = 200'000;               ///< the greatest number of elements, including those of every <use>
constexpr int mostCopied = 50'000;               ///< the greatest number of elements among these that a <use> repeats
constexpr std::uint64_t mostSteps = 100'000'000; ///< for the areas of clips

/// Collects what a document draws.
class Drawing {
public:
    explicit Drawing(SvgTree &tree) : m_tree(tree), m_viewport(viewportOf(tree)) {}

    SvgDrawing draw()
    {
        noteLeads(m_tree.root());
        if (!m_tree.root().children.empty())
            takeSize(m_out, m_tree.root().children.front()->attributes);
        for (const auto &root : m_tree.root().children) {
            SvgStyle around;
            around.units.width = m_viewport.width(), around.units.height = m_viewport.height();
            const SvgStyle style = SvgStyle::of(*root, around, m_tree.sheet());
            if (root->name == QLatin1String("svg") && style.isDisplayed)
                drawRoot(*root, style);
            else
                draw(*root, around, {});
        }
        SvgLosses &losses = m_out.losses;
        for (const SvgElement *definition : m_lost)
            ++countOf(definition->name);
        losses.cycles = int(m_cycles.size());
        losses.fonts = m_texts.missing();
        losses.rules = m_tree.sheet().unread();
        losses.isCut = losses.isCut || m_tree.isCut() || m_texts.isCut();
        dissolveGroups(m_out);
        return std::move(m_out);
    }

private:
    /// Where an element is drawn in the tree of groups, and how deep.
    struct Place {
        int depth = 0, groupDepth = 0, group = -1;
        bool isCopy = false, isInMarker = false;
        QString name;    ///< the name of the <use> that draws it
        SvgClipPtr clip; ///< what of it is seen
    };

    /// Gives the shapes along which texts stand a number each.
    void noteLeads(const SvgElement &element)
    {
        for (const auto &child : element.children) {
            if (child->name == QLatin1String("textPath"))
                if (const SvgElement *shape = m_tree.target(*child))
                    m_leads.emplace(shape, int(m_leads.size()));
            noteLeads(*child);
        }
    }

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

    void drawRoot(const SvgElement &root, const SvgStyle &style)
    {
        const auto draw = [&](const Place &within) { drawChildren(root, style, within); };
        if (style.opacity < 1)
            inLayer(style, {}, draw);
        else
            draw({});
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
            place.depth > deepestNesting || m_drawn > mostDrawn || m_copied > mostCopied || m_painter.isFull();
        m_out.losses.isCut = m_out.losses.isCut || tooMuch;
        return tooMuch;
    }

    void draw(const SvgElement &element, const SvgStyle &parent, Place place)
    {
        if (isTooMuch(place))
            return;
        ++place.depth;
        SvgStyle style = SvgStyle::of(element, parent, m_tree.sheet());
        if ((!style.isDisplayed && !mayBeHidden(element, place)) || !isForAll(element))
            return;
        if (const SvgElement *clip = m_tree.find(svgReference(style.clipPath));
            clip && clip->name == QLatin1String("clipPath"))
            place.clip = clippedBy(*clip, element, style, place.clip);
        const std::size_t before = m_out.paths.size();
        if (isGroup(element.name)) {
            style.isFaded = parent.isFaded; // Its opacity is the group's.
            drawContent(element, style, place);
        } else if (blendsAsOne(element, style)) {
            style.isFaded = parent.isFaded;
            inLayer(style, place, [&](const Place &within) { drawContent(element, style, within); });
        } else {
            drawContent(element, style, place);
            m_painter.fade(before, style.opacity);
        }
        m_out.losses.blendModes += style.isBlendUnknown && m_out.paths.size() > before;
        if (m_out.paths.size() > before)
            for (const auto &[reference, kind] : {std::pair(style.mask, "mask"), {style.filter, "filter"}})
                lose(reference, kind);
    }

    /// Whether an element that is not displayed comes in all the same, as a hidden group: other programs hide layers
    /// by it.
    static bool mayBeHidden(const SvgElement &element, const Place &place)
    {
        return element.name == QLatin1String("g") && !place.isCopy && place.groupDepth < deepestGroups;
    }

    void drawContent(const SvgElement &element, const SvgStyle &style, const Place &place)
    {
        const auto is = [&element](const char *name) { return element.name == QLatin1String(name); };
        if (is("use"))
            use(element, style, place);
        else if (is("text"))
            addText(element, style, place);
        else if (is("image") || is("foreignObject"))
            m_out.losses.images += style.isVisible ? 1 : 0;
        else if (const QString data = svgPathData(element.name, element.attributes, style.units); !data.isEmpty())
            addShape(element, style, data, place);
        else if (is("switch"))
            drawSwitch(element, style, place);
        else if (is("svg"))
            drawNested(element, style, element, place);
        else if (isGroup(element.name))
            drawGroup(element, style, place);
    }

    /// Begins a group that blends as a style says. Where groups are too deep within each other it does nothing.
    bool openGroup(const QString &name, const SvgStyle &style, Place &place)
    {
        if (place.groupDepth >= deepestGroups)
            return false;
        m_out.groups.push_back({name, place.group});
        setBlending(m_out.groups.back(), style);
        m_out.groups.back().isHidden = !style.isDisplayed;
        place.group = int(m_out.groups.size()) - 1;
        ++place.groupDepth;
        return true;
    }

    /// Does for all paths behind the first ones what a style says of them together, without a group.
    void blendPlainly(std::size_t first, const SvgStyle &style)
    {
        m_painter.fade(first, style.opacity);
        m_out.losses.blendModes += style.blend != BlendMode::Normal && m_out.paths.size() > first;
    }

    /// Draws what a style's opacity and mode are about as a whole, in a group that has them. A single path has an
    /// opacity itself. `draw` gets the place within the group.
    template <class Draw>
    void inLayer(const SvgStyle &style, Place place, Draw draw)
    {
        const std::size_t first = m_out.paths.size();
        const bool isOpen = openGroup({}, style, place);
        draw(place);
        if (!isOpen)
            return blendPlainly(first, style);
        SvgGroup &layer = m_out.groups[std::size_t(place.group)];
        const bool isSingle = m_out.paths.size() == first + 1 && m_out.paths.back().group == place.group;
        if (isSingle && layer.blend == BlendMode::Normal)
            m_painter.fade(first, std::exchange(layer.opacity, 1.0f));
    }

    /// Draws the first child that may be drawn.
    void drawSwitch(const SvgElement &element, const SvgStyle &style, const Place &place)
    {
        const auto chosen = std::ranges::find_if(
            element.children, [](const auto &child) { return isForAll(*child) && !isOnlyDefined(child->name); });
        if (chosen != element.children.end())
            draw(**chosen, style, place);
    }

    void drawGroup(const SvgElement &element, const SvgStyle &style, Place place)
    {
        const std::size_t first = m_out.paths.size();
        const bool isOpen = openGroup(place.name.isEmpty() ? element.givenName() : place.name, style, place);
        place.name.clear();
        drawChildren(element, style, place);
        if (!isOpen)
            blendPlainly(first, style);
    }

    /// What of `outer` a clip path shows.
    SvgClipPtr clippedBy(const SvgElement &clip, const SvgElement &element, const SvgStyle &style,
                         const SvgClipPtr &outer)
    {
        const auto box = [&] {
            SvgStyle own = style;
            own.matrix = {};
            int steps = 10'000;
            return boxOf(element, own, steps);
        };
        const SvgClipPtr inner = m_clips.within(outer, clip, style, box);
        if (inner == outer)
            m_lost.insert(&clip);
        return inner;
    }

    /// The box of what an element draws, in the units into which its style maps it. `steps` bounds the work.
    Rect boxOf(const SvgElement &element, const SvgStyle &style, int &steps)
    {
        if (--steps < 0 || !style.isDisplayed || isOnlyDefined(element.name))
            return {};
        if (const QString data = svgPathData(element.name, element.attributes, style.units); !data.isEmpty())
            return svgBox(svgMapped(svgLines(data), style.matrix));
        Rect box;
        if (element.name == QLatin1String("text")) {
            const std::optional<SvgSetText> set = m_texts.set(element, style);
            return set ? svgBox(svgMapped(svgLinesOf(set->box), style.matrix)) : box;
        }
        if (element.name == QLatin1String("use")) {
            const SvgElement *target = m_tree.target(element);
            if (!target || element.isCycle)
                return box;
            const SvgStyle placed = movedBy(element, style);
            return boxOf(*target, SvgStyle::of(*target, placed, m_tree.sheet()), steps);
        }
        for (const auto &child : element.children)
            box = box.united(boxOf(*child, SvgStyle::of(*child, style, m_tree.sheet()), steps));
        return box;
    }

    /// A style moved by the x and y of a <use>.
    static SvgStyle movedBy(const SvgElement &use, SvgStyle style)
    {
        const auto at = [&](const char *name, SvgAxis axis) {
            return svgLength(use.attribute(name), style.units, axis).value_or(0);
        };
        style.matrix = style.matrix * SvgMatrix{1, 0, 0, 1, at("x", SvgAxis::Across), at("y", SvgAxis::Down)};
        return style;
    }

    /// Draws a nested <svg> or a <symbol>, which has a rectangle of its own, beyond which nothing is seen of it.
    /// `placing` says how large that is, and `element` what of it is shown.
    void drawNested(const SvgElement &element, SvgStyle style, const SvgElement &placing, Place place)
    {
        const Rect viewBox = svgViewBox(element.attributes);
        const auto given = [&style](const SvgElement &from, const char *name, SvgAxis axis) {
            return svgLength(from.attribute(name), style.units, axis);
        };
        const auto size = [&](const char *name, SvgAxis axis, double whole, double own) {
            const std::optional<double> placed = given(placing, name, axis);
            return placed ? *placed : given(element, name, axis).value_or(whole > 0 ? whole : own);
        };
        const bool isSymbol = element.name == QLatin1String("symbol");
        const auto at = [&](const char *name, SvgAxis axis) {
            return isSymbol ? 0 : given(element, name, axis).value_or(0);
        };
        const double x = at("x", SvgAxis::Across), y = at("y", SvgAxis::Down);
        const double width = size("width", SvgAxis::Across, style.units.width, viewBox.width());
        const double height = size("height", SvgAxis::Down, style.units.height, viewBox.height());
        const Rect port = Rect::of(x, y, width, height);
        const bool isSized = width > 0 && height > 0;
        if (!isSized && style.units.width > 0)
            return;
        if (!style.overflows && isSized)
            place.clip = m_clips.within(place.clip, port, style.matrix);
        const bool isScaled = isSized && !viewBox.isEmpty();
        style.matrix = style.matrix * (isScaled ? svgViewport(viewBox, port, element.attribute("preserveAspectRatio"))
                                                : SvgMatrix{1, 0, 0, 1, x, y});
        style.units.width = isScaled ? viewBox.width() : width;
        style.units.height = isScaled ? viewBox.height() : height;
        drawGroup(element, style, place);
    }

    void use(const SvgElement &element, SvgStyle style, Place place)
    {
        const SvgElement *target = m_tree.target(element);
        if (element.isCycle)
            m_cycles.insert(&element);
        if (!target || element.isCycle)
            return;
        style = movedBy(element, style);
        const QString fill = style.inContext(style.fill);
        style.contextStroke = style.inContext(style.stroke);
        style.contextFill = fill;
        place.isCopy = true;
        place.name = element.givenName();
        if (target->name != QLatin1String("symbol") && target->name != QLatin1String("svg")) {
            draw(*target, style, place);
            return;
        }
        const SvgStyle own = SvgStyle::of(*target, style, m_tree.sheet());
        if (isTooMuch(place) || !own.isDisplayed)
            return;
        ++place.depth;
        drawNested(*target, own, element, place);
    }

    void addShape(const SvgElement &element, const SvgStyle &style, const QString &data, const Place &place)
    {
        SvgShape shape{svgLines(data), style, place.clip, place.name.isEmpty() ? element.givenName() : place.name,
                       place.group};
        if (element.name == QLatin1String("polygon")) // It is closed even where its points end in a mistake.
            for (PenLine &line : shape.lines)
                closeLine(line);
        if (const auto lead = m_leads.find(&element); lead != m_leads.end()) {
            shape.lead = int(m_out.leads.size());
            m_out.leads.push_back({lead->second, Affine(style.matrix)});
        }
        m_painter.paint(shape);
        if (mayHaveMarkers(element.name) && style.isVisible)
            drawMarkers(shape, data.contains(u'a', Qt::CaseInsensitive), place);
    }

    /// A text is a group of its letters, a shape each.
    void addText(const SvgElement &element, const SvgStyle &style, Place place)
    {
        const std::optional<SvgSetText> set = m_texts.set(element, style);
        m_out.losses.texts += !set && style.isVisible ? 1 : 0;
        if (!set || set->letters.empty())
            return;
        if (place.groupDepth < deepestGroups) {
            static const QRegularExpression counted(QStringLiteral("^text[0-9-]*$"));
            const QString own = element.givenName();
            m_out.groups.push_back({!place.name.isEmpty()           ? place.name
                                    : counted.match(own).hasMatch() ? QString()
                                                                    : own,
                                    place.group});
            m_out.groups.back().words = set->words;
            place.group = int(m_out.groups.size()) - 1;
            keepText(*set, style, place);
        }
        for (const SvgLetter &letter : set->letters)
            m_painter.paint({letter.lines, *letter.style, place.clip, letter.characters, place.group, set->box, true});
    }

    /// Notes of a text's group what it was made from, where its letters are as Suffuse's texts have them: areas of one
    /// colour, a path each, and all of them whole.
    void keepText(const SvgSetText &set, const SvgStyle &style, const Place &place)
    {
        const SvgStyle &look = *set.letters.front().style;
        const bool isPlain = look.stroke == QLatin1String("none") && look.isVisible &&
                             svgReference(look.inContext(look.fill)).isEmpty() && look.fill != QLatin1String("none");
        if (!set.text || !isPlain ||
            (place.clip && !place.clip->holds(svgBox(svgMapped(svgLinesOf(set.box), style.matrix)))))
            return;
        Text text = *set.text;
        text.place = Affine(style.matrix) * text.place;
        if (const auto lead = m_leads.find(set.shape); lead != m_leads.end())
            m_out.groups.back().follows = lead->second;
        m_out.groups.back().text = SharedText(std::move(text));
        m_out.groups.back().letters = set.letters.size();
    }

    /// Draws markers at the nodes of a shape. Those in the middle of one with arcs are left out, since arcs have more
    /// nodes here than in the drawing; so are those on shapes in markers.
    void drawMarkers(const SvgShape &shape, bool hasArcs, Place place)
    {
        const auto &names = shape.style.markers;
        std::array<const SvgElement *, 3> markers{};
        for (std::size_t i = 0; i < 3; ++i) {
            const SvgElement *marker = m_tree.find(svgReference(names[i]));
            if (!marker || marker->name != QLatin1String("marker"))
                continue;
            if (place.isInMarker || (hasArcs && i == 1))
                m_lost.insert(marker);
            else
                markers[i] = marker;
        }
        if (std::ranges::none_of(markers, [](const SvgElement *marker) { return marker != nullptr; }))
            return;
        place.isInMarker = place.isCopy = true;
        ++place.depth;
        for (const SvgMarkerPlace &at : svgMarkerPlaces(shape.lines)) {
            const SvgElement *marker = markers[std::size_t(at.kind)];
            if (!marker)
                continue;
            if (isTooMuch(place))
                return;
            const std::optional<SvgMarkerView> view = svgMarkerView(*marker, at, shape.style, m_tree.sheet());
            if (!view)
                continue;
            Place inside = place;
            if (!view->style.overflows)
                inside.clip = m_clips.within(place.clip, view->port, view->style.matrix);
            if (view->style.opacity < 1 || view->style.blend != BlendMode::Normal)
                inLayer(view->style, inside, [&](const Place &within) { drawChildren(*marker, view->style, within); });
            else
                drawChildren(*marker, view->style, inside);
        }
    }

    SvgTree &m_tree;
    const Rect m_viewport; ///< what per cents count by
    SvgDrawing m_out;
    std::set<const SvgElement *> m_lost, m_cycles;
    std::map<const SvgElement *, int> m_leads;
    int m_drawn = 0, m_copied = 0;
    SvgPainter m_painter{m_tree, m_out, m_lost};
    SvgTexts m_texts{m_tree, letterShaper()};
    AreaEffort m_clipEffort{mostSteps};
    SvgClips m_clips{m_tree, m_texts, m_clipEffort};
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
