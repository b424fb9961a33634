#include "undo/layers/group_roles.h"

#include "undo/layers/group_edits.h"

#include <algorithm>

namespace suffuse {

bool hasRole(const Group &group, GroupRole role)
{
    switch (role) {
    case GroupRole::Clipped:
        return group.clips;
    case GroupRole::Mask:
        return group.mask;
    case GroupRole::Wash:
        return group.wash.has_value();
    case GroupRole::Draft:
        return group.draft;
    }
    return false;
}

GroupRoles::GroupRoles(const Painting &painting)
{
    m_facts[0].isEntered = true;
    for (const Group &group : painting.groups)
        m_facts[group.id].group = &group;
    Facts *in = nullptr;
    GroupId last = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        if (!in || stroke->group != last) {
            last = stroke->group;
            in = &m_facts[last];
            enter(*in);
        }
        ++in->things;
        in->hasBase = true;
        if (!in->lowest || (in->lowest->fill && !stroke->fill))
            noteLowest(*stroke);
    }
}

/// The groups around it are entered before it.
void GroupRoles::enter(Facts &facts)
{
    if (facts.isEntered)
        return;
    facts.isEntered = true;
    if (!facts.group)
        return;
    Facts &around = m_facts[facts.group->parent];
    enter(around);
    ++around.things;
    facts.isOverBase = around.hasBase;
    around.hasBase = around.hasBase || (!facts.group->clips && !facts.group->mask);
}

void GroupRoles::noteLowest(const Stroke &stroke)
{
    for (auto at = m_facts.find(stroke.group); at != m_facts.end() && at->second.group;
         at = m_facts.find(at->second.group->parent)) {
        const Stroke *&lowest = at->second.lowest;
        if (lowest && (!lowest->fill || stroke.fill))
            return; // The groups around this one have one as well.
        lowest = &stroke;
    }
}

const GroupRoles::Facts *GroupRoles::factsOf(GroupId group) const
{
    const auto at = m_facts.find(group);
    return at == m_facts.end() ? nullptr : &at->second;
}

bool GroupRoles::canHave(const Group &group, GroupRole role) const
{
    switch (role) {
    case GroupRole::Clipped: {
        const Facts *facts = factsOf(group.id);
        return facts && facts->isOverBase;
    }
    case GroupRole::Mask: {
        const Facts *around = factsOf(group.parent);
        return around && around->things > 1;
    }
    case GroupRole::Wash: {
        const Facts *around = factsOf(group.parent);
        for (std::size_t steps = 0; around && around->group && steps < m_facts.size(); ++steps) {
            if (around->group->wash)
                return false;
            around = factsOf(around->group->parent);
        }
        return true;
    }
    case GroupRole::Draft:
        return true;
    }
    return false;
}

GroupRoles::State GroupRoles::of(const std::vector<GroupId> &groups, GroupRole role) const
{
    State state;
    for (const GroupId id : groups) {
        const Facts *facts = factsOf(id);
        if (!facts || !facts->group)
            continue;
        const bool has = hasRole(*facts->group, role);
        state.having += has;
        if (has || canHave(*facts->group, role))
            state.possible.push_back(id);
    }
    return state;
}

Wash GroupRoles::usualWash(GroupId group) const
{
    const Facts *facts = factsOf(group);
    return facts && facts->lowest ? Wash{facts->lowest->style, facts->lowest->mix} : Wash();
}

Edit setGroupRole(const Document &document, const std::vector<GroupId> &groups, GroupRole role, bool on)
{
    const Painting &painting = *document.painting();
    const GroupRoles roles(painting);
    return changeBlending(document, painting, roles.of(groups, role).possible, [&](Group &now, const Group &) {
        switch (role) {
        case GroupRole::Clipped:
            now.clips = on;
            break;
        case GroupRole::Mask:
            now.mask = on;
            break;
        case GroupRole::Wash:
            if (!on)
                now.wash.reset();
            else if (!now.wash)
                now.wash = roles.usualWash(now.id);
            break;
        case GroupRole::Draft:
            now.draft = on;
        }
    });
}

Edit setGroupTag(const Document &document, const std::vector<GroupId> &groups, GroupTag tag)
{
    return changeBlending(document, *document.painting(), groups, [tag](Group &now, const Group &) { now.tag = tag; });
}

} // namespace suffuse
