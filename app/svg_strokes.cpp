#include "app/svg_strokes.h"

#include "app/panels/colour_convert.h"
#include "app/panels/density_function.h"
#include "model/influence.h"
#include "model/ryb.h"
#include "model/validate.h"

#include <QXmlStreamWriter>

namespace suffuse {

namespace {

constexpr double widthStep = 0.01; ///< units: finer differences make no path of their own

QString number(double value)
{
    return QString::number(value, 'g', 9);
}

/// What a segment looks like as a line.
struct Look {
    QColor colour;
    double width = 0;
    friend bool operator==(const Look &, const Look &) = default;
};

Look lookOf(const Stroke &stroke, const Segment &segment)
{
    const Style &style = stroke.styleOf(segment);
    const DerivedFigures figures = derivedFigures(segment, style);
    Look look;
    QColor colour = toOpaqueScreen(segment.colour);
    // What has no edge to be as wide as is shown as wide as it has spread, and as faint as it is.
    const double width = figures.halfWidth > 0 ? figures.halfWidth : 0.5 * figures.spread;
    const double coverage = figures.halfWidth > 0 ? 1 : densityFunction(style, figures.peak);
    colour.setAlphaF(float(std::clamp(double(segment.colour.opacity) * coverage, 0.0, 1.0)));
    look.colour = colour;
    look.width = std::max(std::round(2 * width / widthStep) * widthStep, widthStep);
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

void writeStroke(QXmlStreamWriter &xml, const Stroke &stroke)
{
    const auto text = [](Point p) { return number(p.x) + ',' + number(p.y); };
    xml.writeStartElement("g");
    if (!stroke.name.isEmpty())
        xml.writeTextElement("title", stroke.name);
    QString data;
    Look look;
    for (const Segment &segment : stroke.segments) {
        const Look here = lookOf(stroke, segment);
        const Cubic c = stroke.cubicOf(segment);
        if (data.isEmpty() || !(here == look)) {
            if (!data.isEmpty())
                writePath(xml, look, data);
            data = 'M' + text(c.p[0]);
            look = here;
        }
        data += " C" + text(c.p[1]) + ' ' + text(c.p[2]) + ' ' + text(c.p[3]);
    }
    if (!data.isEmpty())
        writePath(xml, look, data);
    xml.writeEndElement();
}

/// The values of a segment painted with the brush, so that the dry stroke is `width` wide (0: as the brush is).
Segment valuesOf(const Brush &brush, double width)
{
    Segment segment;
    segment.diffusion = brush.diffusion;
    segment.density = float(densityForPeak(double(brush.peak), double(brush.diffusion), double(brush.maxAge)));
    segment.granulation = brush.granulation;
    segment.maxAge = brush.maxAge;
    if (!(width > 0))
        return segment;
    const double half = derivedFigures(segment, brush.style).halfWidth;
    const double scale = half > 0 ? 0.5 * width / half : width / (2 * brush.spread());
    segment.diffusion = float(double(segment.diffusion) * scale * scale);
    segment.density = float(double(segment.density) * scale);
    return segment;
}

} // namespace

QByteArray svgOf(const Painting &painting)
{
    QByteArray bytes;
    QXmlStreamWriter xml(&bytes);
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
    for (const StrokePtr &stroke : painting.strokes)
        if (painting.isVisible(*stroke))
            writeStroke(xml, *stroke);
    xml.writeEndDocument();
    return bytes;
}

std::vector<Stroke> strokesAlong(const std::vector<SvgPath> &paths, const Brush &brush, Microseconds born)
{
    std::vector<Stroke> strokes;
    for (const SvgPath &path : paths) {
        Segment values = valuesOf(brush, path.stroke ? path.strokeWidth : 0);
        const auto &rgba = path.stroke ? path.stroke : path.fill;
        values.colour = rgba ? rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]) : brush.colour;
        values.born = born;
        Stroke stroke;
        stroke.style = brush.style;
        stroke.mix = brush.mix;
        stroke.brush = brush.name;
        stroke.origin = path.curves.front().p[0];
        for (const Cubic &cubic : path.curves) {
            Segment segment = values;
            for (std::size_t i = 0; i < 4; ++i)
                segment.bezier[i] = toOffset(cubic.p[i], stroke.origin);
            if (!stroke.segments.empty())
                segment.bezier[0] = stroke.segments.back().bezier[3];
            const bool isPoint = segment.bezier[0] == segment.bezier[1] && segment.bezier[1] == segment.bezier[2] &&
                                 segment.bezier[2] == segment.bezier[3];
            if (!isPoint)
                stroke.segments.push_back(std::move(segment));
        }
        stroke.id = 1; // to be checked with
        if (stroke.segments.empty() || !problemOf(stroke).isEmpty())
            continue;
        stroke.id = 0;
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

} // namespace suffuse
