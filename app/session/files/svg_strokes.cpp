#include "app/session/files/svg_strokes.h"

#include "app/session/colour_convert.h"
#include "app/session/files/svg_widths.h"
#include "model/area/outline.h"
#include "model/formats/svg/css/css_blending.h"
#include "model/formats/svg/svg_group_writer.h"
#include "model/paint/derived_figures.h"
#include "model/paint/style_function.h"
#include "model/painting/fields.h"
#include "model/painting/influence.h"
#include "model/shaping/curves/chains.h"

#include <QCoreApplication>
#include <QXmlStreamWriter>

#include <cmath>
#include <set>

namespace suffuse {

namespace {

constexpr double widthStep = 0.01; ///< canvas units: smaller differences of width make no new path

QString number(double value)
{
    return QString::number(value, 'g', 9);
}

/// Whether a segment is a line of paint.
bool isLine(const Stroke &stroke, std::size_t segment)
{
    return !stroke.segments[segment].takesPaint() && !onlyBounds(stroke, segment);
}

/// How a segment looks as a line.
struct Look {
    QColor colour;
    double width = 0;
    friend bool operator==(const Look &, const Look &) = default;
};

/// Half of the width at which a segment is seen. A segment without an edge has half of its spread.
double halfWidthOf(const DerivedFigures &figures)
{
    return figures.halfWidth > 0 ? figures.halfWidth : 0.5 * figures.spread;
}

SvgLine lineOf(const Stroke &stroke, const Segment &segment)
{
    const DerivedFigures figures = derivedFigures(segment, stroke.styleOf(segment));
    const Cubic c = stroke.cubicOf(segment);
    SvgLine line{c.p[0], c.p[3], halfWidthOf(figures), 0};
    // Where two rows meet the density is twice as high: s √ln(2 pk/cut).
    line.reach = figures.halfWidth > 0
                     ? std::sqrt(line.half * line.half + figures.spread * figures.spread * std::log(2.0))
                     : line.half;
    return line;
}

/// How a segment looks whose width is twice `half`.
Look lookOf(const Stroke &stroke, const Segment &segment, double half)
{
    const Style &style = stroke.styleOf(segment);
    const DerivedFigures figures = derivedFigures(segment, style);
    Look look;
    QColor colour = toOpaqueScreen(segment.colour);
    // Paint without an edge is shown as wide as it has spread, and as faint as it is.
    const double coverage = figures.halfWidth > 0 ? 1 : densityFunction(style, figures.peak);
    colour.setAlphaF(float(std::clamp(double(segment.colour.opacity) * coverage, 0.0, 1.0)));
    look.colour = colour;
    look.width = std::max(std::round(2 * half / widthStep) * widthStep, widthStep);
    return look;
}

/// A path with its attributes, and the gradient that its fill refers to.
struct WrittenPath {
    QString data;
    QXmlStreamAttributes attributes;
    const Fill *gradient = nullptr;
    QString gradientId;
};

QString share(double value)
{
    return QString::number(std::clamp(value, 0.0, 1.0), 'g', 4);
}

WrittenPath linePath(const Look &look, const QString &data)
{
    WrittenPath path{data, {}, nullptr, {}};
    path.attributes.append("stroke", look.colour.name());
    if (look.colour.alphaF() < 1)
        path.attributes.append("stroke-opacity", QString::number(double(look.colour.alphaF()), 'g', 3));
    path.attributes.append("stroke-width", number(look.width));
    return path;
}

QString pointText(Point p)
{
    return number(p.x) + ',' + number(p.y);
}

QString curveText(const Cubic &c)
{
    return " C" + pointText(c.p[1]) + ' ' + pointText(c.p[2]) + ' ' + pointText(c.p[3]);
}

/// How much of a fill is seen deep within it.
double coverageOf(const Stroke &stroke)
{
    return densityFunction(stroke.style, double(stroke.fill->density));
}

/// The area of a fill, as its outline bounds it.
WrittenPath areaPath(const Stroke &stroke, int &gradients)
{
    const Fill &fill = *stroke.fill;
    WrittenPath path;
    for (const std::vector<Cubic> &loop : closedOutline(stroke)) {
        path.data += (path.data.isEmpty() ? "M" : " M") + pointText(stroke.origin + loop.front().p[0]);
        for (Cubic curve : loop) {
            for (Point &p : curve.p)
                p = stroke.origin + p;
            path.data += curveText(curve);
        }
        path.data += " Z";
    }
    if (fill.gradient) {
        path.gradient = &fill;
        path.gradientId = QStringLiteral("gradient%1").arg(++gradients);
        path.attributes.append("fill", "url(#" + path.gradientId + ')');
    } else {
        path.attributes.append("fill", toOpaqueScreen(fill.colour).name());
        if (const double opacity = double(fill.colour.opacity) * coverageOf(stroke); opacity < 1)
            path.attributes.append("fill-opacity", share(opacity));
    }
    if (fill.rule == FillRule::EvenOdd)
        path.attributes.append("fill-rule", "evenodd");
    return path;
}

/// The stops of a gradient: more than its ends where paint takes another way between two colours than a screen.
std::vector<std::pair<double, Colour>> stopsOf(const Fill &fill)
{
    constexpr int mostParts = 8;
    constexpr double seen = 0.01;
    const Colour &a = fill.colour, &b = fill.gradient->colour;
    const auto between = [&](double t) {
        const auto mix = [t](float x, float y) { return float(std::lerp(double(x), double(y), t)); };
        return Colour{mix(a.red, b.red), mix(a.yellow, b.yellow), mix(a.blue, b.blue), mix(a.opacity, b.opacity)};
    };
    const QColor first = toOpaqueScreen(a), last = toOpaqueScreen(b), middle = toOpaqueScreen(between(0.5));
    double bend = 0;
    for (const auto &channel : {&QColor::redF, &QColor::greenF, &QColor::blueF})
        bend = std::max(bend,
                        std::abs(0.5 * double((first.*channel)() + (last.*channel)()) - double((middle.*channel)())));
    const int parts = std::clamp(int(std::ceil(std::sqrt(bend / seen))), 1, mostParts);
    std::vector<std::pair<double, Colour>> stops;
    for (int i = 0; i <= parts; ++i)
        stops.emplace_back(double(i) / parts, between(double(i) / parts));
    return stops;
}

void writeGradient(QXmlStreamWriter &xml, const Stroke &stroke, const WrittenPath &path)
{
    const Gradient &gradient = *path.gradient->gradient;
    const Point from = stroke.origin + gradient.from, to = stroke.origin + gradient.to;
    xml.writeStartElement("defs");
    xml.writeStartElement("linearGradient");
    xml.writeAttribute("id", path.gradientId);
    xml.writeAttribute("gradientUnits", "userSpaceOnUse");
    xml.writeAttribute("x1", number(from.x));
    xml.writeAttribute("y1", number(from.y));
    xml.writeAttribute("x2", number(to.x));
    xml.writeAttribute("y2", number(to.y));
    for (const auto &[place, colour] : stopsOf(*path.gradient)) {
        xml.writeEmptyElement("stop");
        xml.writeAttribute("offset", share(place));
        xml.writeAttribute("stop-color", toOpaqueScreen(colour).name());
        if (const double opacity = double(colour.opacity) * coverageOf(stroke); opacity < 1)
            xml.writeAttribute("stop-opacity", share(opacity));
    }
    xml.writeEndElement();
    xml.writeEndElement();
}

/// The lines of a stroke. `half` points at half of the width of its first segment that is one, and afterwards behind
/// that of its last one.
void addLines(std::vector<WrittenPath> &paths, const Stroke &stroke, std::vector<double>::const_iterator &half)
{
    QString data;
    Look look;
    bool isGap = false;
    Point start; // of the subpath
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        isGap = isGap || stroke.beginsChain(k);
        if (!isLine(stroke, k)) {
            isGap = true;
            continue;
        }
        const Look here = lookOf(stroke, segment, *half++);
        const Cubic c = stroke.cubicOf(segment);
        if (data.isEmpty() || !(here == look)) {
            if (!data.isEmpty())
                paths.push_back(linePath(look, data));
            data = 'M' + pointText(c.p[0]);
            look = here;
            start = c.p[0];
        } else if (isGap) {
            data += " M" + pointText(c.p[0]);
            start = c.p[0];
        }
        isGap = false;
        data += curveText(c);
        const bool ends = k + 1 == stroke.segments.size() || stroke.beginsChain(k + 1);
        if (ends && c.p[3] == start)
            data += " Z";
    }
    if (!data.isEmpty())
        paths.push_back(linePath(look, data));
}

/// Writes a stroke as a path or, where it takes several, as a group of paths: the area first, then the lines over it.
void writeStroke(QXmlStreamWriter &xml, const Stroke &stroke, std::vector<double>::const_iterator &half, int &gradients)
{
    std::vector<WrittenPath> paths;
    if (stroke.fill)
        paths.push_back(areaPath(stroke, gradients));
    addLines(paths, stroke, half);
    const auto writeTitle = [&] {
        if (!stroke.name.isEmpty())
            xml.writeTextElement("title", stroke.name);
    };
    if (paths.size() > 1) {
        xml.writeStartElement("g");
        writeTitle();
    }
    for (const WrittenPath &path : paths) {
        if (path.gradient)
            writeGradient(xml, stroke, path);
        xml.writeStartElement("path");
        xml.writeAttribute("d", path.data);
        xml.writeAttributes(path.attributes);
        if (paths.size() == 1)
            writeTitle();
        xml.writeEndElement();
    }
    if (paths.size() > 1)
        xml.writeEndElement();
}

/// The canvas' colour, as a rectangle under everything. Ours and other programs know it by its id.
void writeBackground(QXmlStreamWriter &xml, const Rect &page, const Colour &colour)
{
    xml.writeEmptyElement("rect");
    xml.writeAttribute("id", "background");
    xml.writeAttribute("x", number(page.left));
    xml.writeAttribute("y", number(page.top));
    xml.writeAttribute("width", number(page.width()));
    xml.writeAttribute("height", number(page.height()));
    xml.writeAttribute("fill", toOpaqueScreen(colour).name());
}

} // namespace

