// Strokes so wide on screen that a float sum would lose their edge: a cubic Taylor polynomial per cell, in double.
#pragma once

#include "render/cpu/kernels.h"
#include "render/scene/scene.h"

namespace suffuse::cpu {

/// Shades a block of a stroke with deep nodes; `sums` hold what its other nodes add, and then everything. Cost does not
/// grow with zoom.
void shadeDeep(const Kernels &kernels, const SceneStroke &stroke, const Block &block, Sums &sums, const float *eta,
               Shaded &out);

} // namespace suffuse::cpu
