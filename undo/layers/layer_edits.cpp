#include "undo/layers/layer_edits.h"

#include "undo/history/group_spans.h"
#include "undo/text_links.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

/// The place in a group below what was begun after `born`, and in none of the groups within it.
std::size_t placeWithin(const Painting &painting, GroupId group, const GroupSpan &span, Microseconds born)
{
    std::size_t at = span.begin;
    while (at < span.end && painting.strokes[at]->born() <= born)
        ++at;
    if (at == span.end)
        return at;
    const GroupId member = memberAround(painting, group, *painting.strokes[at]);
    while (member != 0 && at > span.begin && memberAround(painting, group, *painting.strokes[at - 1]) == member)
        --at;
    return at;
}

/// Where a group ends in the order; an empty one ends on top of the innermost group around it that is not empty.
std::size_t endOf(const Painting &painting, GroupId group)
{
    while (group != 0 && spanOf(painting, group).isEmpty())
        group = painting.findGroup(group)->parent;
    return spanOf(painting, group).end;
}

/// Where strokes come, in which group.
struct PlaceInLayer {
    GroupId group = 0;
    std::size_t index = 0;
};

PlaceInLayer placeFor(const Painting &painting, const PaintedLayer &layer, LayerEnd end,
                      std::optional<Microseconds> born)
{
    const bool isComing = !painting.findGroup(layer.group);
    const GroupId wanted = isComing ? layer.coming->parent : layer.group;
    const GroupId group = groupTakingPaint(painting, wanted);
    if (group != wanted) { // just above what is hidden or locked
        const std::vector<GroupId> around = groupsAround(painting, wanted);
        const auto inner = group == 0 ? around.end() : std::ranges::find(around, group);
        return {group, endOf(painting, *std::prev(inner))};
    }
    if (isComing)
        return {group, comingIndex(painting, layer).value_or(endOf(painting, group))};
    const GroupSpan span = spanOf(painting, group);
    if (span.isEmpty())
        return {group, endOf(painting, group)};
    if (born)
        return {group, placeWithin(painting, group, span, *born)};
    return {group, end == LayerEnd::Top ? span.end : span.begin};
}

bool isGroupLocked(const Painting &painting, GroupId group)
{
    return std::ranges::any_of(groupsAround(painting, group),
                               [&](GroupId id) { return painting.findGroup(id)->locked; });
}

/// The place above the topmost selected stroke of a group, and above what that is in there.
std::optional<std::size_t> aboveSelected(const Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    WithinGroup within(painting, group);
    for (std::size_t i = selected.empty() ? 0 : painting.strokes.size(); i > 0; --i) {
        const Stroke &stroke = *painting.strokes[i - 1];
        if (!selected.contains(stroke.id) || !within(stroke))
            continue;
        const GroupId member = memberAround(painting, group, stroke);
        return member ? spanOf(painting, member).end : i;
    }
    return {};
}

/// Selects another stroke, of as many segments, in place of one that is selected.
void moveSelected(Selection &selection, StrokeId from, StrokeId to)
{
    if (selection.strokes.erase(from) == 0)
        return;
    selection.strokes.insert(to);
    for (auto it = selection.segments.lower_bound({from, 0}); it != selection.segments.end() && it->stroke == from;) {
        selection.segments.insert({to, it->segment});
        it = selection.segments.erase(it);
    }
}

StrokePtr intoGroup(const Stroke &stroke, GroupId group)
{
    auto result = std::make_shared<Stroke>(stroke);
    result->group = group;
    return result;
}

} // namespace

std::vector<StrokeId> addedOnTop(const Painting &painting, const Edit &edit)
{
    if (!edit.order || edit.order->size() <= painting.strokes.size() ||
        edit.order->size() - painting.strokes.size() != edit.strokes.size())
        return {};
    for (std::size_t i = 0; i < painting.strokes.size(); ++i)
        if ((*edit.order)[i] != painting.strokes[i]->id)
            return {};
    return {edit.order->begin() + std::ptrdiff_t(painting.strokes.size()), edit.order->end()};
}

GroupId layerAround(const Painting &painting, GroupId group)
{
    const std::vector<GroupId> around = groupsAround(painting, group);
    GroupId layer = around.empty() ? 0 : around.front();
    for (std::size_t i = 0; i < around.size(); ++i)
        if (painting.findGroup(around[i])->text)
            layer = i + 1 < around.size() ? around[i + 1] : 0;
    return layer;
}

