#include "model/painting/editable.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

Locks::Locks(const std::vector<Group> &groups)
{
    if (std::ranges::none_of(groups, &Group::locked))
        return;
    std::unordered_map<GroupId, const Group *> known;
    for (const Group &group : groups)
        known.emplace(group.id, &group);
    for (const Group &group : groups) {
        const Group *around = &group;
        // The search ends on damaged chains, too.
        for (std::size_t steps = 0; around && !around->locked && steps <= groups.size(); ++steps) {
            const auto parent = known.find(around->parent);
            around = parent == known.end() ? nullptr : parent->second;
        }
        if (around && around->locked)
            m_locked.insert(group.id);
    }
}

} // namespace suffuse
