#include "app/canvas/reading/stroke_tree.h"

#include <utility>

namespace suffuse {

StrokeTree::StrokeTree(PaintingPtr painting) : m_painting(std::move(painting))
{
    m_strokes.reserve(m_painting->strokes.size());
    for (const StrokePtr &stroke : m_painting->strokes) {
        if (stroke->group != 0)
            addGroup(stroke->group);
        add({stroke->id, 0}, stroke->group);
    }
}

/// Adds a group, and those around it first, unless they are there: its lowest stroke decides about its place.
void StrokeTree::addGroup(GroupId group)
{
    if (m_groups.contains(group))
        return;
    const Group *found = m_painting->findGroup(group);
    const GroupId parent = found ? found->parent : 0;
    if (parent != 0)
        addGroup(parent);
    add({0, group}, parent);
}

void StrokeTree::add(const TreeItem &item, GroupId parent)
{
    std::vector<TreeItem> &siblings = m_children[parent];
    const Place place{parent, int(siblings.size())};
    siblings.push_back(item);
    if (item.group != 0)
        m_groups.emplace(item.group, place);
    else
        m_strokes.emplace(item.stroke, place);
}

const std::vector<TreeItem> &StrokeTree::in(GroupId group) const
{
    static const std::vector<TreeItem> none;
    const auto found = m_children.find(group);
    return found == m_children.end() ? none : found->second;
}

const StrokeTree::Place *StrokeTree::find(const TreeItem &item) const
{
    if (item.group != 0) {
        const auto group = m_groups.find(item.group);
        return group == m_groups.end() ? nullptr : &group->second;
    }
    const auto stroke = m_strokes.find(item.stroke);
    return stroke == m_strokes.end() ? nullptr : &stroke->second;
}

bool StrokeTree::contains(const TreeItem &item) const
{
    return find(item);
}

GroupId StrokeTree::parentOf(const TreeItem &item) const
{
    const Place *place = find(item);
    return place ? place->parent : 0;
}

int StrokeTree::placeOf(const TreeItem &item) const
{
    const Place *place = find(item);
    return place ? place->index : -1;
}

} // namespace suffuse
