// How wide a brush paints to the eye.
#pragma once

#include "model/brush/brush.h"

namespace suffuse {

/// Half-width of the visible paint of a long, straight, dry stroke at full pressure: where its profile pk·e^(−v²/s²)
/// falls to the density at which the style is half opaque (edge darkening: where it ends). 0 if it never gets there.
/// Canvas units.
double halfWidthOf(const Brush &brush);

/// Width of a long, straight, dry stroke of the brush where no curve takes away, units; twice the spread of brushes
/// whose strokes are too thin to have an edge. It is in proportion to the spread.
double visibleWidth(const Brush &brush);

} // namespace suffuse
