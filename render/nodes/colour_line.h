// If the colours along a stroke lie on one line of colour space (a gradient between two colours), they need one sum
// instead of four.
#pragma once

#include "render/nodes/node_builder.h"

#include <optional>
#include <span>

namespace suffuse {

struct ColourLine {
    Colour from, to;

    /// The place of a colour on the line: 0 at `from`, 1 at `to`.
    float placeOf(const Colour &c) const;
};

/// The line through all colours that are laid, to 2e-6 a channel (opacity included), between the two that are farthest
/// apart. No value if they do not lie on a line or are all equal. At least one row must lay paint. It is a pure
/// function of the colours in order.
std::optional<ColourLine> lineThrough(std::span<const NodeValues> rows);

} // namespace suffuse
