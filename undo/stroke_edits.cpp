#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/erasing/erase.h"
#include "undo/edits.h"
#include "undo/history/order_tree.h"
#include "undo/text_links.h"

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
    std::unordered_map<StrokeId, StrokeId> ids; ///< of the copies, by those of the originals

    void add(const Sibling &sibling, GroupId around)
    {
        if (sibling.group != 0) {
            Group group = *painting.findGroup(sibling.group);
            group.id = document.takeGroupId();
            group.parent = around;
            group.text = moved(group.text, offset);
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
        ids.emplace(sibling.stroke, copy->id);
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
    return painting.findGroup(sibling.group)->parent;
}

/// The indices of the selected segments of a stroke. It is empty where the stroke is selected as a whole.
std::vector<int> selectedSegmentsOf(const Selection &selection, const Stroke &stroke)
{
    std::vector<int> indices;
    for (auto it = selection.segments.lower_bound({stroke.id, 0}); it != selection.segments.end(); ++it) {
        if (it->stroke != stroke.id || it->segment >= int(stroke.segments.size()))
            break;
        indices.push_back(it->segment);
    }
    return indices;
}

/// The stroke with copies of some of its segments behind the others, moved by `offset`. Each run of them is a chain.
Stroke withDoubled(const Stroke &stroke, const std::vector<int> &segments, Point offset)
{
    Stroke result = stroke;
    std::vector<Segment> run;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto k = std::size_t(segments[i]);
        Segment copy = stroke.segments[k];
        for (Offset &point : copy.bezier)
            point = {float(point.x + offset.x), float(point.y + offset.y)};
        run.push_back(std::move(copy));
        if (i + 1 < segments.size() && segments[i + 1] == segments[i] + 1 && !stroke.beginsChain(k + 1))
            continue;
        appendChain(result, std::exchange(run, {}));
    }
    return result;
}

/// Doubles erasures within their strokes, since without the paint that it takes away an erasure is nothing, and
/// selects the copies besides what the edit selects.
void doubleErasures(const Document &document, const std::set<StrokeId> &strokes, Point offset, Edit &edit)
{
    const Locks isLocked(document.painting()->groups);
    for (const StrokeId id : strokes) {
        const StrokePtr stroke = document.painting()->find(id);
        if (isLocked(*stroke))
            continue;
        auto doubled = std::make_shared<const Stroke>(
            withDoubled(*stroke, selectedSegmentsOf(document.selection(), *stroke), offset));
        if (!problemOf(*doubled).isEmpty())
            continue;
        if (!edit.selection)
            edit.selection.emplace();
        edit.selection->strokes.insert(id);
        for (std::size_t k = stroke->segments.size(); k < doubled->segments.size(); ++k)
            edit.selection->segments.insert({id, int(k)});
        edit.strokes.emplace(id, std::move(doubled));
    }
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

/// Copies of strokes above the topmost of them. `originals` says for each stroke what a copy of it is made of.
Edit copiesOf(Document &document, const std::set<StrokeId> &selected, std::unordered_map<StrokeId, StrokePtr> originals,
              Point offset)
{
    const PaintingPtr painting = document.painting();
    // A click on a group does not select what is hidden or locked in it. The group counts as selected all the same.
    Painting selectable = *painting;
    selectable.strokes.clear();
    const Editable isEditable(painting->groups);
    for (const StrokePtr &stroke : painting->strokes)
        if (selected.contains(stroke->id) || (isEditable(*stroke)))
            selectable.strokes.push_back(stroke);
    const std::vector<Sibling> tree = orderTree(selectable, selected);
    const std::vector<const Sibling *> units = selectedUnits(tree);
    if (units.empty())
        return {};
    const Sibling &topmost = *units.back();
    Copies copies{document, *painting, offset, std::move(originals), {}, {}, {}};
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
        linkCopies(copies.groups, copies.ids, offset);
        edit.groups = painting->groups;
        edit.groups->insert(edit.groups->end(), copies.groups.begin(), copies.groups.end());
    }
    return edit;
}

} // namespace

SharedText moved(const SharedText &text, Point by)
{
    if (!text)
        return {};
    Text copy = *text;
    copy.place.offset = copy.place.offset + by;
    return copy;
}

Edit changeStrokes(const Document &document, const std::set<StrokeId> &targets,
                   const std::function<void(Stroke &)> &change)
{
    Edit edit;
    if (targets.empty())
        return edit;
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!targets.contains(stroke->id))
            continue;
        auto changed = std::make_shared<Stroke>(*stroke);
        change(*changed);
        changed->id = stroke->id;
        changed->group = stroke->group;
        if (isLocked(*stroke))
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
    std::set<StrokeId> strokes = document.selection().strokes, erased;
    std::unordered_map<StrokeId, StrokePtr> originals = byId(*document.painting());
    for (const StrokeId id : document.selection().strokes) {
        StrokePtr &stroke = originals[id];
        if (!stroke)
            continue;
        const std::vector<int> chosen = selectedSegmentsOf(document.selection(), *stroke);
        if (chosen.empty())
            continue;
        if (std::optional<Stroke> part = withSegmentsOnly(*stroke, chosen))
            stroke = std::make_shared<const Stroke>(std::move(*part));
        else
            erased.insert(strokes.extract(id).value());
    }
    Edit edit = copiesOf(document, strokes, std::move(originals), offset);
    doubleErasures(document, erased, offset, edit);
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