SvgStrokes lossesOf(const Painting &painting)
{
    SvgStrokes svg;
    const Visibility isVisible(painting.groups);
    std::set<GroupId> written;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isVisible(*stroke))
            continue;
        svg.pictures += bool(stroke->picture);
        svg.erasures += stroke->picture ? 0 : erasureCount(*stroke);
        for (const Group *group = painting.findGroup(stroke->group); group && written.insert(group->id).second;)
            group = painting.findGroup(group->parent);
    }
    for (const Group &group : painting.groups) {
        if (!written.contains(group.id))
            continue;
        svg.masks += group.clips || group.mask || cssOf(group.blend) == nullptr;
        svg.washes += group.wash.has_value();
    }
    return svg;
}

QString leftOutOf(const SvgStrokes &svg)
{
    QStringList said;
    if (svg.erasures > 0)
        said << QCoreApplication::translate("Clipboard",
                                            "As SVG, for other programs, what was erased softly is left "
                                            "out: %n erasure(s).",
                                            nullptr, svg.erasures);
    if (svg.pictures > 0)
        said << QCoreApplication::translate(
            "Clipboard", "As SVG, for other programs, pictures are left out: %n of them.", nullptr, svg.pictures);
    if (svg.masks > 0)
        said << QCoreApplication::translate("Clipboard",
                                            "SVG has no groups that mask, erase or clip what lies below: %n group(s) "
                                            "became plain.",
                                            nullptr, svg.masks);
    if (svg.washes > 0)
        said << QCoreApplication::translate("Clipboard",
                                            "SVG has no washes: the strokes of %n group(s) lie over each other there.",
                                            nullptr, svg.washes);
    return said.join(QLatin1Char(' '));
}

