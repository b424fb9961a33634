#include "undo/layers/painted_layer.h"

#include "undo/history/group_spans.h"
#include "undo/layers/layer_edits.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The places of what stands in a group around a stroke: the stroke itself, or the member that it is in. None where the
/// stroke is not in the group.
std::optional<GroupSpan> memberSpan(const Painting &painting, GroupId group, StrokeId stroke)
{
    const int index = painting.indexOf(stroke);
    if (index < 0 || !WithinGroup(painting, group)(*painting.strokes[std::size_t(index)]))
        return {};
    const GroupId member = memberAround(painting, group, *painting.strokes[std::size_t(index)]);
    return member ? spanOf(painting, member) : GroupSpan{std::size_t(index), std::size_t(index) + 1};
}

} // namespace

PaintedLayer emptiedLayer(const Painting &painting, GroupId layer, const std::vector<GroupId> &gone)
{
    PaintedLayer emptied{layer, *painting.findGroup(layer), 0};
    GroupId &parent = emptied.coming->parent;
    while (std::ranges::find(gone, parent) != gone.end())
        parent = painting.findGroup(parent)->parent;
    const GroupSpan span = spanOf(painting, layer);
    emptied.place.emplace();
    if (span.begin > 0)
        emptied.place->over = painting.strokes[span.begin - 1]->id;
    if (span.end < painting.strokes.size())
        emptied.place->under = painting.strokes[span.end]->id;
    return emptied;
}

std::optional<std::size_t> comingIndex(const Painting &painting, const PaintedLayer &layer)
{
    const GroupId parent = layer.coming->parent;
    const GroupSpan around = spanOf(painting, parent);
    if (around.isEmpty())
        return parent == 0 ? std::optional<std::size_t>(0) : std::nullopt;
    if (!layer.place) {
        const GroupSpan past = layer.above ? spanOf(painting, layer.above) : GroupSpan();
        return past.isEmpty() ? around.end : past.end;
    }
    if (const std::optional<GroupSpan> over = memberSpan(painting, parent, layer.place->over))
        return over->end;
    if (const std::optional<GroupSpan> under = memberSpan(painting, parent, layer.place->under))
        return under->begin;
    return layer.place->under == 0 || painting.indexOf(layer.place->over) < 0 ? around.end : around.begin;
}

GroupId layerBeside(const Painting &before, GroupId layer, const Painting &after)
{
    const std::vector<GroupId> around = groupsAround(before, layer);
    const auto stays = std::ranges::find_if(around, [&](GroupId id) { return after.findGroup(id) != nullptr; });
    if (stays == around.begin())
        return layer;
    const GroupId gone = *std::prev(stays), parent = stays == around.end() ? 0 : *stays;
    const GroupSpan span = spanOf(before, gone);
    const auto layerAt = [&](std::size_t i) -> GroupId {
        const GroupId member = memberAround(before, parent, *before.strokes[i]);
        return after.findGroup(member) && layerAround(after, member) == member ? member : 0;
    };
    WithinGroup within(before, parent);
    for (std::size_t i = span.begin; i > 0 && within(*before.strokes[i - 1]); --i)
        if (const GroupId below = layerAt(i - 1))
            return below;
    for (std::size_t i = span.end; i < before.strokes.size() && within(*before.strokes[i]); ++i)
        if (const GroupId above = layerAt(i))
            return above;
    return parent ? layerAround(after, parent) : 0;
}

} // namespace suffuse
