#include "render/drawing/drawing_file.h"

#include "model/formats/files.h"
#include "model/formats/gzip.h"
#include "model/formats/svg/svg_embedding.h"
#include "render/drawing/drawing_svg.h"
#include "render/image_io/image_io.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

#include <cmath>
#include <span>

namespace suffuse {

namespace {

Error drawingInterrupted()
{
    return Error{QCoreApplication::translate("Drawing", "interrupted; nothing was written")};
}

bool isCancelled(const std::atomic<bool> *cancel)
{
    return cancel && cancel->load(std::memory_order_relaxed);
}

/// The sheet with a pixel a unit as a PNG.
Result<QByteArray> pictureOfSheet(const PaintingPtr &painting, const DrawingOptions &options, Renderer &renderer)
{
    const Rect area = painting->canvas.area();
    ImageOptions image;
    image.alpha = painting->canvas.background.opacity < 1;
    image.cancel = options.cancel;
    const int width = std::max(1, int(std::lround(area.width())));
    const int height = std::max(1, heightForWidth(area, width));
    if (const QString problem = problemOf(ImageFormat::Png, image, width, height); !problem.isEmpty())
        return Error{problem};
    if (qint64(width) * height > maxPicturePixels)
        return Error{
            QCoreApplication::translate("Drawing", "the sheet is too large for a picture with a pixel a unit")};
    RenderRequest request;
    request.painting = withoutDrafts(painting);
    request.time = options.time;
    request.view = View::ofArea(area, width, height);
    request.transparent = image.alpha;
    FloatPicture picture;
    const Result<RenderStats> stats = renderer.render(request, picture, options.cancel);
    if (!stats)
        return Error{stats.error()};
    if (stats->cancelled)
        return drawingInterrupted();
    return encodeImage(ImageFormat::Png, picture, image, QStringLiteral("PNG"));
}

Result<QByteArray> pdfBytes(std::span<const PreparedDrawing> prepared, std::span<const Painting> paintings,
                            const std::atomic<bool> *cancel)
{
    std::vector<PdfPage> pages;
    for (std::size_t k = 0; k < prepared.size(); ++k) {
        const Canvas &canvas = paintings[k].canvas;
        const PageSize paper = prepared[k].paper.value_or(ownPage(canvas.width, canvas.height, prepared[k].resolution));
        pages.push_back({prepared[k].drawing, prepared[k].png, paper, writeSuffuseFile(paintings[k])});
    }
    Result<QByteArray> pdf = pdfOf(pages, prepared.front().about, cancel);
    return pdf || !isCancelled(cancel) ? std::move(pdf) : Result<QByteArray>(drawingInterrupted());
}

QString ofLevels(double value)
{
    return QLocale().toString(255 * value, 'f', 255 * value < 10 ? 2 : 0);
}

} // namespace

Result<PreparedDrawing> prepareDrawing(const PaintingPtr &painting, const DrawingOptions &options, Renderer &renderer)
{
    PreparedDrawing out;
    out.drawing = drawingOf(painting, options);
    if (isCancelled(options.cancel))
        return drawingInterrupted();
    if (options.kind == DrawingKind::Hybrid) {
        Result<QByteArray> png = pictureOfSheet(painting, options, renderer);
        if (!png)
            return Error{png.error()};
        out.png = std::move(*png);
        renderer.invalidate();
    }
    const Result<DrawingDifference> difference =
        differenceOf(out.drawing, painting, options.time, renderer, options.cancel);
    if (!difference)
        return Error{difference.error()};
    if (isCancelled(options.cancel))
        return drawingInterrupted();
    out.difference = *difference;
    return out;
}

Result<QByteArray> bytesOf(const PreparedDrawing &prepared, const Painting &painting, const QString &name,
                           const std::atomic<bool> *cancel)
{
    if (prepared.drawing.format == DrawingFormat::Pdf)
        return pdfBytes({&prepared, 1}, {&painting, 1}, cancel);
    const QByteArray svg = svgOf(prepared.drawing, prepared.png, prepared.resolution, cancel);
    if (svg.isEmpty() || isCancelled(cancel))
        return drawingInterrupted();
    QByteArray whole = withEmbedded(svg, writeSuffuseFile(painting));
    if (!name.endsWith(QLatin1String("svgz"), Qt::CaseInsensitive))
        return whole;
    if (whole.size() > largestUnpacked)
        return Error{QCoreApplication::translate("Drawing",
                                                 "%1: would have %2 MB once it is unpacked, and could not be "
                                                 "opened again. Choose fewer bands, or the ending .svg.")
                         .arg(name)
                         .arg(whole.size() >> 20)};
    QByteArray packed = packedGzip(whole, cancel);
    return packed.isEmpty() ? Result<QByteArray>(drawingInterrupted()) : packed;
}

Result<QByteArray> bytesOf(const std::vector<PreparedDrawing> &prepared, const std::vector<Painting> &paintings,
                           const QString &name, const std::atomic<bool> *cancel)
{
    return prepared.size() > 1 ? pdfBytes(prepared, paintings, cancel)
                               : bytesOf(prepared.front(), paintings.front(), name, cancel);
}

Result<void> saveDrawing(const PreparedDrawing &prepared, const Painting &painting, const QString &path,
                         const std::atomic<bool> *cancel)
{
    const Result<QByteArray> bytes = bytesOf(prepared, painting, path, cancel);
    return bytes ? writeFileAtomically(path, *bytes) : Result<void>(Error{bytes.error()});
}

std::optional<DrawingFormat> drawingFormatFor(const QString &path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("svg") || ending == QLatin1String("svgz"))
        return DrawingFormat::Svg;
    return ending == QLatin1String("pdf") ? std::optional(DrawingFormat::Pdf) : std::nullopt;
}

QString leftOutOf(const PreparedDrawing &prepared)
{
    QStringList said;
    if (prepared.drawing.plain > 0)
        said << (prepared.drawing.format == DrawingFormat::Pdf
                     ? QCoreApplication::translate("Drawing",
                                                   "PDF has no groups that erase what lies below, or add to it: %n "
                                                   "group(s) became plain.",
                                                   nullptr, prepared.drawing.plain)
                     : QCoreApplication::translate(
                           "Drawing", "SVG has no groups that erase what lies below: %n group(s) became plain.",
                           nullptr, prepared.drawing.plain));
    if (prepared.drawing.thin > 0)
        said << QCoreApplication::translate(
            "Drawing",
            "%n stroke(s) are left out, since nothing of them is covered enough to have "
            "a path.",
            nullptr, prepared.drawing.thin);
    return said.join(QLatin1Char(' '));
}

QString differenceText(const DrawingDifference &difference)
{
    return QCoreApplication::translate("Drawing",
                                       "The drawing differs from the picture by at most %1 of 255, by %2 on average.")
        .arg(ofLevels(difference.largest), ofLevels(difference.mean));
}

} // namespace suffuse
