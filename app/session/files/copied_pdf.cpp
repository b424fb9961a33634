#include "app/session/files/copied_pdf.h"

#include "model/formats/files.h"
#include "render/drawing/drawing_pdf.h"

#include <QBuffer>

namespace suffuse {

namespace {

/// What is drawn as bands takes about a millisecond a segment, and dark edges many of them.
constexpr std::size_t mostWork = 256, workOfDarkEdge = 16;

bool isQuick(const Painting &painting)
{
    std::size_t work = 0;
    for (const StrokePtr &stroke : painting.strokes)
        for (const Segment &segment : stroke->segments)
            work += stroke->styleOf(segment).kind == StyleKind::Edge ? workOfDarkEdge : 1;
    return work <= mostWork;
}

/// The strokes on a sheet that is as large as what they reach.
PaintingPtr onOwnSheet(const Painting &painting, const Rect &area)
{
    auto sheet = std::make_shared<Painting>(painting);
    sheet->canvas.width = area.width();
    sheet->canvas.height = area.height();
    sheet->canvas.background.opacity = 0;
    StrokeList moved;
    for (const StrokePtr &stroke : painting.strokes) {
        auto own = std::make_shared<Stroke>(*stroke);
        own->origin = own->origin - Point{area.left, area.top};
        moved.push_back(std::move(own));
    }
    sheet->strokes = std::move(moved);
    return sheet;
}

} // namespace

QByteArray pdfOfCopied(const PaintingPtr &strokes, Microseconds time, const Rect &area, const QImage &picture)
{
    constexpr double largestSheet = 1e6;
    if (!(area.width() > 0 && area.height() > 0 && area.width() <= largestSheet && area.height() <= largestSheet))
        return {};
    const PaintingPtr sheet = onOwnSheet(*strokes, area);
    DrawingOptions options;
    options.format = DrawingFormat::Pdf;
    options.time = time;
    PathDrawing drawing;
    QByteArray png;
    if (isQuick(*strokes)) {
        drawing = drawingOf(sheet, options);
    } else {
        drawing.painting = sheet;
        drawing.format = options.format;
        drawing.unpainted = true;
        QBuffer buffer(&png);
        picture.save(&buffer, "PNG");
    }
    const Result<QByteArray> pdf = pdfOf({PdfPage{drawing, png, {}, writeSuffuseFile(*strokes)}}, {});
    return pdf ? *pdf : QByteArray();
}

} // namespace suffuse
