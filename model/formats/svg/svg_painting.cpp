#include "model/formats/svg/svg_painting.h"

#include "model/brush/brush_width.h"
#include "model/formats/messages.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"
#include "model/shaping/baseline_curve.h"
#include "model/shaping/curves/runs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace suffuse {

namespace {

constexpr qint64 largestSvg = qint64(64) << 20;
constexpr double largestCanvas = 1e6;
constexpr std::size_t mostPlaces = 8; ///< of a shape, where texts look for their stroke
constexpr Style crisp{StyleKind::Uniform, {0.5f, 0.05f, 0}};

/// The values of a segment that is painted with the brush, so that the dry stroke is `width` wide (0: as the brush
/// makes it).
Segment valuesOf(const Brush &brush, double width)
{
    Segment segment = valuesAtFullPressure(brush);
    if (!(width > 0))
        return segment;
    const double scale = width / visibleWidth(brush);
    segment.diffusion = float(double(segment.diffusion) * scale * scale);
    segment.density = float(double(segment.density) * scale);
    return segment;
}

Rect boundsOf(const std::vector<SvgPath> &paths)
{
    Rect box;
    for (const SvgPath &path : paths)
        for (const Cubic &cubic : path.curves)
            box = box.united(cubic.controlBox());
    return box;
}

/// What is to be seen of a drawing.
Rect seenArea(const SvgDrawing &drawing, const Brush &brush)
{
    return drawing.area.isEmpty() ? boundsOf(drawing.paths).grown(2 * brush.spread()) : drawing.area;
}

/// Whether lines cover the drawing several times over.
bool isCrowded(const SvgDrawing &drawing)
{
    constexpr double often = 4;
    const Rect area = seenArea(drawing, svgPen());
    double covered = 0;
    for (const SvgPath &path : drawing.paths)
        for (const Cubic &curve : path.curves)
            covered += path.stroke ? path.strokeWidth * polygonLength(curve) : 0;
    return covered > often * area.width() * area.height();
}

/// The size in whole units, however it was rounded before.
double wholeUnits(double size)
{
    return std::max(1.0, std::ceil(size - 1e-3));
}

/// What an area paints: its edge does not spread, and only the area has paint.
template <class Placed>
Stroke valuesOfArea(const SvgPath &path, Segment &values, Point origin, const Placed &placed)
{
    Fill fill;
    fill.maxAge = 1;
    fill.diffusion = 0;
    fill.born = values.born;
    fill.colour = values.colour;
    if (path.shade) {
        const auto &c = path.shade->colour;
        fill.gradient = Gradient{toOffset(placed(path.shade->from), origin), toOffset(placed(path.shade->to), origin),
                                 rybFromSrgb(c[0], c[1], c[2], c[3])};
    }
    fill.rule = path.isEvenOdd ? FillRule::EvenOdd : FillRule::NonZero;
    values.density = 0;
    values.diffusion = Segment().diffusion;
    values.maxAge = fill.maxAge;
    values.granulation = 1;
    Stroke stroke;
    stroke.style = crisp;
    stroke.fill = fill;
    return stroke;
}

/// The stroke along a path, or around an area, whose units are `scale` canvas units, and whose point `corner` comes to
/// (0, 0). No value if files could not store it.
std::optional<Stroke> strokeAlong(const SvgPath &path, Point corner, double scale, const Brush &brush,
                                  Microseconds born)
{
    Segment values = valuesOf(brush, path.stroke ? path.strokeWidth * scale : 0);
    const auto &rgba = path.stroke ? path.stroke : path.fill;
    values.colour = rgba ? rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]) : brush.colour;
    values.born = born;
    const auto placed = [&](Point p) { return scale * (p - corner); };
    const Point origin = placed(path.curves.front().p[0]);
    Stroke stroke;
    if (path.fill) {
        stroke = valuesOfArea(path, values, origin, placed);
    } else {
        stroke.style = brush.style;
        stroke.mix = brush.mix;
        stroke.brush = brush.name;
    }
    stroke.id = 1; // A stroke needs an id to be checked.
    stroke.name = path.name;
    stroke.origin = origin;
    stroke.segments.reserve(path.curves.size());
    bool begins = false;
    for (std::size_t k = 0; k < path.curves.size(); ++k) {
        Segment segment = values;
        for (std::size_t i = 0; i < 4; ++i)
            segment.bezier[i] = toOffset(placed(path.curves[k].p[i]), stroke.origin);
        begins = begins || std::ranges::binary_search(path.chains, k);
        if (!stroke.segments.empty() && !begins)
            segment.bezier[0] = stroke.segments.back().bezier[3];
        const bool isPoint = segment.bezier[0] == segment.bezier[1] && segment.bezier[1] == segment.bezier[2] &&
                             segment.bezier[2] == segment.bezier[3];
        if (isPoint)
            continue;
        segment.start = begins && !stroke.segments.empty();
        if (!stroke.segments.empty() && !begins && breaksBetween(stroke.segments.back(), segment))
            segment.node = NodeKind::Corner;
        begins = false;
        stroke.segments.push_back(std::move(segment));
    }
    if (stroke.segments.empty() || !problemOf(stroke).isEmpty())
        return {};
    return stroke;
}

