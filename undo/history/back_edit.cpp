#include "undo/history/back_edit.h"

#include <algorithm>
#include <unordered_set>

namespace suffuse {

namespace {

bool sameStroke(const StrokePtr &a, const StrokePtr &b)
{
    return a == b || (a && b && *a == *b);
}

/// Whether one map has all strokes of the other. Both are in order, so the usual case, a drag of the same strokes,
/// takes one pass.
bool holdsAllOf(const std::map<StrokeId, StrokePtr> &older, const std::map<StrokeId, StrokePtr> &newer)
{
    return std::includes(older.begin(), older.end(), newer.begin(), newer.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
}

/// Keeps the older one of two states of a part.
template <typename T>
void keepOldest(std::optional<T> &older, std::optional<T> &newer)
{
    if (!older)
        older = std::move(newer);
}

} // namespace

bool changesNothing(const Edit &back, const Painting &painting)
{
    if (back.places && !back.places->empty())
        return false;
    if (back.canvas && *back.canvas != painting.canvas)
        return false;
    if (back.groups && *back.groups != painting.groups)
        return false;
    if (back.swatches && *back.swatches != painting.swatches)
        return false;
    if (back.underlay) {
        const Underlay *a = back.underlay->get(), *b = painting.underlay.get();
        if (a != b && (!a || !b || !(*a == *b)))
            return false;
    }
    if (back.strokes.empty())
        return true;
    std::size_t found = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = back.strokes.find(stroke->id);
        if (it == back.strokes.end())
            continue;
        if (!sameStroke(it->second, stroke))
            return false; // Where many strokes are dragged, this is known soon.
        ++found;
    }
    const auto comes = [](const auto &entry) { return bool(entry.second); };
    return std::size_t(std::count_if(back.strokes.begin(), back.strokes.end(), comes)) == found;
}

void extendBack(Edit &back, Edit newer, const Painting &now)
{
    if (newer.places) {
        const std::vector<StrokeId> order = orderOf(now);
        back.places = orderDifference(order, orderWanted(back, orderWanted(newer, order)));
    }
    if (!holdsAllOf(back.strokes, newer.strokes))
        back.strokes.merge(newer.strokes);
    if (newer.places) { // What was added in between and is gone again is in neither painting.
        std::unordered_set<StrokeId> gone;
        for (const auto &[id, stroke] : back.strokes)
            if (!stroke)
                gone.insert(id);
        for (auto at = now.strokes.begin(); at != now.strokes.end() && !gone.empty(); ++at)
            gone.erase((*at)->id);
        for (const StrokeId id : gone)
            back.strokes.erase(id);
    }
    keepOldest(back.canvas, newer.canvas);
    keepOldest(back.groups, newer.groups);
    keepOldest(back.swatches, newer.swatches);
    keepOldest(back.underlay, newer.underlay);
    keepOldest(back.selection, newer.selection);
}

} // namespace suffuse
