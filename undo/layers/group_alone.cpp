#include "undo/layers/group_alone.h"

#include "undo/history/order_tree.h"

namespace suffuse {

Painting groupAlone(const Painting &painting, GroupId group)
{
    Painting alone;
    alone.canvas = painting.canvas;
    const std::unordered_set<GroupId> within = withGroupsWithin(painting.groups, {group});
    for (const Group &original : painting.groups) {
        if (!within.contains(original.id))
            continue;
        Group &copy = alone.groups.emplace_back(original);
        copy.solo = false;
        if (original.id != group)
            continue;
        copy.parent = 0;
        copy.visible = true, copy.locked = false;
        copy.opacity = 1, copy.blend = BlendMode::Normal;
        copy.clips = copy.mask = false;
    }
    if (alone.groups.empty())
        return alone;
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->group != 0 && within.contains(stroke->group))
            alone.strokes.push_back(stroke);
    return alone;
}

} // namespace suffuse
