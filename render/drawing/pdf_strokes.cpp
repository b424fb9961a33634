#include "render/drawing/pdf_strokes.h"

#include "render/drawing/band_mask.h"
#include "render/drawing/pdf_image.h"

#include <cmath>

namespace suffuse {

namespace {

/// Where a form or a mask ends: its corners.
QByteArray corners(const Rect &box)
{
    return pdf::number(box.left) + ' ' + pdf::number(box.top) + ' ' + pdf::number(box.right) + ' ' +
           pdf::number(box.bottom);
}

QByteArray grey(double level)
{
    return pdf::number(level) + " g\n";
}

Rect boxAround(const contours::Loops &loops)
{
    Rect box;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &curve : loop)
            box = box.united(curve.controlBox());
    return box.grown(paintMargin);
}

/// A function from [0, 1] to the stops' colours, or to how much of the opacity there is.
QByteArray functionOf(const std::vector<DrawnPaint::Stop> &stops, bool opacities)
{
    const auto value = [&](const DrawnPaint::Stop &stop) {
        return '[' + (opacities ? pdf::number(stop.colour[3]) : pdfColour(stop.colour)) + ']';
    };
    QByteArray functions, bounds, encode;
    const auto add = [&](const DrawnPaint::Stop &from, const DrawnPaint::Stop &to, double end) {
        functions += "<< /FunctionType 2 /Domain [0 1] /N 1 /C0 " + value(from) + " /C1 " + value(to) + " >> ";
        encode += "0 1 ";
        if (end < 1)
            bounds += pdf::number(end) + ' ';
    };
    if (stops.front().place > 0)
        add(stops.front(), stops.front(), stops.front().place);
    for (std::size_t k = 1; k < stops.size(); ++k)
        add(stops[k - 1], stops[k], stops[k].place);
    if (stops.back().place < 1)
        add(stops.back(), stops.back(), 1);
    return "<< /FunctionType 3 /Domain [0 1] /Functions [" + functions + "] /Bounds [" + bounds + "] /Encode [" +
           encode + "] >>";
}

bool fades(const DrawnPaint &paint)
{
    return std::ranges::any_of(paint.stops, [](const DrawnPaint::Stop &stop) { return stop.colour[3] < 1; });
}

} // namespace

QByteArray pdfColour(const DrawnColour &colour)
{
    QByteArray text;
    for (std::size_t c = 0; c < 3; ++c)
        text += (c > 0 ? " " : "") + pdf::number(std::clamp(colour[c], 0.0, 1.0));
    return text;
}

QByteArray pdfBox(const Rect &box)
{
    return pdf::number(box.left) + ' ' + pdf::number(box.top) + ' ' + pdf::number(box.width()) + ' ' +
           pdf::number(box.height());
}

QByteArray pdfMatrix(const Affine &map)
{
    QByteArray text;
    for (const double number : {map.a, map.c, map.b, map.d, map.offset.x, map.offset.y})
        text += (text.isEmpty() ? "" : " ") + pdf::number(number);
    return text;
}

QByteArray PdfStrokes::of(const DrawnStroke &drawn)
{
    const contours::Loops &outline = drawn.bands.front().loops;
    const bool pictured = drawn.stroke->picture && !m_drawing.unpainted;
    const bool masked = drawn.bands.size() > 1;
    const Rect box = masked ? bandMaskOf(drawn, m_drawing.bandCount).box : boxAround(outline);
    QByteArray out = "q\n" + look(drawn, box, masked);
    if (masked) // The mask alone says where paint ends.
        out += pdfBox(box) + " re\n";
    else
        out += m_text.pdf(outline);
    if (pictured)
        out += "W n\n" + imageOf(*drawn.stroke);
    else if (drawn.paint.isGradient())
        out += "W n\n" + m_resources.shading(shadingOf(drawn.paint, false)) + " sh\n";
    else
        out += "f\n";
    return out + "Q\n";
}

/// The state in which what is within the outline, or the mask, is painted.
QByteArray PdfStrokes::look(const DrawnStroke &drawn, const Rect &box, bool masked)
{
    const bool pictured = drawn.stroke->picture && !m_drawing.unpainted;
    const double opacity = masked ? 1 : drawn.bands.front().opacity;
    QByteArray entries, colour;
    if (!pictured && !drawn.paint.isGradient())
        colour = pdfColour(drawn.paint.at({})) + " rg\n";
    if (opacity < 1)
        entries += "/ca " + pdf::number(opacity) + ' ';
    if (drawn.multiplies)
        entries += "/BM /Multiply ";
    if (masked || (!pictured && fades(drawn.paint)))
        entries += "/SMask << /S /Luminosity /G " + maskOf(drawn, box, masked) + " >>";
    return entries.isEmpty() ? colour : m_resources.state(entries) + " gs\n" + colour;
}

/// The bands as grey, and what a gradient takes of them.
QByteArray PdfStrokes::maskOf(const DrawnStroke &drawn, const Rect &box, bool masked)
{
    const QByteArray sheet = pdfBox(box) + " re\n";
    QByteArray content;
    if (masked) {
        const BandMask mask = bandMaskOf(drawn, m_drawing.bandCount);
        content = grey(mask.sheet / 255.0) + sheet + "f\n";
        QByteArray mode = "/Normal";
        for (const BandMask::Step &step : mask.steps) {
            const bool subtracts = step.put != BandMask::Put::Over;
            if (const QByteArray wanted = subtracts ? "/Difference" : "/Normal"; std::exchange(mode, wanted) != wanted)
                content += m_resources.state("/BM " + wanted) + " gs\n";
            content += grey(step.level / 255.0) + (step.put == BandMask::Put::Outside ? sheet : QByteArray()) +
                       m_text.pdf(*step.loops, step.bend) + (subtracts ? "f*\n" : "f\n");
        }
    } else {
        content = grey(1) + sheet + "f\n";
    }
    if (!drawn.stroke->picture && fades(drawn.paint))
        content +=
            m_resources.state("/BM /Multiply") + " gs\n" + m_resources.shading(shadingOf(drawn.paint, true)) + " sh\n";
    return pdf::reference(m_resources.addGroup(corners(box), content, "/DeviceGray"));
}

QByteArray PdfStrokes::shadingOf(const DrawnPaint &paint, bool opacities)
{
    return QByteArray("<< /ShadingType 2 /ColorSpace /") + (opacities ? "DeviceGray" : "DeviceRGB") + " /Coords [" +
           pdf::number(paint.from.x) + ' ' + pdf::number(paint.from.y) + ' ' + pdf::number(paint.to.x) + ' ' +
           pdf::number(paint.to.y) + "] /Extend [true true] /Function " + functionOf(paint.stops, opacities) + " >>";
}

/// The picture that a stroke shows. Strokes that show the same image share it.
QByteArray PdfStrokes::imageOf(const Stroke &stroke)
{
    const Picture &picture = *stroke.picture;
    const auto [known, isNew] = m_images.try_emplace(std::tuple(picture.sha256, picture.width, picture.height));
    if (isNew)
        if (const Result<DrawnImage> image = drawnImage(picture, m_cancel))
            if (const Result<int> added = addImage(m_objects, *image))
                known->second = *added;
    if (known->second == 0)
        return {};
    // An image of PDF is a unit wide and high, with its first row at the top of an axis that points up.
    const Affine upright{double(picture.width), 0, 0, -double(picture.height), {0, double(picture.height)}};
    return pdfMatrix(Affine::translation(stroke.origin) * mapOf(picture) * upright) + " cm\n" +
           m_resources.painted(known->second) + " Do\n";
}

} // namespace suffuse
