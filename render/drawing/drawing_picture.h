// What programs that know nothing of paint show of a drawing, and how far that is from the picture.
#pragma once

#include "render/drawing/path_drawing.h"
#include "render/renderer.h"

namespace suffuse {

/// Draws paths over the canvas as SVG has it: on sRGB-encoded values, each path's edge covering pixels in part, groups
/// by their opacity, mode and isolation. The view is neither turned nor mirrored.
FloatPicture pictureOf(const PathDrawing &drawing, const View &view, const std::atomic<bool> *cancel = nullptr);

/// How far a drawing is from the picture, over the sheet: of red, green and blue, each in [0, 1].
struct DrawingDifference {
    double largest = 0;
    double mean = 0;
};

/// Draws both with a pixel a unit (large sheets with fewer) and compares them. It fails if the renderer does, or if it
/// was cancelled.
Result<DrawingDifference> differenceOf(const PathDrawing &drawing, const PaintingPtr &painting, Microseconds T,
                                       Renderer &renderer, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse
