// Strokes as SVG and back: the curves, not the paint.
#pragma once

#include "model/brush.h"
#include "model/formats/svg_paths.h"
#include "model/painting.h"

#include <QByteArray>

namespace suffuse {

/// The visible strokes of a painting as an SVG document: a <path> for each run of segments of one look, as wide as the
/// paint is seen when dry, in its colour. Its view box is the influence of the strokes, in canvas units.
QByteArray svgOf(const Painting &painting);

/// Strokes along the paths, painted with the brush at time `born`: scaled so that a dry stroke is as wide as the path's
/// stroke, in the colour of its stroke or else its fill. They have no ids yet. Paths that files cannot hold are left
/// out.
std::vector<Stroke> strokesAlong(const std::vector<SvgPath> &paths, const Brush &brush, Microseconds born);

} // namespace suffuse
