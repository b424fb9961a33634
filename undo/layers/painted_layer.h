// The layer that is painted on: what it is where it is not there, and what takes its place where it goes.
#pragma once

#include "model/painting/painting.h"

#include <optional>

namespace suffuse {

/// A place in the order, by the strokes that were next to it; 0: there was none.
struct OrderPlace {
    StrokeId over = 0, under = 0;
};

/// A group that new strokes go into.
struct PaintedLayer {
    GroupId group = 0; ///< 0: none, so that they go on top of all
    /// What the group is made as, with the first stroke that goes into it, where the painting does not have it: a group
    /// without strokes would have no place in the order.
    std::optional<Group> coming;
    GroupId above = 0; ///< the group above which it comes then; 0: it comes on top of what is in its parent
    std::optional<OrderPlace> place{}; ///< where it comes in any case, since it was there when it lost its last stroke
};

/// A layer that is there, as it will come again when it has lost its last stroke and has gone with other groups.
PaintedLayer emptiedLayer(const Painting &painting, GroupId layer, const std::vector<GroupId> &gone);
/// The index in the order where a layer comes that is not there, within its parent. A parent without strokes has none.
std::optional<std::size_t> comingIndex(const Painting &painting, const PaintedLayer &layer);
/// What is painted on next where a layer was deleted: the layer below it, else the one above it, else the group around
/// it; 0: none.
GroupId layerBeside(const Painting &before, GroupId layer, const Painting &after);

} // namespace suffuse
