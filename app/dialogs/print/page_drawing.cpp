#include "app/dialogs/print/page_drawing.h"

#include <QPainter>

#include <algorithm>

namespace suffuse {

namespace {

/// The painting on white paper.
PaintingPtr onPaper(const PaintingPtr &painting)
{
    auto onWhite = std::make_shared<Painting>(*painting);
    onWhite->canvas.background = {0, 0, 0, 1};
    return onWhite;
}

/// What of a band lies at a place, on white: backgrounds need not be opaque.
QImage pieceOf(const Picture8 &band, const QRect &at)
{
    const QImage whole(reinterpret_cast<const uchar *>(band.argb.data()), band.width, band.height, 4 * band.width,
                       QImage::Format_ARGB32);
    QImage piece(at.size(), QImage::Format_RGB32);
    piece.fill(Qt::white);
    QPainter painter(&piece);
    painter.drawImage(QPoint(), whole, at);
    return piece;
}

int nextMultiple(int of, int side)
{
    return (of / side + 1) * side;
}

/// How many rows of a page are drawn at once: a piece, or a half, a quarter … of one where the page is very wide.
int rowsOfBand(int width)
{
    constexpr int least = 50;
    int rows = sideOfPiece;
    while (rows > least && qint64(rows) * width > dotsOfBand)
        rows /= 2;
    return rows;
}

} // namespace

Result<void> drawPage(const PageOrder &order, double dpi, Renderer &renderer, const PutPiece &put,
                      const std::atomic<bool> &cancel, const std::function<void(int)> &progress)
{
    const PixelRect page = order.plan.dots(dpi);
    RenderRequest request;
    request.painting = withoutDrafts(order.background ? order.painting : onPaper(order.painting));
    request.time = order.time;
    request.view = order.plan.view(dpi);
    const int rows = rowsOfBand(page.width);
    Picture8 band;
    for (int top = 0, below = 0; top < page.height && !cancel; top = below) {
        below = std::min(nextMultiple(page.y + top, rows) - page.y, page.height);
        const int height = below - top;
        request.part = {0, top, page.width, height};
        if (const auto stats = renderer.render(request, band, &cancel); !stats)
            return Error{stats.error()};
        for (int x = 0, right = 0; x < page.width && !cancel; x = right) {
            right = std::min(nextMultiple(page.x + x, sideOfPiece) - page.x, page.width);
            put(QPoint(page.x + x, page.y + top), pieceOf(band, QRect(x, 0, right - x, height)));
        }
        if (progress)
            progress(int(1000 * qint64(below) / page.height));
    }
    return cancel ? Result<void>(Error{}) : Result<void>();
}

} // namespace suffuse
