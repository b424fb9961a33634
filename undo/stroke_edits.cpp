#include "model/painting/validate.h"
#include "undo/edits.h"
#include "undo/order_tree.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

/// Restores all that may not change in a locked stroke: it may only be renamed, hidden and unlocked.
void keepLocked(const Stroke &before, Stroke &after)
{
    Stroke kept = before;
    kept.name = after.name;
    kept.visible = after.visible;
    kept.locked = after.locked;
    after = std::move(kept);
}

/// The copies of strokes, and of whole groups with the tree in them.
struct Copies {
    Document &document;
    const Painting &painting;
    Point offset;
    std::unordered_map<StrokeId, StrokePtr> originals;
    std::vector<StrokePtr> strokes; ///< from bottom to top
    std::vector<Group> groups;

    void add(const Sibling &sibling, GroupId around)
    {
        if (sibling.group != 0) {
            Group group = *std::ranges::find(painting.groups, sibling.group, &Group::id);
            group.id = document.takeGroupId();
            group.parent = around;
            groups.push_back(group);
            for (const Sibling &member : sibling.members)
                add(member, group.id);
            return;
        }
        auto copy = std::make_shared<Stroke>(*originals.at(sibling.stroke));
        copy->origin = copy->origin + offset;
        copy->group = around;
        if (!problemOf(*copy).isEmpty())
            return;
        copy->id = document.takeStrokeId();
        strokes.push_back(std::move(copy));
    }
};

std::unordered_map<StrokeId, StrokePtr> byId(const Painting &painting)
{
    std::unordered_map<StrokeId, StrokePtr> found;
    for (const StrokePtr &stroke : painting.strokes)
        found.emplace(stroke->id, stroke);
    return found;
}

/// The group that a sibling is in.
GroupId aroundOf(const Painting &painting, const Sibling &sibling)
{
    if (sibling.group == 0)
        return painting.find(sibling.stroke)->group;
    return std::ranges::find(painting.groups, sibling.group, &Group::id)->parent;
}

/// The place in the order just above a sibling and all that is in it.
std::ptrdiff_t placeAbove(const Painting &painting, const Sibling &sibling)
{
    const auto isOf = [&](const StrokePtr &stroke) {
        if (sibling.group == 0)
            return stroke->id == sibling.stroke;
        const std::vector<GroupId> around = groupsAround(painting, stroke->group);
        return std::ranges::find(around, sibling.group) != around.end();
    };
    std::ptrdiff_t place = 0, above = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        ++place;
        if (isOf(stroke))
            above = place;
    }
    return above;
}

} // namespace

Edit changeStrokes(const Document &document, const std::set<StrokeId> &targets,
                   const std::function<void(Stroke &)> &change)
{
    Edit edit;
    if (targets.empty())
        return edit;
    const Painting &painting = *document.painting();
    for (const StrokePtr &stroke : painting.strokes) {
        if (!targets.contains(stroke->id))
            continue;
        auto changed = std::make_shared<Stroke>(*stroke);
        change(*changed);
        changed->id = stroke->id;
        changed->group = stroke->group;
        if (painting.isLocked(*stroke))
            keepLocked(*stroke, *changed);
        if (*changed != *stroke && problemOf(*changed).isEmpty())
            edit.strokes.emplace(stroke->id, std::move(changed));
    }
    return edit;
}

Edit addStrokes(const Document &document, const std::vector<StrokePtr> &strokes, bool select)
{
    const Painting &painting = *document.painting();
    Edit edit;
    std::vector<StrokeId> order = orderOf(painting);
    std::set<StrokeId> taken(order.begin(), order.end());
    Selection selection;
    GroupId topGroup = painting.strokes.empty() ? 0 : painting.strokes.back()->group;
    for (const StrokePtr &stroke : strokes) {
        if (!stroke || !problemOf(*stroke).isEmpty() || !taken.insert(stroke->id).second)
            continue;
        StrokePtr added = stroke;
        // The members of a group stand together, so a stroke on top can join only the group of the topmost stroke.
        if (stroke->group != topGroup && stroke->group != 0) {
            auto ungrouped = std::make_shared<Stroke>(*stroke);
            ungrouped->group = 0;
            added = std::move(ungrouped);
        }
        topGroup = added->group;
        order.push_back(added->id);
        selection.strokes.insert(added->id);
        edit.strokes.emplace(added->id, std::move(added));
    }
    if (edit.strokes.empty())
        return {};
    edit.order = std::move(order);
    if (select)
        edit.selection = std::move(selection);
    return edit;
}

Edit duplicateSelection(Document &document, Point offset)
{
    const PaintingPtr painting = document.painting();
    // A click on a group does not select what is hidden or locked in it. The group counts as selected all the same.
    const std::set<StrokeId> &selected = document.selection().strokes;
    Painting selectable = *painting;
    selectable.strokes.clear();
    for (const StrokePtr &stroke : painting->strokes)
        if (selected.contains(stroke->id) || (painting->isVisible(*stroke) && !painting->isLocked(*stroke)))
            selectable.strokes.push_back(stroke);
    const std::vector<Sibling> tree = orderTree(selectable, selected);
    const std::vector<const Sibling *> units = selectedUnits(tree);
    if (units.empty())
        return {};
    const Sibling &topmost = *units.back();
    Copies copies{document, *painting, offset, byId(*painting), {}, {}};
    for (const Sibling *unit : units)
        copies.add(*unit, aroundOf(*painting, topmost));
    if (copies.strokes.empty())
        return {};
    Edit edit;
    edit.order = orderOf(*painting);
    std::vector<StrokeId> added;
    for (StrokePtr &copy : copies.strokes) {
        added.push_back(copy->id);
        edit.strokes.emplace(copy->id, std::move(copy));
    }
    edit.order->insert(edit.order->begin() + placeAbove(*painting, topmost), added.begin(), added.end());
    edit.selection.emplace().strokes = {added.begin(), added.end()};
    if (!copies.groups.empty()) {
        edit.groups = painting->groups;
        edit.groups->insert(edit.groups->end(), copies.groups.begin(), copies.groups.end());
    }
    return edit;
}

Edit setCanvas(const Document &document, const Canvas &canvas)
{
    Edit edit;
    if (problemOf(canvas).isEmpty() && canvas != document.painting()->canvas)
        edit.canvas = canvas;
    return edit;
}

} // namespace suffuse
