// The order of strokes as a tree of groups.
#pragma once

#include "model/painting/painting.h"

#include <functional>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

/// A group with its members, or one stroke. Siblings are in order from bottom to top.
struct Sibling {
    GroupId group = 0; ///< 0 if it is a stroke
    StrokeId stroke = 0;
    std::vector<Sibling> members;
    bool selected = false; ///< whether the stroke, or all members, are selected
    Rect influence;        ///< the influence of what is visible, once it is computed
};

/// The tree of a painting. Locked strokes do not count as selected.
std::vector<Sibling> orderTree(const Painting &painting, const std::set<StrokeId> &selected);
/// The selected siblings that are in no selected group.
std::vector<const Sibling *> selectedUnits(const std::vector<Sibling> &siblings);
/// Visits the strokes of a sibling: itself, or its members.
void forEachStroke(const Sibling &sibling, const std::function<void(StrokeId)> &visit);

/// The siblings among which a group is, and its number among them; none where there is no such group, or it is empty.
std::vector<Sibling> *siblingsOf(std::vector<Sibling> &tree, GroupId group, std::size_t &number);

/// The order of the strokes in a tree, from bottom to top.
std::vector<StrokeId> orderOf(const std::vector<Sibling> &siblings);

/// The group with this id and the groups around it, from the inside out; none for the id 0.
std::vector<GroupId> groupsAround(const Painting &painting, GroupId id);
/// The group that this group is in and that is in no other.
GroupId outermostGroup(const Painting &painting, GroupId id);

/// The groups, and all groups within them.
std::unordered_set<GroupId> withGroupsWithin(const std::vector<Group> &groups, const std::set<GroupId> &outer);

/// Tells strokes of a group, and of those within it; in 0 are all. Most often neighbours are of one group, of which it
/// is asked once.
class WithinGroup {
public:
    WithinGroup(const Painting &painting, GroupId outer) : m_painting(painting), m_outer(outer), m_is(outer == 0) {}

    bool operator()(const Stroke &stroke);

private:
    const Painting &m_painting;
    GroupId m_outer, m_asked = 0;
    bool m_is;
};

} // namespace suffuse