GroupId groupTakingPaint(const Painting &painting, GroupId group)
{
    const std::vector<GroupId> around = groupsAround(painting, group);
    GroupId taking = around.empty() ? 0 : around.front();
    for (std::size_t i = 0; i < around.size(); ++i)
        if (const Group *g = painting.findGroup(around[i]); !g->visible || g->locked)
            taking = i + 1 < around.size() ? around[i + 1] : 0;
    return taking;
}

std::vector<GroupId> layersOf(const Painting &painting)
{
    std::unordered_map<GroupId, const Group *> known;
    for (const Group &group : painting.groups)
        known.emplace(group.id, &group);
    // Texts and what is in them are no layers.
    const auto around = [&](GroupId id) {
        std::vector<const Group *> chain;
        for (auto at = known.find(id); at != known.end() && chain.size() <= known.size(); at = known.find(id)) {
            chain.push_back(at->second);
            if (at->second->text)
                chain.clear();
            id = at->second->parent;
        }
        return chain;
    };
    std::vector<GroupId> layers;
    std::unordered_set<GroupId> seen;
    GroupId last = 0;
    for (auto it = painting.strokes.rbegin(); it != painting.strokes.rend(); ++it) {
        const GroupId group = (*it)->group;
        if (group == std::exchange(last, group) || group == 0)
            continue;
        const std::vector<const Group *> chain = around(group);
        for (auto outer = chain.rbegin(); outer != chain.rend(); ++outer)
            if (seen.insert((*outer)->id).second)
                layers.push_back((*outer)->id);
    }
    for (const Group &group : painting.groups)
        if (!seen.contains(group.id))
            if (const std::vector<const Group *> chain = around(group.id); !chain.empty() && chain.front() == &group) {
                seen.insert(group.id);
                layers.push_back(group.id);
            }
    return layers;
}

namespace {

bool canTake(const Painting &painting, const Edit &edit, const PaintedLayer &layer)
{
    return layer.group != 0 && (painting.findGroup(layer.group) || layer.coming) && !addedOnTop(painting, edit).empty();
}

/// Puts what an edit adds on top in its place.
Edit putAt(const Painting &painting, Edit edit, const PlaceInLayer &place)
{
    const std::vector<StrokeId> added = addedOnTop(painting, edit);
    if (edit.groups)
        for (Group &group : *edit.groups)
            if (group.parent == 0 && !painting.findGroup(group.id))
                group.parent = place.group;
    for (const StrokeId id : added)
        if (StrokePtr &stroke = edit.strokes.at(id); stroke->group == 0)
            stroke = intoGroup(*stroke, place.group);
    edit.order->resize(painting.strokes.size());
    edit.order->insert(edit.order->begin() + std::ptrdiff_t(place.index), added.begin(), added.end());
    return edit;
}

/// The same in the layer, which the edit makes there where it is not there yet.
Edit putInto(const Painting &painting, Edit edit, const PaintedLayer &layer, PlaceInLayer place)
{
    if (painting.findGroup(layer.group))
        return putAt(painting, std::move(edit), place);
    Group coming = *layer.coming;
    coming.id = layer.group;
    coming.parent = std::exchange(place.group, layer.group);
    edit = putAt(painting, std::move(edit), place);
    if (!edit.groups)
        edit.groups = painting.groups;
    edit.groups->push_back(std::move(coming));
    return edit;
}

} // namespace

Edit addedToLayer(const Document &document, Edit edit, const PaintedLayer &layer, LayerEnd end,
                  std::optional<Microseconds> born)
{
    const Painting &painting = *document.painting();
    if (!canTake(painting, edit, layer))
        return edit;
    return putInto(painting, std::move(edit), layer, placeFor(painting, layer, end, born));
}

std::vector<GroupId> layersAdded(const Painting &painting, const Edit &edit)
{
    std::vector<GroupId> layers;
    for (const auto &[id, stroke] : edit.strokes)
        if (!stroke || stroke->group == 0)
            return {};
    for (const Group &group : edit.groups ? *edit.groups : painting.groups)
        if (group.parent == 0 && !painting.findGroup(group.id)) {
            if (group.text)
                return {};
            layers.push_back(group.id);
        }
    return layers;
}

