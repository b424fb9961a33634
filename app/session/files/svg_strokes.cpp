#include "app/session/files/svg_strokes.h"

#include "app/session/colour_convert.h"
#include "app/session/files/svg_widths.h"
#include "model/paint/derived_figures.h"
#include "model/painting/influence.h"

#include <QXmlStreamWriter>

#include <cmath>

namespace suffuse {

namespace {

constexpr double widthStep = 0.01; ///< canvas units: smaller differences of width make no new path

QString number(double value)
{
    return QString::number(value, 'g', 9);
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

void writePath(QXmlStreamWriter &xml, const Look &look, const QString &data)
{
    xml.writeStartElement("path");
    xml.writeAttribute("d", data);
    xml.writeAttribute("stroke", look.colour.name());
    if (look.colour.alphaF() < 1)
        xml.writeAttribute("stroke-opacity", QString::number(double(look.colour.alphaF()), 'g', 3));
    xml.writeAttribute("stroke-width", number(look.width));
    xml.writeEndElement();
}

/// Writes a stroke as a group of paths. `half` points at half of the width of its first segment, and afterwards behind
/// that of its last one.
void writeStroke(QXmlStreamWriter &xml, const Stroke &stroke, std::vector<double>::const_iterator &half)
{
    const auto text = [](Point p) { return number(p.x) + ',' + number(p.y); };
    xml.writeStartElement("g");
    if (!stroke.name.isEmpty())
        xml.writeTextElement("title", stroke.name);
    QString data;
    Look look;
    bool isGap = false;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        isGap = isGap || stroke.beginsChain(k);
        if (segment.lift) {
            isGap = true;
            continue;
        }
        const Look here = lookOf(stroke, segment, *half++);
        const Cubic c = stroke.cubicOf(segment);
        if (data.isEmpty() || !(here == look)) {
            if (!data.isEmpty())
                writePath(xml, look, data);
            data = 'M' + text(c.p[0]);
            look = here;
        } else if (isGap) {
            data += " M" + text(c.p[0]);
        }
        isGap = false;
        data += " C" + text(c.p[1]) + ' ' + text(c.p[2]) + ' ' + text(c.p[3]);
    }
    if (!data.isEmpty())
        writePath(xml, look, data);
    xml.writeEndElement();
}

} // namespace

int erasingSegments(const Painting &painting)
{
    std::ptrdiff_t count = 0;
    for (const StrokePtr &stroke : painting.strokes)
        if (painting.isVisible(*stroke))
            count += std::ranges::count_if(stroke->segments, &Segment::lift);
    return int(count);
}

SvgStrokes svgOf(const Painting &painting)
{
    SvgStrokes svg{{}, erasingSegments(painting)};
    QXmlStreamWriter xml(&svg.bytes);
    Rect box = influenceOf(painting, painting.end());
    if (box.isEmpty())
        box = painting.canvas.area();
    xml.writeStartDocument();
    xml.writeStartElement("svg");
    xml.writeDefaultNamespace("http://www.w3.org/2000/svg");
    xml.writeAttribute("width", number(box.width()));
    xml.writeAttribute("height", number(box.height()));
    xml.writeAttribute(
        "viewBox", QStringList{number(box.left), number(box.top), number(box.width()), number(box.height())}.join(' '));
    xml.writeStartElement("g");
    xml.writeAttribute("fill", "none");
    xml.writeAttribute("stroke-linecap", "round");
    xml.writeAttribute("stroke-linejoin", "round");
    std::vector<SvgLine> lines;
    for (const StrokePtr &stroke : painting.strokes)
        for (const Segment &segment : stroke->segments)
            if (painting.isVisible(*stroke) && !segment.lift)
                lines.push_back(lineOf(*stroke, segment));
    const std::vector<double> halves = joinedHalfWidths(lines);
    auto half = halves.begin();
    for (const StrokePtr &stroke : painting.strokes)
        if (painting.isVisible(*stroke))
            writeStroke(xml, *stroke, half);
    xml.writeEndDocument();
    return svg;
}

} // namespace suffuse
