// Rows of the Strokes dock that are dragged to another place in it.
#pragma once

#include "app/panels/strokes/strokes_tree.h"
#include "model/document/edit.h"

#include <QByteArray>

namespace suffuse {

/// What is dragged. Groups move with what is in them; single strokes join the group that they are dropped into.
struct DraggedRows {
    std::set<StrokeId> strokes; ///< all strokes, including those in the groups
    std::set<GroupId> groups;

    /// Makes bytes that also name the model which the rows come from.
    QByteArray toBytes(const void *source) const;
    /// Reads such bytes. Returns nothing if the rows come from another model.
    static std::optional<DraggedRows> fromBytes(const QByteArray &bytes, const void *source);

    /// The rows that can be moved: without strokes that no longer exist, and without locked ones that are dragged by
    /// themselves.
    DraggedRows movable(const StrokesTree &tree) const;
};

/// A place where rows are dropped.
struct DropPlace {
    GroupId group = 0;   ///< 0 if the place is in no group
    StrokeId before = 0; ///< The stroke below which the rows go in the order of painting; 0 if they go on top of all.
};

/// The place of the gap above row `row` below `target`, or of `target` itself where the number is negative.
DropPlace dropPlace(const StrokesTree::Node &target, int row, const std::set<StrokeId> &moved);

/// The edit that puts the rows there. There is none if a group would go into itself.
std::optional<Edit> dropEdit(const StrokesTree &tree, const Painting &painting, const DraggedRows &rows,
                             const DropPlace &place);

} // namespace suffuse
