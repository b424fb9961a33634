// How far a segment reaches. Every other place asks here.
#pragma once

#include "model/painting/painting.h"

namespace suffuse {

/// Reach of a segment's density in multiples of its spread s, for pixels and hit tests: beyond it e^(−r²) < 1e-7.
inline constexpr double reachInSpreads = 4.0;

/// Box of the segment's control points grown by reachInSpreads · s (the longer axis where anisotropic) at time T;
/// empty at age ≤ 0. Canvas units.
Rect influenceOf(const Stroke &stroke, const Segment &segment, Microseconds T);
/// United over the segments.
Rect influenceOf(const Stroke &stroke, Microseconds T);
/// Box of all visible strokes' influence; empty for an empty painting.
Rect influenceOf(const Painting &painting, Microseconds T);

} // namespace suffuse
