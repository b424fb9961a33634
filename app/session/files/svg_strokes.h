// Strokes as SVG: the curves, not the paint. svg_painting.h is the way back.
#pragma once

#include "model/formats/svg/svg_painting.h"

#include <QByteArray>

namespace suffuse {

/// The visible strokes of a painting as an SVG document: a <path> for each run of segments of one look, as wide as the
/// paint is seen when dry, in its colour. Its view box is the influence of the strokes, in canvas units.
QByteArray svgOf(const Painting &painting);

} // namespace suffuse
