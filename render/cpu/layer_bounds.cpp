#include "render/cpu/layer_bounds.h"

#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"

#include <algorithm>

namespace suffuse::cpu {

void LayerBounds::addPart(int part, BlendMode mode, const float *coverage)
{
    if (part != base)
        std::fill_n(shape, blockSize, 0.0f);
    base = part;
    for (std::size_t at = 0; at < blockSize; ++at)
        shape[at] = math::coverageWith(mode, coverage[at], shape[at]);
}

void LayerBounds::addMask(const float *coverage)
{
    if (masks++ == 0)
        std::copy_n(coverage, blockSize, mask);
    else
        for (std::size_t at = 0; at < blockSize; ++at)
            mask[at] *= coverage[at];
}

bool boundsOf(const Layer &layer, const LayerBounds &own, const LayerBounds &around, float *share)
{
    if (layer.clippedTo == Layer::none && layer.masks == 0)
        return false;
    std::fill_n(share, blockSize, 1.0f);
    if (layer.clippedTo != Layer::none)
        for (std::size_t at = 0; at < blockSize; ++at)
            share[at] = around.base == layer.clippedTo ? around.shape[at] : 0;
    if (layer.masks > 0)
        for (std::size_t at = 0; at < blockSize; ++at)
            share[at] *= own.masks == layer.masks ? own.mask[at] : 0;
    return true;
}

} // namespace suffuse::cpu
