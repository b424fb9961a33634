// Copied strokes as a PDF page, for programs that take no other drawings.
#pragma once

#include "model/painting/painting.h"

#include <QByteArray>
#include <QImage>

namespace suffuse {

/// A page as large as what the strokes reach, 96 units an inch: bands that look like paint at any zoom where the
/// strokes are so few that nobody waits for them, else the picture. The strokes themselves are in it, so that opening
/// it gives them back. `picture` shows `area`, canvas units. Empty where no PDF can be made.
QByteArray pdfOfCopied(const PaintingPtr &strokes, Microseconds time, const Rect &area, const QImage &picture);

} // namespace suffuse
