// The picture on a page, dot by dot, in pieces.
#pragma once

#include "app/dialogs/print/page_plan.h"
#include "render/renderer.h"

#include <QImage>
#include <QPoint>

#include <functional>

namespace suffuse {

/// What is printed.
struct PageOrder {
    PaintingPtr painting;
    Microseconds time = 0;
    PagePlan plan;
    bool background = true; ///< or else the paint lies on white paper
    int threads = 0;        ///< 0: all cores
};

/// How many dots are drawn at once, which bounds the memory, and how long the sides of the pieces are: a printer's
/// driver packs one in less than a tenth of a second, in which nothing can be cancelled. Pieces end at multiples of
/// their side on the sheet. With the usual numbers of dots an inch these are whole pixels of viewers, which otherwise
/// would stretch each piece to whole ones.
inline constexpr int dotsOfBand = 1 << 24, sideOfPiece = 800;

/// Takes a piece of the page. Its place is in dots of the sheet. The image's memory is used again afterwards.
using PutPiece = std::function<void(const QPoint &at, const QImage &piece)>;

/// Draws the page with so many dots an inch and gives it away piece by piece, each opaque. `progress` gets per mille. It
/// fails if the renderer does, or, with an empty error, if it was cancelled.
Result<void> drawPage(const PageOrder &order, double dpi, Renderer &renderer, const PutPiece &put,
                      const std::atomic<bool> &cancel, const std::function<void(int)> &progress = {});

} // namespace suffuse
