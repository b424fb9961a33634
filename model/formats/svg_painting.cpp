#include "model/formats/svg_painting.h"

#include "model/formats/messages.h"
#include "model/painting/ryb.h"
#include "model/stroke_width.h"
#include "model/painting/validate.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr qint64 largestSvg = qint64(64) << 20;
constexpr double largestCanvas = 1e6;

/// The values of a segment painted with the brush, so that the dry stroke is `width` wide (0: as the brush is).
Segment valuesOf(const Brush &brush, double width)
{
    Segment segment;
    segment.diffusion = brush.diffusion;
    segment.density = float(double(brush.peak) * std::sqrt(std::numbers::pi) * brush.spread());
    segment.granulation = brush.granulation;
    segment.maxAge = brush.maxAge;
    if (!(width > 0))
        return segment;
    const double half =
        halfWidth(double(segment.diffusion), double(segment.density), double(segment.maxAge), visibleCut(brush.style));
    const double scale = half > 0 ? 0.5 * width / half : width / (2 * brush.spread());
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

/// Puts the corner of `area` at (0, 0), `scale` canvas units to one of the drawing.
void place(std::vector<SvgPath> &paths, const Rect &area, double scale)
{
    for (SvgPath &path : paths) {
        path.strokeWidth *= scale;
        for (Cubic &cubic : path.curves)
            for (Point &p : cubic.p)
                p = scale * (p - Point{area.left, area.top});
    }
}

/// Whole units, however the size was rounded on its way.
double wholeUnits(double size)
{
    return std::max(1.0, std::ceil(size - 1e-3));
}

} // namespace

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
        stroke.segments.reserve(path.curves.size());
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

QString leftOutOf(const SvgDrawing &drawing)
{
    QStringList sentences;
    if (drawing.fills > 0)
        sentences << FileMessages::tr("Fills were left out: filled shapes are painted along their outlines.");
    if (drawing.leftOut > 0)
        sentences << FileMessages::tr(
            "Text and images of the drawing were left out: only paths and shapes are strokes.");
    return sentences.join(' ');
}

Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush &brush, QString *leftOut)
{
    if (bytes.size() > largestSvg)
        return fileError(fileName, FileMessages::tr("has more than 64 MB of XML; that is more than is read"));
    Result<SvgDrawing> drawing = readSvgDrawing(bytes);
    if (!drawing)
        return fileError(fileName, drawing.error());
    const bool isSized = !drawing->area.isEmpty();
    const Rect area = isSized ? drawing->area : boundsOf(drawing->paths).grown(2 * brush.spread());
    const double width = area.width() * drawing->scale, height = area.height() * drawing->scale;
    if (!(width <= largestCanvas && height <= largestCanvas))
        return fileError(fileName,
                         FileMessages::tr("the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down")
                             .arg(width)
                             .arg(height));
    Painting painting;
    painting.canvas.width = wholeUnits(width);
    painting.canvas.height = wholeUnits(height);
    place(drawing->paths, area, drawing->scale);
    for (Stroke &stroke : strokesAlong(drawing->paths, brush, 0)) {
        stroke.id = StrokeId(painting.strokes.size() + 1);
        painting.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }
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
