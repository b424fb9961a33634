// What is seen of a painting as plain numbers.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"
#include "render/gradient/flat_scene.h"
#include "render/threads/parallel.h"

namespace suffuse::gradient {

struct FlatPainting {
    FlatScene scene;
    std::vector<std::size_t> strokes;  ///< of each flat stroke: its place in the order of the painting
    std::vector<std::size_t> segments; ///< of each flat segment: its place in its stroke
};

/// Returns what is seen of a painting at a time, with its paper. It fails, and names the stroke, where its picture has
/// no gradient: in groups that blend and in washes, with pictures, tensors, styles that vary along a stroke, with edge
/// darkening of which paint is taken away, with fills whose colour changes or whose outline crosses itself, and where
/// the renderer takes several samples of a pixel, as spreads are below 1 px (4 px where paint is taken away, 2 px where
/// it is made paler).
Result<FlatPainting> flatten(const Painting &painting, Microseconds time, const View &view, const Threads &threads);

} // namespace suffuse::gradient