/// Where a drawing's paths are as strokes.
struct Placing {
    const SvgDrawing &drawing;
    Affine map; ///< from units of the drawing to canvas units
    /// Of shapes along which texts stand, by their numbers: the strokes that they are, with the maps from the shapes.
    std::map<int, std::vector<std::pair<StrokePtr, Affine>>> leading{};
};

/// The text that follows the first stroke along whose curve it stands.
Text linked(Text text, int shape, const Placing &placing)
{
    const Affine toCurve = std::exchange(text.followMap, {});
    const auto strokes = placing.leading.find(shape);
    if (strokes == placing.leading.end())
        return text;
    const BaselineCurve own(text.curve);
    for (const auto &[stroke, map] : strokes->second) {
        const std::optional<Affine> back = map.inverse();
        const std::vector<Cubic> line = back ? mapped(baselineOf(*stroke), toCurve * *back) : std::vector<Cubic>();
        if (line.empty() || !(isSameCurve(text.curve, line) || BaselineCurve(line).endsOf(own)))
            continue;
        text.follows = stroke->id;
        text.followMap = toCurve * *back;
        break;
    }
    return text;
}

SharedText placedText(const SvgGroup &group, const Placing &placing)
{
    if (!group.text)
        return {};
    Text placed = linked(*group.text, group.follows, placing);
    placed.place = placing.map * placed.place;
    return problemOf(placed).isEmpty() ? SharedText(std::move(placed)) : SharedText();
}

/// The groups that have strokes, in them or in groups within them.
std::vector<Group> heldGroups(const Placing &placing, const StrokeList &strokes)
{
    const SvgDrawing &drawing = placing.drawing;
    std::vector<bool> held(drawing.groups.size() + 1, false); // by id
    for (const StrokePtr &stroke : strokes)
        for (GroupId id = stroke->group; id != 0 && !held[id]; id = GroupId(drawing.groups[id - 1].parent + 1))
            held[id] = true;
    std::vector<Group> groups;
    for (std::size_t i = 0; i < drawing.groups.size(); ++i)
        if (held[i + 1]) {
            const SvgGroup &drawn = drawing.groups[i];
            Group &group = groups.emplace_back();
            group.id = GroupId(i + 1), group.parent = GroupId(drawn.parent + 1);
            group.name = drawn.name;
            group.visible = !drawn.isHidden;
            group.text = placedText(drawn, placing);
            group.opacity = drawn.opacity, group.blend = drawn.blend, group.isolated = drawn.isIsolated;
        }
    return groups;
}

bool isAlong(const Cubic &cubic, const Rect &rect, double tolerance)
{
    const auto onSide = [&](auto isOn) { return std::ranges::all_of(cubic.p, isOn); };
    const auto near = [tolerance](double a, double b) { return std::abs(a - b) <= tolerance; };
    return onSide([&](Point p) { return near(p.x, rect.left); }) ||
           onSide([&](Point p) { return near(p.x, rect.right); }) ||
           onSide([&](Point p) { return near(p.y, rect.top); }) ||
           onSide([&](Point p) { return near(p.y, rect.bottom); });
}

/// Takes a drawing's first path away if it is the page behind the others: a rectangle that is named "background" and
/// covers all of the page in one opaque colour. Returns that colour.
std::optional<Colour> takeBackground(SvgDrawing &drawing)
{
    static const QString name = QStringLiteral("background");
    if (drawing.paths.size() < 2 || drawing.area.isEmpty())
        return {};
    const SvgPath &first = drawing.paths.front();
    const bool isPlain = first.fill && !first.shade && (*first.fill)[3] == 1 && first.group < 0;
    if (!isPlain || first.name != name || drawing.paths[1].name == name || !first.chains.empty())
        return {};
    const Rect &page = drawing.area;
    const double tolerance = 1e-6 * std::max(page.width(), page.height());
    Rect box;
    for (const Cubic &cubic : first.curves) {
        if (!isAlong(cubic, page, tolerance))
            return {};
        box = box.united(cubic.controlBox());
    }
    if (box.width() < page.width() - 2 * tolerance || box.height() < page.height() - 2 * tolerance)
        return {};
    const auto &c = *first.fill;
    const Colour colour = rybFromSrgb(c[0], c[1], c[2], c[3]);
    drawing.paths.erase(drawing.paths.begin());
    return colour;
}

} // namespace

