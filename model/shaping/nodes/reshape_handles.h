// Where the two handles of a node belong together.
#pragma once

#include "model/shaping/curves/chains.h"

#include <optional>

namespace suffuse {

/// The segments that meet at a node where the curve goes on: at an inner node, or at the seam of a closed chain by
/// either of its numbers. No value at an end.
std::optional<NodeSides> joinAt(const Stroke &stroke, int node);

} // namespace suffuse
