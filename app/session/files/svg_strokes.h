// Writes strokes as SVG: their curves, not their paint. svg_painting.h is the way back.
#pragma once

#include "model/formats/svg/svg_painting.h"

#include <QByteArray>

namespace suffuse {

/// Strokes as an SVG document.
struct SvgStrokes {
    QByteArray bytes;
    int erasures = 0; ///< which SVG has nothing for: they are left out
};
/// The visible strokes of a painting, in their groups: a <path> for the area of a fill, in its colour or gradient, and
/// one for each run of segments that look alike, in its colour and as wide as the dry paint is seen; each chain is a
/// subpath. A stroke of several paths is a group. The view box is the influence of the strokes, in canvas units.
/// With an `area` that is the view box, and the colour of an opaque canvas lies in it under everything, as a <rect>
/// with the id "background".
SvgStrokes svgOf(const Painting &painting, const Rect &area = {});
/// Empty, or what is said of erasures that a drawing leaves out, translated.
QString leftOutOf(const SvgStrokes &svg);
/// How many erasures the visible strokes have.
int erasuresIn(const Painting &painting);

} // namespace suffuse
