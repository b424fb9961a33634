#include "undo/history/order_tree.h"

#include "model/painting/editable.h"

#include <algorithm>

namespace suffuse {

namespace {

using Parents = std::unordered_map<GroupId, GroupId>;

/// The members of a group, which is put on top of its siblings if it is not there yet.
std::vector<Sibling> &membersOf(GroupId id, const Parents &parents, std::vector<Sibling> &roots)
{
    const auto it = parents.find(id);
    if (it == parents.end())
        return roots;
    std::vector<Sibling> &around = membersOf(it->second, parents, roots);
    if (around.empty() || around.back().group != id) {
        around.emplace_back();
        around.back().group = id;
    }
    return around.back().members;
}

void selectWholeGroups(std::vector<Sibling> &siblings)
{
    for (Sibling &s : siblings) {
        if (s.group == 0)
            continue;
        selectWholeGroups(s.members);
        s.selected = std::all_of(s.members.begin(), s.members.end(), [](const Sibling &m) { return m.selected; });
    }
}

void appendUnits(const std::vector<Sibling> &siblings, std::vector<const Sibling *> &units)
{
    for (const Sibling &s : siblings) {
        if (s.selected)
            units.push_back(&s);
        else
            appendUnits(s.members, units);
    }
}

} // namespace

std::vector<Sibling> orderTree(const Painting &painting, const std::set<StrokeId> &selected)
{
    Parents parents;
    for (const Group &g : painting.groups)
        parents.emplace(g.id, g.parent);
    std::vector<Sibling> roots;
    const Locks isLocked(painting.groups);
    for (const StrokePtr &s : painting.strokes) {
        Sibling leaf;
        leaf.stroke = s->id;
        leaf.selected = selected.contains(s->id) && !isLocked(*s);
        membersOf(s->group, parents, roots).push_back(std::move(leaf));
    }
    selectWholeGroups(roots);
    return roots;
}

std::vector<const Sibling *> selectedUnits(const std::vector<Sibling> &siblings)
{
    std::vector<const Sibling *> units;
    appendUnits(siblings, units);
    return units;
}

void forEachStroke(const Sibling &sibling, const std::function<void(StrokeId)> &visit)
{
    if (sibling.group == 0)
        visit(sibling.stroke);
    for (const Sibling &member : sibling.members)
        forEachStroke(member, visit);
}

std::vector<StrokeId> orderOf(const std::vector<Sibling> &siblings)
{
    std::vector<StrokeId> order;
    for (const Sibling &s : siblings)
        forEachStroke(s, [&order](StrokeId id) { order.push_back(id); });
    return order;
}

std::vector<Sibling> *siblingsOf(std::vector<Sibling> &tree, GroupId group, std::size_t &number)
{
    for (std::size_t i = 0; i < tree.size(); ++i) {
        number = i;
        if (tree[i].group == group)
            return &tree;
        if (tree[i].group != 0)
            if (std::vector<Sibling> *found = siblingsOf(tree[i].members, group, number))
                return found;
    }
    return nullptr;
}

std::vector<GroupId> groupsAround(const Painting &painting, GroupId id)
{
    std::vector<GroupId> chain;
    while (id != 0 && chain.size() <= painting.groups.size()) {
        chain.push_back(id);
        const Group *group = painting.findGroup(id);
        id = group ? group->parent : 0;
    }
    return chain;
}

GroupId outermostGroup(const Painting &painting, GroupId id)
{
    for (std::size_t steps = 0; steps < painting.groups.size(); ++steps) {
        const Group *group = painting.findGroup(id);
        if (!group || group->parent == 0)
            return id;
        id = group->parent;
    }
    return id;
}

std::unordered_set<GroupId> withGroupsWithin(const std::vector<Group> &groups, const std::set<GroupId> &outer)
{
    std::unordered_multimap<GroupId, GroupId> within;
    for (const Group &group : groups)
        if (group.parent != 0)
            within.emplace(group.parent, group.id);
    std::unordered_set<GroupId> found(outer.begin(), outer.end());
    for (std::vector<GroupId> open(outer.begin(), outer.end()); !open.empty();) {
        const auto [first, last] = within.equal_range(open.back());
        open.pop_back();
        for (auto at = first; at != last; ++at)
            if (found.insert(at->second).second)
                open.push_back(at->second);
    }
    return found;
}

bool WithinGroup::operator()(const Stroke &stroke)
{
    if (stroke.group != m_asked && m_outer != 0) {
        m_asked = stroke.group;
        const std::vector<GroupId> around = groupsAround(m_painting, m_asked);
        m_is = std::ranges::find(around, m_outer) != around.end();
    }
    return m_is;
}

} // namespace suffuse
