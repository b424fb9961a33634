// While a stroke is being drawn, the nodes of what has dried are kept, so that they need not be built again.
#pragma once

#include "render/nodes/node_builder.h"
#include "render/threads/parallel.h"

namespace suffuse {

/// Holds the leading blocks of a stroke that have dried, and their nodes. A later state of the stroke that begins with
/// the same segments begins with the same nodes, since a block's nodes depend on its segments alone.
struct FrozenNodes {
    StrokePtr stroke;
    int octave = 0;
    std::size_t segments = 0; ///< how many segments the blocks have together; a firm border of the stroke
    StrokeNodes nodes;
};

/// Builds the same nodes as buildNodes without `frozen`, bit for bit, but computes only what `frozen` does not hold.
/// Brings `frozen` (of any stroke, or empty) up to date for the next call.
std::shared_ptr<const StrokeNodes> buildNodes(const StrokePtr &stroke, Microseconds T, int octave, const Rect &clip,
                                              FrozenNodes &frozen, Threads threads = 1);

} // namespace suffuse