SvgStrokes svgOf(const Painting &painting, const Rect &area)
{
    SvgStrokes svg = lossesOf(painting);
    QXmlStreamWriter xml(&svg.bytes);
    Rect box = area.isEmpty() ? influenceOf(painting, painting.end()) : area;
    if (box.isEmpty())
        box = painting.canvas.area();
    xml.writeStartDocument();
    xml.writeStartElement("svg");
    xml.writeDefaultNamespace("http://www.w3.org/2000/svg");
    xml.writeAttribute("width", number(box.width()));
    xml.writeAttribute("height", number(box.height()));
    xml.writeAttribute(
        "viewBox", QStringList{number(box.left), number(box.top), number(box.width()), number(box.height())}.join(' '));
    xml.writeAttribute("fill", "none");
    xml.writeAttribute("stroke-linecap", "round");
    xml.writeAttribute("stroke-linejoin", "round");
    if (!area.isEmpty() && painting.canvas.background.opacity == 1)
        writeBackground(xml, area, painting.canvas.background);
    std::vector<SvgLine> lines;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        for (std::size_t k = 0; k < stroke->segments.size(); ++k)
            if (isVisible(*stroke) && !stroke->picture && isLine(*stroke, k))
                lines.push_back(lineOf(*stroke, stroke->segments[k]));
    const std::vector<double> halves = joinedHalfWidths(lines);
    auto half = halves.begin();
    int gradients = 0;
    SvgGroupWriter groups(xml, painting);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!isVisible(*stroke) || stroke->picture)
            continue;
        groups.goTo(stroke->group);
        writeStroke(xml, *stroke, half, gradients);
    }
    xml.writeEndDocument();
    return svg;
}

} // namespace suffuse
