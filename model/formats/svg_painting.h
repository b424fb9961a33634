// SVG drawings as strokes: their curves, painted with a brush.
#pragma once

#include "model/brush/brush.h"
#include "model/formats/svg_paths.h"
#include "model/painting/painting.h"

namespace suffuse {

/// Strokes along the paths, painted with the brush at time `born`: scaled so that a dry stroke is as wide as the path's
/// stroke, in the colour of its stroke or else its fill. They have no ids yet. Paths that files cannot hold are left
/// out.
std::vector<Stroke> strokesAlong(const std::vector<SvgPath> &paths, const Brush &brush, Microseconds born);

/// Sentences for people on what of a drawing strokes cannot show; empty: nothing.
QString leftOutOf(const SvgDrawing &drawing);

/// All paths and shapes of a drawing, painted at time 0 on a canvas of the drawing's size (where it says none: around
/// what it draws). 1 CSS pixel is 1 canvas unit. `leftOut` receives leftOutOf. Errors name the file and the line.
Result<Painting> readSvg(const QByteArray &bytes, const QString &fileName, const Brush &brush,
                         QString *leftOut = nullptr);

} // namespace suffuse
