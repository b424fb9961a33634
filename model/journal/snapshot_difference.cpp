#include "model/journal/journal_format.h"

#include <unordered_map>

namespace suffuse {

namespace {

std::vector<StrokeId> orderOf(const StrokeList &strokes)
{
    std::vector<StrokeId> ids;
    ids.reserve(strokes.size());
    for (const StrokePtr &stroke : strokes)
        ids.push_back(stroke->id);
    return ids;
}

/// Finds strokes that have other states. Returns false if strokes were added, removed or moved.
bool onlyAltered(const StrokeList &before, const StrokeList &after, std::vector<StrokePtr> &altered)
{
    if (before.size() != after.size())
        return false;
    bool only = true;
    after.forEachDifference(before, [&](std::size_t i) {
        only = only && after[i]->id == before[i]->id;
        if (only)
            altered.push_back(after[i]);
    });
    return only;
}

/// In the usual case, when a stroke was painted on top, no other stroke's id is looked at.
bool onlyAppended(const StrokeList &before, const StrokeList &after, SnapshotDifference &difference)
{
    if (before.size() >= after.size() || !std::equal(before.begin(), before.end(), after.begin()))
        return false;
    for (std::size_t i = before.size(); i < after.size(); ++i) {
        difference.strokes.push_back(after[i]);
        difference.places.push_back({std::uint32_t(i), after[i]->id});
    }
    return true;
}

} // namespace

SnapshotDifference snapshotDifference(const Painting &before, const Painting &after)
{
    SnapshotDifference difference;
    difference.rest = before.canvas != after.canvas || before.groups != after.groups ||
                      before.swatches != after.swatches || before.underlay != after.underlay;
    if (onlyAltered(before.strokes, after.strokes, difference.strokes))
        return difference;
    difference.strokes.clear();
    if (onlyAppended(before.strokes, after.strokes, difference))
        return difference;
    std::unordered_map<StrokeId, const Stroke *> old;
    old.reserve(before.strokes.size());
    for (const StrokePtr &stroke : before.strokes)
        old.emplace(stroke->id, stroke.get());
    for (const StrokePtr &stroke : after.strokes) {
        const auto it = old.find(stroke->id);
        if (it == old.end() || it->second != stroke.get())
            difference.strokes.push_back(stroke);
        if (it != old.end())
            old.erase(it);
    }
    for (const StrokePtr &stroke : before.strokes)
        if (old.contains(stroke->id))
            difference.removed.push_back(stroke->id);
    difference.places = orderDifference(orderOf(before.strokes), orderOf(after.strokes));
    return difference;
}

} // namespace suffuse
