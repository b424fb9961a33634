// Writes strokes as SVG: their curves, not their paint. svg_painting.h is the way back.
#pragma once

#include "model/formats/svg/svg_painting.h"

#include <QByteArray>

namespace suffuse {

/// The visible strokes of a painting as an SVG document: a <path> for each run of segments that look alike, in its
/// colour and as wide as the dry paint is seen. The view box is the influence of the strokes, in canvas units.
QByteArray svgOf(const Painting &painting);

} // namespace suffuse
