#include "model/document/difference.h"

#include "model/document/order_difference.h"

#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

bool sameUnderlay(const std::shared_ptr<const Underlay> &a, const std::shared_ptr<const Underlay> &b)
{
    return a == b || (a && b && *a == *b);
}

/// Returns true if the same strokes stand in the same order. Those that have other values are added to `changed`.
bool onlyValuesDiffer(const Painting &before, const Painting &after, std::vector<StrokeId> &changed)
{
    if (before.strokes.size() != after.strokes.size())
        return false;
    bool same = true;
    before.strokes.forEachDifference(after.strokes, [&](std::size_t i) {
        const Stroke &a = *before.strokes[i], &b = *after.strokes[i];
        same = same && a.id == b.id;
        if (same && !(a == b))
            changed.push_back(b.id);
    });
    return same;
}

void compareStrokes(const Painting &before, const Painting &after, PaintingDifference &out)
{
    std::unordered_map<StrokeId, StrokePtr> old;
    for (const StrokePtr &stroke : before.strokes)
        old.emplace(stroke->id, stroke);
    std::unordered_set<StrokeId> common;
    std::vector<StrokeId> orderBefore, orderAfter;
    for (const StrokePtr &stroke : after.strokes) {
        const auto it = old.find(stroke->id);
        if (it == old.end()) {
            out.added.push_back(stroke->id);
            continue;
        }
        common.insert(stroke->id);
        orderAfter.push_back(stroke->id);
        if (it->second != stroke && !(*it->second == *stroke))
            out.changed.push_back(stroke->id);
    }
    for (const StrokePtr &stroke : before.strokes)
        (common.count(stroke->id) ? orderBefore : out.removed).push_back(stroke->id);
    for (const StrokePlace &place : orderDifference(orderBefore, orderAfter))
        out.moved.push_back(place.stroke);
}

} // namespace

PaintingDifference differenceOf(const Painting &before, const Painting &after)
{
    PaintingDifference out;
    out.canvas = !(before.canvas == after.canvas);
    out.groups = before.groups != after.groups;
    out.swatches = before.swatches != after.swatches;
    out.underlay = !sameUnderlay(before.underlay, after.underlay);
    if (onlyValuesDiffer(before, after, out.changed))
        return out;
    out.changed.clear();
    compareStrokes(before, after, out);
    return out;
}

} // namespace suffuse
