// How far a segment reaches. All other code asks here.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// How far the density of a segment counts for pixels and hit tests, in multiples of its spread s: beyond it e^(−r²) <
/// 1e-7.
inline constexpr double reachInSpreads = 4.0;

/// The box of a segment's control points grown by reachInSpreads · s at time T, where s is along the longer axis of an
/// anisotropic segment. It is empty at age ≤ 0. Canvas units.
Rect influenceOf(const Stroke &stroke, const Segment &segment, Microseconds T);
/// The same for a stroke's fill: the box of what bounds it, grown. It is empty where there is none.
Rect influenceOfFill(const Stroke &stroke, Microseconds T);
/// The union over all segments of a stroke and its fill.
Rect influenceOf(const Stroke &stroke, Microseconds T);
/// The box of the influence of all visible strokes; empty for an empty painting.
Rect influenceOf(const Painting &painting, Microseconds T);

} // namespace suffuse