Brush svgPen()
{
    Brush pen = builtinBrushes().front();
    pen.name.clear();
    pen.style = crisp;
    pen.mix = {};
    pen.maxAge = 1;
    pen.granulation = 1;
    pen.peak = 1e6f;
    pen.dynamics.clear();
    pen.taper = {};
    return pen;
}

Painting paintingAlong(const SvgDrawing &drawing, const Brush &brush, Microseconds born)
{
    const Rect area = seenArea(drawing, brush);
    Painting painting;
    painting.canvas.width = wholeUnits(area.width() * drawing.scale);
    painting.canvas.height = wholeUnits(area.height() * drawing.scale);
    const Affine map = Affine::scaling({}, drawing.scale, drawing.scale) * Affine::translation({-area.left, -area.top});
    Placing placing{drawing, map};
    for (const SvgPath &path : drawing.paths) {
        std::optional<Stroke> stroke = strokeAlong(path, {area.left, area.top}, drawing.scale, brush, born);
        if (!stroke)
            continue;
        stroke->id = StrokeId(painting.strokes.size() + 1);
        stroke->group = GroupId(path.group + 1);
        painting.strokes.push_back(std::make_shared<const Stroke>(std::move(*stroke)));
        if (path.lead >= 0) {
            const SvgLead &lead = drawing.leads[std::size_t(path.lead)];
            // A shape that is used all over the drawing leads by its first places, so that no file takes minutes.
            if (auto &strokes = placing.leading[lead.shape]; strokes.size() < mostPlaces)
                strokes.emplace_back(std::as_const(painting.strokes).back(), map * lead.map);
        }
    }
    painting.groups = heldGroups(placing, painting.strokes);
    return painting;
}

QString leftOutOf(const SvgDrawing &drawing)
{
    const SvgLosses &l = drawing.losses;
    QStringList sentences{leftOutSentence({
        {l.gradients, FileMessages::tr("%n gradient(s)", nullptr, l.gradients)},
        {l.patterns, FileMessages::tr("%n pattern(s)", nullptr, l.patterns)},
        {l.clipPaths, FileMessages::tr("%n clip path(s)", nullptr, l.clipPaths)},
        {l.masks, FileMessages::tr("%n mask(s)", nullptr, l.masks)},
        {l.filters, FileMessages::tr("%n filter(s)", nullptr, l.filters)},
        {l.blendModes, FileMessages::tr("%n blend mode(s)", nullptr, l.blendModes)},
        {l.markers, FileMessages::tr("%n marker(s)", nullptr, l.markers)},
        {l.outlines, FileMessages::tr("%n intricate outline(s)", nullptr, l.outlines)},
        {l.texts, FileMessages::tr("%n text(s)", nullptr, l.texts)},
        {l.images, FileMessages::tr("%n image(s)", nullptr, l.images)},
        {l.rules, FileMessages::tr("%n style rule(s)", nullptr, l.rules)},
        {l.cycles, FileMessages::tr("%n <use> of itself", nullptr, l.cycles)},
    })};
    if (l.fixedTexts > 0)
        sentences << FileMessages::tr("%n text(s) came in as letters: they cannot be typed in again.", nullptr,
                                      l.fixedTexts);
    if (!l.fonts.isEmpty())
        sentences << FileMessages::tr("Other fonts stand in for those that are not installed: %1.")
                         .arg(l.fonts.join(QStringLiteral(", ")));
    if (l.isCut)
        sentences << FileMessages::tr("There is more in the drawing than is read; the rest was left out.");
    sentences.removeAll(QString());
    return sentences.join(' ');
}

Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush *brush, QString *leftOut)
{
    if (bytes.size() > largestSvg)
        return fileError(fileName, FileMessages::tr("has more than 64 MB of XML; that is more than is read"));
    Result<SvgDrawing> drawing = readSvgDrawing(bytes);
    if (!drawing)
        return fileError(fileName, drawing.error());
    const std::optional<Colour> background = takeBackground(*drawing);
    Painting painting = paintingAlong(*drawing,
                                      brush                 ? *brush
                                      : isCrowded(*drawing) ? builtinBrushes().front()
                                                            : svgPen(),
                                      0);
    painting.canvas.background = background.value_or(painting.canvas.background);
    const Canvas &canvas = painting.canvas;
    if (!(canvas.width <= largestCanvas && canvas.height <= largestCanvas))
        return fileError(fileName,
                         FileMessages::tr("the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down")
                             .arg(canvas.width)
                             .arg(canvas.height));
    if (painting.strokes.empty())
        return fileError(fileName, FileMessages::tr("holds no paths that can be painted; in the program that drew it, "
                                                    "turn text and images into paths first"));
    if (const QString problem = problemOf(painting); !problem.isEmpty())
        return fileError(fileName, problem);
    if (leftOut)
        *leftOut = leftOutOf(*drawing);
    return painting;
}

} // namespace suffuse
