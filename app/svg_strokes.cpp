#include "app/svg_strokes.h"

#include "app/panels/colour/colour_convert.h"
#include "app/panels/density_function.h"
#include "model/painting/influence.h"

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

} // namespace suffuse
