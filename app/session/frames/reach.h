// How much of a picture strokes reach: what drawing them will cost.
#pragma once

#include "model/painting/painting.h"
#include "render/view.h"

namespace suffuse {

/// Pixels of the view that the influence of what differs covers, before and after, roughly; and how many strokes that
/// are, counted before and after.
struct Difference {
    double pixels = 0;
    std::size_t strokes = 0;
};
Difference differenceOf(const Painting &before, const Painting &after, const View &view, Microseconds time);

/// Pixels of the view that the influence of a painting's strokes covers, roughly.
double reachedPixels(const Painting &painting, const View &view, Microseconds time);

} // namespace suffuse
