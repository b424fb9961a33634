// Rows of the strokes dock that are dragged to another place in it.
#pragma once

#include "app/panels/strokes/strokes_tree.h"
#include "model/document/edit.h"

#include <QByteArray>

namespace suffuse {

/// Groups move with what is in them; single strokes join the group that they are dropped into.
struct DraggedRows {
    std::set<StrokeId> strokes; ///< all, also those in the groups
    std::set<GroupId> groups;

    /// As bytes, with the model that they come from.
    QByteArray toBytes(const void *source) const;
    /// None if they come from another model.
    static std::optional<DraggedRows> fromBytes(const QByteArray &bytes, const void *source);

    /// Without strokes that are gone, or locked where they are dragged by themselves.
    DraggedRows movable(const StrokesTree &tree) const;
};

/// Where rows are dropped.
struct DropPlace {
    GroupId group = 0;   ///< 0: in none
    StrokeId before = 0; ///< the stroke below which they go in the order of painting; 0: on top of all
};

/// Of the gap above the row with the number `row` below `target`, or of `target` itself where that is negative.
DropPlace dropPlace(const StrokesTree::Node &target, int row, const std::set<StrokeId> &moved);

/// Puts the rows there; none: a group cannot go into itself.
std::optional<Edit> dropEdit(const StrokesTree &tree, const Painting &painting, const DraggedRows &rows,
                             const DropPlace &place);

} // namespace suffuse
