#include "undo/layers/emptied_groups.h"

#include "undo/history/order_tree.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The groups that a stroke leaves by the edit, with those around them.
std::set<GroupId> groupsLeft(const Painting &painting, const Edit &edit)
{
    std::set<GroupId> left;
    std::size_t found = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = edit.strokes.find(stroke->id);
        if (it == edit.strokes.end())
            continue;
        if (stroke->group != 0 && (!it->second || it->second->group != stroke->group))
            left.insert(stroke->group);
        if (++found == edit.strokes.size())
            break;
    }
    std::set<GroupId> all;
    for (const GroupId id : left)
        for (const GroupId around : groupsAround(painting, id))
            if (!all.insert(around).second)
                break;
    return all;
}

} // namespace

std::vector<GroupId> takeEmptied(const Painting &painting, Edit &edit)
{
    if (painting.groups.empty() || edit.strokes.empty())
        return {};
    std::set<GroupId> emptied = groupsLeft(painting, edit);
    if (emptied.empty())
        return {};
    std::unordered_map<GroupId, GroupId> parents;
    for (const Group &group : edit.groups ? *edit.groups : painting.groups)
        parents.emplace(group.id, group.parent);
    std::erase_if(emptied, [&](GroupId id) { return !parents.contains(id); });
    const auto keep = [&](GroupId id) {
        for (; id != 0 && !emptied.empty(); id = parents.contains(id) ? parents.at(id) : 0)
            emptied.erase(id);
    };
    for (const auto &[id, stroke] : edit.strokes)
        if (stroke)
            keep(stroke->group);
    for (auto it = painting.strokes.begin(); it != painting.strokes.end() && !emptied.empty(); ++it)
        if ((*it)->group != 0 && !edit.strokes.contains((*it)->id))
            keep((*it)->group);
    if (emptied.empty())
        return {};
    if (!edit.groups)
        edit.groups = painting.groups;
    const std::unordered_set<GroupId> within = withGroupsWithin(*edit.groups, emptied);
    std::erase_if(*edit.groups, [&](const Group &group) { return within.contains(group.id); });
    return {within.begin(), within.end()};
}

bool isEmptyGroup(const Painting &painting, GroupId group)
{
    return painting.findGroup(group) &&
           std::ranges::none_of(painting.strokes, [within = WithinGroup(painting, group)](const StrokePtr &s) mutable {
               return within(*s);
           });
}

Edit deleteEmptyGroup(const Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    if (!isEmptyGroup(painting, group))
        return {};
    Edit edit;
    edit.groups = painting.groups;
    const std::unordered_set<GroupId> within = withGroupsWithin(painting.groups, {group});
    std::erase_if(*edit.groups, [&](const Group &g) { return within.contains(g.id); });
    return edit;
}

} // namespace suffuse
