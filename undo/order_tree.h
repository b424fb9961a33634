// The order of strokes as a tree of groups.
#pragma once

#include "model/painting/painting.h"

#include <functional>
#include <set>
#include <unordered_map>

namespace suffuse {

/// A group with its members, or one stroke. Siblings stand from bottom to top.
struct Sibling {
    GroupId group = 0; ///< 0: a stroke
    StrokeId stroke = 0;
    std::vector<Sibling> members;
    bool selected = false; ///< the stroke, or all members
    Rect influence;        ///< of what is visible, once it is filled in
};

/// Locked strokes do not count as selected.
std::vector<Sibling> orderTree(const Painting &painting, const std::set<StrokeId> &selected);
/// The selected siblings that lie in no selected group.
std::vector<const Sibling *> selectedUnits(const std::vector<Sibling> &siblings);
/// The strokes of a sibling, itself or its members.
void forEachStroke(const Sibling &sibling, const std::function<void(StrokeId)> &visit);

std::vector<StrokeId> orderOf(const std::vector<Sibling> &siblings);

/// This group and those around it, from the inside out; none of 0.
std::vector<GroupId> groupsAround(const Painting &painting, GroupId id);
/// The group that holds this one and lies in no other.
GroupId outermostGroup(const Painting &painting, GroupId id);

} // namespace suffuse
