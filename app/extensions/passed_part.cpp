#include "app/extensions/passed_part.h"

#include "model/painting/validate.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace suffuse {

namespace {

/// Whether a group is another one or within it.
bool isWithin(const Painting &painting, GroupId group, GroupId around)
{
    while (group != 0 && group != around) {
        const Group *g = painting.findGroup(group);
        group = g ? g->parent : 0;
    }
    return group == around;
}

bool sameUnderlay(const Painting &a, const Painting &b)
{
    return bool(a.underlay) == bool(b.underlay) && (!a.underlay || *a.underlay == *b.underlay);
}

using Ids = std::unordered_set<StrokeId>;

Ids idsOf(const Painting &painting)
{
    Ids ids;
    for (const StrokePtr &stroke : painting.strokes)
        ids.insert(stroke->id);
    return ids;
}

/// The strokes of a result, with ids that no stroke of the rest has.
std::vector<StrokePtr> withFreeIds(const Painting &whole, const std::set<StrokeId> &passed, const Painting &result)
{
    const Ids taken = idsOf(whole);
    StrokeId next = std::max(whole.nextStrokeId(), result.nextStrokeId());
    std::vector<StrokePtr> strokes;
    for (const StrokePtr &stroke : result.strokes) {
        if (passed.contains(stroke->id) || !taken.contains(stroke->id)) {
            strokes.push_back(stroke);
            continue;
        }
        auto renamed = std::make_shared<Stroke>(*stroke);
        renamed->id = next++;
        strokes.push_back(std::move(renamed));
    }
    return strokes;
}

} // namespace

std::set<StrokeId> passedStrokes(const Painting &whole, Extension::Passes passes, const std::set<StrokeId> &selected,
                                 GroupId layer)
{
    std::set<StrokeId> strokes;
    const Visibility isVisible(whole.groups);
    for (const StrokePtr &stroke : whole.strokes) {
        bool isPassed = true;
        if (passes == Extension::Passes::Selection)
            isPassed = selected.contains(stroke->id);
        else if (passes == Extension::Passes::Layer)
            isPassed = layer == 0 || isWithin(whole, stroke->group, layer);
        if (isPassed && passes != Extension::Passes::Painting)
            isPassed = isVisible(*stroke) && !whole.isLocked(*stroke);
        if (isPassed)
            strokes.insert(stroke->id);
    }
    return strokes;
}

Painting partOf(const Painting &whole, const std::set<StrokeId> &strokes)
{
    Painting part = whole;
    part.strokes.clear();
    for (const StrokePtr &stroke : whole.strokes)
        if (strokes.contains(stroke->id))
            part.strokes.push_back(stroke);
    return part;
}

Result<Painting> withPart(const Painting &whole, const std::set<StrokeId> &passed, Painting result)
{
    if (passed.size() == whole.strokes.size())
        return result;
    if (result.canvas != whole.canvas || result.swatches != whole.swatches || !sameUnderlay(result, whole))
        return Error{
            ExtensionMessages::tr("a part of the painting was passed, so canvas, palette and underlay must stay "
                                  "as they are")};
    const std::vector<StrokePtr> strokes = withFreeIds(whole, passed, result);
    // The strokes that stay take the places that they had, in the order that they have now. New ones follow them.
    std::size_t at = 0;
    StrokeList merged;
    const Ids stays = idsOf(result);
    const auto addNew = [&] {
        while (at < strokes.size() && !passed.contains(strokes[at]->id))
            merged.push_back(strokes[at++]);
    };
    bool isBegun = false;
    for (const StrokePtr &stroke : whole.strokes) {
        if (!passed.contains(stroke->id)) {
            merged.push_back(stroke);
            continue;
        }
        if (!std::exchange(isBegun, true))
            addNew();
        if (stays.contains(stroke->id) && at < strokes.size())
            merged.push_back(strokes[at++]);
        addNew();
    }
    addNew();
    Painting painting = std::move(result);
    painting.strokes = std::move(merged);
    if (const QString problem = problemOf(painting); !problem.isEmpty())
        return Error{problem};
    return painting;
}

} // namespace suffuse
