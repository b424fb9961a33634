// Drawings as SVG documents.
#pragma once

#include "render/drawing/path_drawing.h"

#include <QByteArray>

namespace suffuse {

/// A drawing as SVG with CSS's blend modes: groups as Inkscape's layers, paths with the names of strokes. The bands of
/// a stroke are a mask, through which its colour is seen: from a sheet that is as light as the most opaque band, each
/// band takes outside of itself what it has more than the one around it (mix-blend-mode: difference). So a pixel that
/// several contours cross gets the mean of what they part, as no painting of one shape over another would give it, and
/// no renderer shows seams. `png`: the picture of the whole sheet, if the drawing is one of unpainted paths.
/// `resolution`: the units of an inch, by which the sheet has its size on paper; 0: it has it in pixels. Empty if
/// `cancel` has become true.
QByteArray svgOf(const PathDrawing &drawing, const QByteArray &png, double resolution,
                 const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
