// Sums over the part of a growing stroke that has dried, so that a frame costs the young part only.
#pragma once

#include "render/cpu/kernels.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <vector>

namespace suffuse::cpu {

/// What a block's sums start from.
struct BlockPrefix {
    Meeting meeting;         ///< of the nodes that are summed
    std::vector<float> sums; ///< the rows of Sums that the stroke has; empty where no node meets the block
};

/// A tile's sums over the first nodes of one stroke. Sums run in the nodes' order, so going on from here gives the bits
/// of sums from the start.
struct StrokePrefix {
    std::uint32_t stroke = 0; ///< in the scene's order
    std::size_t nodes = 0;    ///< so many of them
    Meeting meeting;          ///< with the whole tile
    std::vector<BlockPrefix> blocks;
};

std::size_t bytesOf(const StrokePrefix &prefix);

/// How many leading nodes of a stroke stay as they are.
struct SteadyStroke {
    std::uint32_t stroke = 0; ///< in the scene's order
    std::size_t nodes = 0;
};

/// So many separable nodes of settled blocks, with their channel values, do both states of a stroke begin with.
std::size_t steadyNodes(const SceneStroke &before, const SceneStroke &now);

} // namespace suffuse::cpu
