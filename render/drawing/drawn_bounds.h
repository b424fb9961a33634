// What groups of a drawing are seen through: masks, and what lies below clipped ones.
#pragma once

#include "render/drawing/path_drawing.h"

namespace suffuse {

/// Takes the strokes of masks out of a drawing, and notes for each group around them, and for each that is clipped,
/// what it is seen through (docs/solver.md, "Clipped groups and masks"). `shown` are the drawing's paths of all visible
/// strokes, in their order; some may be empty. Within what something is seen through, masks bound nothing, and the
/// opacity of a group is that of each of its strokes.
void takeBounds(PathDrawing &drawing, std::vector<DrawnStroke> &shown);

} // namespace suffuse
