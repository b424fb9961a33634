// Where groups lie in the order of strokes.
#pragma once

#include "undo/history/order_tree.h"

namespace suffuse {

/// The places in the order from the lowest stroke of a group to behind its topmost one.
struct GroupSpan {
    std::size_t begin = 0, end = 0;
    bool isEmpty() const { return begin == end; }
};

/// Of 0 it is the span of all strokes.
GroupSpan spanOf(const Painting &painting, GroupId group);
/// The group just within `outer` that is around a stroke; 0 if the stroke is in `outer` itself.
GroupId memberAround(const Painting &painting, GroupId outer, const Stroke &stroke);

} // namespace suffuse
