#include "undo/layers/merge_layers.h"

#include "model/painting/editable.h"
#include "undo/history/order_tree.h"
#include "undo/layers/layer_edits.h"

#include <algorithm>

namespace suffuse {

namespace {

const Group *groupOf(const Painting &painting, const Sibling &sibling)
{
    return sibling.group ? painting.findGroup(sibling.group) : nullptr;
}

bool isMask(const Painting &painting, const Sibling &sibling)
{
    const Group *group = groupOf(painting, sibling);
    return group && group->mask;
}

/// Whether one of some siblings is clipped to what lies below the first of them. Masks are no base for others.
template <typename It>
bool beginsClipped(const Painting &painting, It from, It to)
{
    for (; from != to; ++from) {
        const Group *group = groupOf(painting, *from);
        if (group && group->clips)
            return true;
        if (!group || !group->mask)
            return false;
    }
    return false;
}

/// Whether its strokes look as if there were no such group, in pictures that are exported, too.
bool doesNothing(const Painting &painting, const Sibling &sibling)
{
    const Group &group = *groupOf(painting, sibling);
    return !group.isIsolated() && !group.wash && !group.draft &&
           std::ranges::none_of(sibling.members, [&](const Sibling &s) { return isMask(painting, s); });
}

bool isHidden(const Painting &painting, GroupId group)
{
    return isHiddenBySolo(painting.groups, group) ||
           std::ranges::any_of(groupsAround(painting, group),
                               [&](GroupId id) { return !painting.findGroup(id)->visible; });
}

NotMerged whyNotMerged(const Painting &painting, const std::vector<Sibling> &siblings, std::size_t number)
{
    if (number == 0)
        return NotMerged::NothingBelow;
    const Sibling &upper = siblings[number], &lower = siblings[number - 1];
    if (lower.group == 0 || layerAround(painting, lower.group) != lower.group)
        return NotMerged::NoGroupBelow;
    const Locks isLocked(painting.groups);
    if (isLocked(upper.group) || isLocked(lower.group))
        return NotMerged::Locked;
    if (isHidden(painting, upper.group) || isHidden(painting, lower.group))
        return NotMerged::Hidden;
    if (isMask(painting, upper) || isMask(painting, lower))
        return NotMerged::Mask;
    if (groupOf(painting, lower)->clips)
        return NotMerged::Clipped;
    const auto above = siblings.begin() + std::ptrdiff_t(number) + 1;
    return beginsClipped(painting, above, siblings.end()) ? NotMerged::ClippedTo : NotMerged::Merged;
}

/// Moves what is directly in a group into another one, which `edit` has or will have.
void moveMembers(const Painting &painting, GroupId from, GroupId to, Edit &edit)
{
    for (Group &group : *edit.groups)
        if (group.parent == from)
            group.parent = to;
    for (const StrokePtr &stroke : painting.strokes) {
        if (stroke->group != from)
            continue;
        auto moved = std::make_shared<Stroke>(*stroke);
        moved->group = to;
        edit.strokes.emplace(stroke->id, std::move(moved));
    }
}

/// Has a group within `lower` do what that does, and takes all into it that is in `lower`.
void wrapMembers(Document &document, GroupId lower, Edit &edit)
{
    const GroupId wrap = document.takeGroupId();
    moveMembers(*document.painting(), lower, wrap, edit);
    const auto outer = std::ranges::find(*edit.groups, lower, &Group::id);
    Group inner = *outer;
    inner.id = wrap;
    inner.parent = lower;
    inner.solo = false;
    inner.tag = GroupTag::None;
    outer->opacity = 1;
    outer->blend = BlendMode::Normal;
    outer->isolated = false;
    outer->wash.reset();
    outer->draft = false;
    edit.groups->push_back(std::move(inner));
}

} // namespace

MergedDown mergeDown(Document &document, GroupId group)
{
    const Painting &painting = *document.painting();
    std::vector<Sibling> tree = orderTree(painting, {});
    std::size_t number = 0;
    const std::vector<Sibling> *siblings = painting.findGroup(group) ? siblingsOf(tree, group, number) : nullptr;
    MergedDown merged;
    merged.why = siblings ? whyNotMerged(painting, *siblings, number) : NotMerged::NothingBelow;
    if (merged.why != NotMerged::Merged)
        return merged;
    const Sibling &upper = (*siblings)[number], &lower = (*siblings)[number - 1];
    merged.below = lower.group;
    merged.edit.groups = painting.groups;
    const bool wraps = !doesNothing(painting, lower) || groupOf(painting, upper)->clips;
    if (wraps)
        wrapMembers(document, lower.group, merged.edit);
    const auto &within = upper.members;
    merged.keepsGroup = wraps || !doesNothing(painting, upper) || beginsClipped(painting, within.begin(), within.end());
    if (merged.keepsGroup) {
        std::ranges::find(*merged.edit.groups, group, &Group::id)->parent = lower.group;
    } else {
        moveMembers(painting, group, lower.group, merged.edit);
        std::erase_if(*merged.edit.groups, [group](const Group &g) { return g.id == group; });
    }
    return merged;
}

} // namespace suffuse
