#include "undo/layer_edits.h"

#include "undo/history/group_spans.h"

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

/// Where strokes come, in which group.
struct PlaceInLayer {
    GroupId group = 0;
    std::size_t index = 0;
};

PlaceInLayer placeFor(const Painting &painting, const PaintedLayer &layer, LayerEnd end,
                      std::optional<Microseconds> born)
{
    const std::size_t top = painting.strokes.size();
    const bool isComing = !painting.findGroup(layer.group);
    const GroupId wanted = isComing ? layer.coming->parent : layer.group;
    const GroupId group = groupTakingPaint(painting, wanted);
    if (group != wanted) { // just above what is hidden or locked
        const std::vector<GroupId> around = groupsAround(painting, wanted);
        const auto inner = group == 0 ? around.end() : std::ranges::find(around, group);
        const GroupSpan past = spanOf(painting, *std::prev(inner));
        return {group, past.isEmpty() ? top : past.end};
    }
    if (isComing)
        return {group, comingIndex(painting, layer).value_or(top)};
    const GroupSpan span = spanOf(painting, group);
    if (span.isEmpty()) // of an empty group: on top of what is around it
        return {group, spanOf(painting, painting.findGroup(group)->parent).end};
    if (born)
        return {group, placeWithin(painting, group, span, *born)};
    return {group, end == LayerEnd::Top ? span.end : span.begin};
}

/// The siblings among which a group is, and its number among them; none where there is no such group, or it is empty.
std::vector<Sibling> *siblingsOf(std::vector<Sibling> &tree, GroupId group, std::size_t &number)
{
    for (std::size_t i = 0; i < tree.size(); ++i) {
        number = i;
        if (tree[i].group == group)
            return &tree;
        if (tree[i].group != 0)
            if (std::vector<Sibling> *found = siblingsOf(tree[i].members, group, number))
                return found;
    }
    return nullptr;
}

bool isGroupHidden(const Painting &painting, GroupId group)
{
    return std::ranges::any_of(groupsAround(painting, group),
                               [&](GroupId id) { return !painting.findGroup(id)->visible; });
}

bool isGroupLocked(const Painting &painting, GroupId group)
{
    return std::ranges::any_of(groupsAround(painting, group),
                               [&](GroupId id) { return painting.findGroup(id)->locked; });
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

Edit addedToLayer(const Document &document, Edit edit, const PaintedLayer &layer, LayerEnd end,
                  std::optional<Microseconds> born)
{
    const Painting &painting = *document.painting();
    const bool isThere = painting.findGroup(layer.group) != nullptr;
    const std::vector<StrokeId> added = addedOnTop(painting, edit);
    if (added.empty() || layer.group == 0 || (!isThere && !layer.coming))
        return edit;
    const PlaceInLayer place = placeFor(painting, layer, end, born);
    const GroupId into = isThere ? place.group : layer.group;
    if (edit.groups)
        for (Group &group : *edit.groups)
            if (group.parent == 0 && !painting.findGroup(group.id))
                group.parent = into;
    if (!isThere) {
        Group coming = *layer.coming;
        coming.id = layer.group;
        coming.parent = place.group;
        if (!edit.groups)
            edit.groups = painting.groups;
        edit.groups->push_back(std::move(coming));
    }
    for (const StrokeId id : added)
        if (StrokePtr &stroke = edit.strokes.at(id); stroke->group == 0)
            stroke = intoGroup(*stroke, into);
    edit.order->resize(painting.strokes.size());
    edit.order->insert(edit.order->begin() + std::ptrdiff_t(place.index), added.begin(), added.end());
    return edit;
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

Edit duplicateGroup(Document &document, GroupId group, GroupId &copy)
{
    const Painting &painting = *document.painting();
    const GroupSpan span = painting.findGroup(group) ? spanOf(painting, group) : GroupSpan();
    if (span.isEmpty())
        return {};
    Edit edit;
    edit.groups = painting.groups;
    std::unordered_map<GroupId, GroupId> copies;
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
        if (original.id != group)
            made.parent = copies.at(original.parent);
        edit.groups->push_back(std::move(made));
    }
    std::vector<StrokeId> added;
    for (std::size_t i = span.begin; i < span.end; ++i) {
        const Stroke &original = *painting.strokes[i];
        auto made = std::make_shared<Stroke>(original);
        made->id = document.takeStrokeId();
        made->group = copies.at(original.group);
        added.push_back(made->id);
        edit.strokes.emplace(made->id, std::move(made));
    }
    edit.order = orderOf(painting);
    edit.order->insert(edit.order->begin() + std::ptrdiff_t(span.end), added.begin(), added.end());
    return edit;
}

MergedDown mergeDown(const Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    std::vector<Sibling> tree = orderTree(painting, {});
    std::size_t number = 0;
    const std::vector<Sibling> *siblings = painting.findGroup(group) ? siblingsOf(tree, group, number) : nullptr;
    if (!siblings || number == 0)
        return {{}, 0, NotMerged::NothingBelow};
    const GroupId below = (*siblings)[number - 1].group;
    if (below == 0 || layerAround(painting, below) != below)
        return {{}, 0, NotMerged::NoGroupBelow};
    if (isGroupLocked(painting, group) || isGroupLocked(painting, below))
        return {{}, 0, NotMerged::Locked};
    if (isGroupHidden(painting, group) || isGroupHidden(painting, below))
        return {{}, 0, NotMerged::Hidden};
    MergedDown merged;
    merged.below = below;
    merged.edit.groups.emplace();
    for (Group g : painting.groups) {
        if (g.id == group)
            continue;
        if (g.parent == group)
            g.parent = below;
        merged.edit.groups->push_back(std::move(g));
    }
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->group == group)
            merged.edit.strokes.emplace(stroke->id, intoGroup(*stroke, below));
    return merged;
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