Edit pastedToLayer(const Document &document, Edit edit, const PaintedLayer &layer, std::optional<Microseconds> born)
{
    const Painting &painting = *document.painting();
    if (!canTake(painting, edit, layer))
        return edit;
    PlaceInLayer place = placeFor(painting, layer, LayerEnd::Top, born);
    const bool isThere = painting.findGroup(layer.group);
    if (!layersAdded(painting, edit).empty()) {
        const GroupId parent = isThere ? painting.findGroup(layer.group)->parent : layer.coming->parent;
        if (isThere && place.group == layer.group)
            place = {parent, endOf(painting, layer.group)};
        return putAt(painting, std::move(edit), place);
    }
    if (isThere && place.group == layer.group && !born)
        place.index = aboveSelected(document, layer.group).value_or(place.index);
    return putInto(painting, std::move(edit), layer, place);
}

bool isHiddenBySolo(const std::vector<Group> &groups, GroupId group)
{
    if (std::ranges::none_of(groups, &Group::solo))
        return false;
    std::set<GroupId> alone;
    for (const Group &g : groups)
        if (g.solo)
            alone.insert(g.id);
    return !withGroupsWithin(groups, alone).contains(group);
}

Edit endingSolo(const Document &document, Edit edit)
{
    const Painting &painting = *document.painting();
    const std::vector<Group> &groups = edit.groups ? *edit.groups : painting.groups;
    if (!edit.order || std::ranges::none_of(groups, &Group::solo))
        return edit;
    const bool hides = std::ranges::any_of(edit.strokes, [&](const auto &entry) {
        const StrokePtr &stroke = entry.second;
        return stroke && isHiddenBySolo(groups, stroke->group) && !painting.find(stroke->id);
    });
    if (!hides)
        return edit;
    if (!edit.groups)
        edit.groups = painting.groups;
    for (Group &group : *edit.groups)
        group.solo = false;
    return edit;
}

Edit duplicateGroup(Document &document, GroupId group, const QString &name, GroupId &copy)
{
    const Painting &painting = *document.painting();
    const GroupSpan span = painting.findGroup(group) ? spanOf(painting, group) : GroupSpan();
    if (span.isEmpty())
        return {};
    Edit edit;
    std::unordered_map<GroupId, GroupId> copies;
    std::vector<Group> copied;
    const std::unordered_set<GroupId> within = withGroupsWithin(painting.groups, {group});
    for (const Group &original : painting.groups)
        if (within.contains(original.id))
            copies.emplace(original.id, document.takeGroupId());
    copy = copies.at(group);
    for (const Group &original : painting.groups) {
        if (!within.contains(original.id))
            continue;
        Group made = original;
        made.id = copies.at(original.id);
        if (original.id == group)
            made.name = name;
        else
            made.parent = copies.at(original.parent);
        copied.push_back(std::move(made));
    }
    std::vector<StrokeId> added;
    std::unordered_map<StrokeId, StrokeId> ids;
    Selection selection = document.selection();
    for (std::size_t i = span.begin; i < span.end; ++i) {
        const Stroke &original = *painting.strokes[i];
        auto made = std::make_shared<Stroke>(original);
        made->id = document.takeStrokeId();
        made->group = copies.at(original.group);
        added.push_back(made->id);
        ids.emplace(original.id, made->id);
        moveSelected(selection, original.id, made->id);
        edit.strokes.emplace(made->id, std::move(made));
    }
    linkCopies(copied, ids);
    edit.groups = painting.groups;
    edit.groups->insert(edit.groups->end(), copied.begin(), copied.end());
    edit.order = orderOf(painting);
    edit.order->insert(edit.order->begin() + std::ptrdiff_t(span.end), added.begin(), added.end());
    if (selection != document.selection())
        edit.selection = std::move(selection);
    return edit;
}

Edit moveGroup(const Document &document, GroupId group, bool up)
{
    const Painting &painting = *document.painting();
    std::vector<Sibling> tree = orderTree(painting, {});
    std::size_t number = 0;
    std::vector<Sibling> *siblings = painting.findGroup(group) ? siblingsOf(tree, group, number) : nullptr;
    if (!siblings || isGroupLocked(painting, group) || (up ? number + 1 == siblings->size() : number == 0))
        return {};
    std::swap((*siblings)[number], (*siblings)[up ? number + 1 : number - 1]);
    Edit edit;
    edit.order = orderOf(tree);
    return edit;
}

Edit toggleSolo(const Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    const auto isOther = [group](const Group &g) { return g.solo && g.id != group; };
    const Group *given = painting.findGroup(group);
    if (!given)
        return {};
    const bool on = !given->solo || std::ranges::any_of(painting.groups, isOther);
    Edit edit;
    edit.groups = painting.groups;
    for (Group &g : *edit.groups)
        g.solo = on && g.id == group;
    return edit;
}

} // namespace suffuse
