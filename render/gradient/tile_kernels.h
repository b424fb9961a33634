// The inner loops of drawing a tile and of going back through it, compiled for several SIMD instruction sets in float,
// and once in double.
#pragma once

#include "render/gradient/tile_data.h"

namespace suffuse::gradient {

/// Returns those for the best instruction set of this machine, or those in double.
template <class Number>
const TileKernels<Number> &tileKernels();
template <>
const TileKernels<float> &tileKernels<float>();
template <>
const TileKernels<double> &tileKernels<double>();

} // namespace suffuse::gradient
