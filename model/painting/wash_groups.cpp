#include "model/painting/wash_groups.h"

#include <algorithm>

namespace suffuse {

std::unordered_map<GroupId, const Group *> washesOf(const Painting &painting)
{
    std::unordered_map<GroupId, const Group *> washes;
    if (std::ranges::none_of(painting.groups, [](const Group &group) { return group.wash.has_value(); }))
        return washes;
    for (const Group &group : painting.groups) {
        const Group *wash = nullptr, *around = &group;
        bool isMasked = false, isWithinMask = false; // whether a mask lies within the wash, or within what comes next
        for (std::size_t steps = 0; around && steps <= painting.groups.size(); ++steps) {
            if (around->wash)
                wash = around, isMasked = isWithinMask;
            isWithinMask = isWithinMask || around->mask;
            around = painting.findGroup(around->parent);
        }
        if (wash && !isMasked)
            washes.emplace(group.id, wash);
    }
    return washes;
}

} // namespace suffuse
