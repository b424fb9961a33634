// SVG drawings as strokes: their curves, painted with a brush.
#pragma once

#include "model/brush/brush.h"
#include "model/formats/svg/svg_paths.h"
#include "model/painting/painting.h"

namespace suffuse {

/// What a drawing shows as strokes and groups, painted with the brush at time `born`: scaled so that a dry stroke is as
/// wide as the path's stroke, in the colour of its stroke or else its fill. Names come along. The canvas is as large as
/// the drawing (where it says no size: as its paths and 2 s around them), its corner at (0, 0); 1 CSS pixel is 1 canvas
/// unit. Paths that files cannot hold are left out.
Painting paintingAlong(const SvgDrawing &drawing, const Brush &brush, Microseconds born);

/// Sentences for people on what of a drawing strokes cannot show, each kind with its number; empty: nothing.
QString leftOutOf(const SvgDrawing &drawing);

/// A whole file as `paintingAlong` paints it, at time 0. `leftOut` receives leftOutOf. Errors name the file and the
/// line.
Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush &brush,
                         QString *leftOut = nullptr);

} // namespace suffuse
