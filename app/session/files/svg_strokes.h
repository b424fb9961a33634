// Writes strokes as SVG: their curves, not their paint. svg_painting.h is the way back.
#pragma once

#include "model/formats/svg/svg_painting.h"

#include <QByteArray>

namespace suffuse {

/// Strokes as an SVG document.
struct SvgStrokes {
    QByteArray bytes;
    /// What SVG has nothing for: erasures and pictures, which are left out; groups that are clipped, are masks, or act on what lies
    /// below by their coverage alone (the last three of BlendMode), and washes, which are all plain groups.
    int erasures = 0, pictures = 0, masks = 0, washes = 0;
};
/// What of a painting SVG has nothing for; without bytes.
SvgStrokes lossesOf(const Painting &painting);
/// The visible strokes of a painting, in their groups: a <path> for the area of a fill, in its colour or gradient, and
/// one for each run of segments that look alike, in its colour and as wide as the dry paint is seen; each chain is a
/// subpath. Groups keep opacity, mode and isolation as CSS has them. A stroke of several paths is a group. The view box
/// is the influence of the strokes, in canvas units. With an `area` that is the view box, and the colour of an opaque
/// canvas lies in it under everything, as a <rect> with the id "background".
SvgStrokes svgOf(const Painting &painting, const Rect &area = {});
/// Empty, or what is said of what a drawing loses, translated.
QString leftOutOf(const SvgStrokes &svg);

} // namespace suffuse
