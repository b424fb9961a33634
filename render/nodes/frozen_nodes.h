// Nodes of a stroke that is being drawn: what has dried is not built again.
#pragma once

#include "render/nodes/node_builder.h"
#include "render/threads/parallel.h"

namespace suffuse {

/// The leading blocks of a stroke that have dried, and their nodes. A later state of the stroke that begins with the
/// same segments begins with the same nodes, since a block's nodes depend on its segments alone.
struct FrozenNodes {
    StrokePtr stroke;
    int octave = 0;
    std::size_t segments = 0; ///< so many from the stroke's begin: a firm border of it
    StrokeNodes nodes;
};

/// As buildNodes, bit for bit, at the cost of what `frozen` does not hold. Brings `frozen` (of any stroke, or empty) up
/// to date for the next call.
std::shared_ptr<const StrokeNodes> buildNodes(const StrokePtr &stroke, Microseconds T, int octave, const Rect &clip,
                                              FrozenNodes &frozen, Threads threads = 1);

} // namespace suffuse
