// Sums over the part of a growing stroke that has dried, so that a frame costs only the young part.
#pragma once

#include "render/cpu/kernels.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <vector>

namespace suffuse::cpu {

/// The sums from which those of a block start.
struct BlockPrefix {
    Meeting meeting;         ///< for the nodes that are summed
    std::vector<float> sums; ///< the rows of Sums that the stroke has; empty if no node meets the block
};

/// The sums of a tile over the first nodes of one stroke. Sums are computed in the order of the nodes, so continuing
/// from here gives the same bits as sums from the start.
struct StrokePrefix {
    std::uint32_t stroke = 0; ///< its index in the scene
    std::size_t nodes = 0;    ///< how many of its nodes are summed
    Meeting meeting;          ///< for the whole tile
    std::vector<BlockPrefix> blocks;
};

std::size_t bytesOf(const StrokePrefix &prefix);

/// How many of a stroke's first nodes stay as they are.
struct SteadyStroke {
    std::uint32_t stroke = 0; ///< its index in the scene
    std::size_t nodes = 0;
};

/// With how many equal separable nodes of settled blocks, and their channel values, both states of a stroke begin.
std::size_t steadyNodes(const SceneStroke &before, const SceneStroke &now);

} // namespace suffuse::cpu
