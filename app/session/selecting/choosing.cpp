#include "app/session/selecting/choosing.h"

#include "app/session/selecting/pick.h"
#include "undo/history/order_tree.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

/// How many strokes of a group, and of those within it, there are.
struct GroupCounts {
    int members = 0; ///< visible and unlocked
    int selected = 0, selectable = 0, found = 0;

    bool isPartlySelected() const { return selected > 0 && selected < members; }
};

} // namespace

Selection toggled(Selection selection, StrokeId clicked, const std::set<StrokeId> &strokes)
{
    const bool add = !selection.strokes.contains(clicked);
    for (const StrokeId id : strokes)
        if (add)
            selection.strokes.insert(id);
        else
            selection.strokes.erase(id);
    std::erase_if(selection.segments, [&](const SegmentRef &s) { return strokes.contains(s.stroke); });
    return selection;
}

Selection without(Selection selection, const std::set<StrokeId> &strokes)
{
    for (const StrokeId id : strokes)
        selection.strokes.erase(id);
    std::erase_if(selection.segments, [&](const SegmentRef &s) { return strokes.contains(s.stroke); });
    return selection;
}

std::size_t nextBelow(const std::vector<SegmentRef> &hits, const Selection &selection)
{
    std::size_t next = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (selection.strokes.contains(hits[i].stroke))
            next = (i + 1) % hits.size();
    return next;
}

std::set<StrokeId> withWholeGroups(const Painting &painting, Microseconds T, const std::set<StrokeId> &found,
                                   const std::set<StrokeId> &selected, GroupShare share, GroupId outer)
{
    std::unordered_map<GroupId, std::vector<GroupId>> around; // remembered, since there are many strokes and few groups
    std::unordered_map<GroupId, GroupCounts> counts;
    const Editable isMember(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (stroke->group == 0 || !isMember(*stroke))
            continue;
        const auto [at, isNew] = around.try_emplace(stroke->group);
        if (isNew) {
            at->second = groupsAround(painting, stroke->group);
            at->second.erase(std::ranges::find(at->second, outer), at->second.end());
        }
        for (const GroupId group : at->second) {
            GroupCounts &count = counts[group];
            ++count.members;
            count.selected += selected.contains(stroke->id);
            count.selectable += stroke->born() <= T;
            count.found += found.contains(stroke->id);
        }
    }
    std::set<StrokeId> meant;
    for (const StrokePtr &stroke : painting.strokes) {
        const GroupCounts *whole = nullptr;
        if (stroke->group != 0 && isMember(*stroke)) {
            const std::vector<GroupId> &groups = around[stroke->group];
            for (auto group = groups.rbegin(); group != groups.rend() && !whole; ++group)
                if (!counts[*group].isPartlySelected())
                    whole = &counts[*group];
        }
        const bool all = whole && whole->found == whole->selectable;
        if (whole ? whole->found > 0 && (all || share == GroupShare::Any) : found.contains(stroke->id))
            meant.insert(stroke->id);
    }
    return meant;
}

StrokeId nextStroke(const Painting &painting, Microseconds T, const Selection &selection, int step)
{
    std::vector<StrokeId> order;
    const Selectable isSelectable(painting, T);
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(*stroke))
            order.push_back(stroke->id);
    if (order.empty())
        return 0;
    const int count = int(order.size());
    int at = step > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (selection.strokes.contains(order[std::size_t(i)]) && (step > 0 || at == count))
            at = i;
    return order[std::size_t((at + step + count) % count)];
}

} // namespace suffuse
