#include "app/session/selecting/choosing.h"

#include "app/session/selecting/pick.h"

namespace suffuse {

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

StrokeId nextStroke(const Painting &painting, Microseconds T, const Selection &selection, int step)
{
    std::vector<StrokeId> order;
    for (const StrokePtr &stroke : painting.strokes)
        if (isSelectable(painting, T, *stroke))
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
