// Makes strokes of SVG drawings: their curves, painted with a brush.
#pragma once

#include "model/brush/brush.h"
#include "model/formats/svg/paths/svg_paths.h"
#include "model/painting/painting.h"

namespace suffuse {

/// The brush of drawings for which none was chosen. Its strokes look like those of a round pen of constant width: they
/// have an edge as crisp as that of fills, and hold so much paint that the edge lies as far from the ends of a line,
/// and from where it bends, as from its middle, but for a few hundredths.
Brush svgPen();

/// What a drawing shows as strokes and groups, painted with the brush at time `born`. They are scaled so that a dry
/// stroke is as wide as the path's stroke, in the colour of its stroke or else of its fill. Names are kept. The canvas
/// is as large as the drawing (if the drawing has no size: as its paths and 2 s around them), with its corner at (0,
/// 0). 1 CSS pixel is 1 canvas unit. Paths that files cannot store are left out.
Painting paintingAlong(const SvgDrawing &drawing, const Brush &brush, Microseconds born);

/// Sentences for people about what strokes cannot show of a drawing, each kind with its number; empty if there is
/// nothing.
QString leftOutOf(const SvgDrawing &drawing);

/// Reads a whole file and paints it like `paintingAlong`, at time 0. Without a brush it is painted with svgPen, or with
/// the first brush where lines lie over each other so often that it would take long to draw so much paint. A
/// rectangle behind everything with the id "background", which covers the page in one opaque colour, is the colour of
/// the canvas. `leftOut` receives leftOutOf. Errors name the file and the line.
Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush *brush,
                         QString *leftOut = nullptr);
inline Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush &brush,
                                QString *leftOut = nullptr)
{
    return readSvg(bytes, fileName, &brush, leftOut);
}

} // namespace suffuse
