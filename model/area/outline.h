// The closed outline of a stroke, which bounds its fill.
#pragma once

#include "model/painting/stroke.h"

namespace suffuse {

/// The chains of a stroke as closed loops, offsets from its origin: a loop's curves follow each other, and the last
/// ends where the first begins. Segments that take paint away are left out; straight lines bridge the gaps and close
/// the loops. Loops without any extent are left out.
std::vector<std::vector<Cubic>> closedOutline(const Stroke &stroke);

/// Loops that run as often around every point of a window as these do: what passes it by on one side is straight there.
/// So the boundary within the window is the same, and is found soon even where it is intricate elsewhere.
std::vector<std::vector<Cubic>> shortenedAround(const Rect &window, const std::vector<std::vector<Cubic>> &loops);

/// The box of the control points of the segments that bound a fill, offsets from the origin.
Rect outlineBox(const Stroke &stroke);

/// Whether a segment only bounds the fill of its stroke: it lays no paint of its own.
bool onlyBounds(const Stroke &stroke, std::size_t segment);
/// Whether a stroke is its fill alone.
bool isFillAlone(const Stroke &stroke);

/// Whether two strokes have the same outline, relative to their origins.
bool sameOutline(const Stroke &a, const Stroke &b);

} // namespace suffuse
