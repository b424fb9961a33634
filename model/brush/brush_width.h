// How wide a brush paints to the eye.
#pragma once

#include "model/brush/brush.h"
#include "model/brush/brush_dynamics.h"
#include "model/painting/segment.h"

namespace suffuse {

/// The half-width of the visible paint of a long, straight, dry stroke at full pressure, canvas units. There its
/// profile pk·e^(−v²/s²) has fallen to the density at which the style is half opaque (for edge darkening: at which it
/// ends). It is 0 if the profile never has so much density.
double halfWidthOf(const Brush &brush);

/// The same where the pen is at another pressure, tilt, speed and distance from the start. What is random is in the middle
/// of its range, and nothing tapers.
double halfWidthOf(const Brush &brush, const PenState &pen);
/// The spread s there, units.
double spreadOf(const Brush &brush, const PenState &pen);

/// The values of a segment that is painted with the brush at full pressure, in its colour; it has no shape yet.
Segment valuesAtFullPressure(const Brush &brush);

/// The width of a long, straight, dry stroke of the brush where no curve makes it smaller, units. If strokes of the
/// brush are too thin to have an edge, it is twice the spread. It is in proportion to the spread.
double visibleWidth(const Brush &brush);
/// Gives the brush another spread, so that this is its visible width; the peak stays. The spread stays between 1e-7 and
/// 1e5 units.
void setVisibleWidth(Brush &brush, double width);

} // namespace suffuse
