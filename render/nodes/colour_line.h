// Colours along a stroke that lie on one line of colour space (a gradient between two colours) need one sum, not four.
#pragma once

#include "render/nodes/node_builder.h"

#include <optional>
#include <span>

namespace suffuse {

struct ColourLine {
    Colour from, to;

    /// Place of a colour on the line, 0 at `from`, 1 at `to`.
    float placeOf(const Colour &c) const;
};

/// The line through all colours that are laid, to 2e-6 a channel (opacity included), between the two that lie farthest
/// out; none where they do not lie on one or all are the same. At least one row lays paint. A pure function of the
/// colours in order.
std::optional<ColourLine> lineThrough(std::span<const NodeValues> rows);

} // namespace suffuse
