// If the colours along a stroke lie on one line of colour space (a gradient between two colours), they need one sum
// instead of four.
#pragma once

#include "render/nodes/node_builder.h"

#include <optional>
#include <span>

namespace suffuse {

struct ColourLine {
    Colour from, to;

    /// Returns the place of a colour on the line, which is 0 at `from` and 1 at `to`.
    float placeOf(const Colour &c) const;
};

/// Finds the line on which all colours that are laid lie, to 2e-6 in each channel (opacity is one of them). It ends at
/// the two colours that are farthest apart. Returns no value if they do not lie on a line or are all equal. At least
/// one row must lay paint. The result is a pure function of the colours in order.
std::optional<ColourLine> lineThrough(std::span<const NodeValues> rows);

} // namespace suffuse
