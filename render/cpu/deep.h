// Draws strokes so wide on the screen that a float sum would lose their edge, with a cubic Taylor polynomial for each
// cell, in double.
#pragma once

#include "render/cpu/kernels.h"
#include "render/scene/scene.h"

namespace suffuse::cpu {

/// Shades a block of a stroke with deep nodes. `sums` has what its other nodes add, and afterwards everything. The cost
/// does not grow with zoom.
void shadeDeep(const Kernels &kernels, const SceneStroke &stroke, const Block &block, Sums &sums, const float *eta,
               Shaded &out);

} // namespace suffuse::cpu
