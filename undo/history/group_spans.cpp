#include "undo/history/group_spans.h"

namespace suffuse {

GroupSpan spanOf(const Painting &painting, GroupId group)
{
    if (group == 0)
        return {0, painting.strokes.size()};
    const std::unordered_set<GroupId> within = withGroupsWithin(painting.groups, {group});
    GroupSpan span;
    for (std::size_t i = 0; i < painting.strokes.size(); ++i) {
        if (!within.contains(painting.strokes[i]->group))
            continue;
        if (span.isEmpty())
            span.begin = i;
        span.end = i + 1;
    }
    return span;
}

GroupId memberAround(const Painting &painting, GroupId outer, const Stroke &stroke)
{
    GroupId member = 0;
    for (const GroupId group : groupsAround(painting, stroke.group)) {
        if (group == outer)
            break;
        member = group;
    }
    return member;
}

} // namespace suffuse
