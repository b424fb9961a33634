// What bounds the layers of a block: the coverage of what they are clipped to, and that of masks.
#pragma once

#include "render/composition/composition.h"
#include "render/cpu/blocks.h"

namespace suffuse::cpu {

/// What bounds the layers that are put on one backdrop of a block, and that backdrop itself.
struct LayerBounds {
    int base = Layer::none; ///< the base whose coverage `shape` has; that of all others is 0 here
    int masks = 0;          ///< how many masks have multiplied `mask`
    alignas(64) float shape[blockSize];
    alignas(64) float mask[blockSize];

    /// Adds the coverage of a part of a base as the mode has it.
    void addPart(int part, BlendMode mode, const float *coverage);
    void addMask(const float *coverage);
};

/// The share of a layer that its bounds let through: the coverage of what it is clipped to, times that of its masks.
/// What did not come to this block has coverage 0 here. `own` bounds the layer, `around` what it is put on. Returns
/// false if it is not bounded.
bool boundsOf(const Layer &layer, const LayerBounds &own, const LayerBounds &around, float *share);

} // namespace suffuse::cpu
