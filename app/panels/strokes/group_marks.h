// What the rows of groups say about the strokes in them.
#pragma once

#include "app/panels/strokes/strokes_tree.h"

namespace suffuse {

/// How many of the strokes in a group have a mark.
enum class Share { None, Some, All };

/// How much of a group is hidden, and how much is locked, by strokes and groups within it. The group's own switches do
/// not count.
struct GroupMarks {
    Share hidden = Share::None;
    Share locked = Share::None;
    friend bool operator==(const GroupMarks &, const GroupMarks &) = default;
};

using MarksOfGroups = std::unordered_map<GroupId, GroupMarks>;

/// The marks of all groups of a tree, from one pass over its rows. A group without strokes has no marks.
MarksOfGroups marksOf(const StrokesTree &tree);

} // namespace suffuse
