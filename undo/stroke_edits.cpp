#include "model/painting/validate.h"
#include "undo/edits.h"
#include "undo/order_tree.h"

namespace suffuse {

namespace {

/// A locked stroke may be renamed, hidden and unlocked, nothing else.
void keepLocked(const Stroke &before, Stroke &after)
{
    Stroke kept = before;
    kept.name = after.name;
    kept.visible = after.visible;
    kept.locked = after.locked;
    after = std::move(kept);
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
        // Members of a group stand together: only the topmost stroke's group can be joined on top.
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
    const std::set<StrokeId> &selected = document.selection().strokes;
    std::vector<StrokePtr> originals;
    for (const StrokePtr &stroke : painting->strokes)
        if (selected.contains(stroke->id) && !painting->isLocked(*stroke))
            originals.push_back(stroke);
    if (originals.empty())
        return {};
    const StrokePtr topmost = originals.back();
    Edit edit;
    std::vector<StrokeId> copies;
    Selection selection;
    for (const StrokePtr &stroke : originals) {
        auto copy = std::make_shared<Stroke>(*stroke);
        copy->origin = copy->origin + offset;
        copy->group = topmost->group;
        if (!problemOf(*copy).isEmpty())
            continue;
        copy->id = document.takeStrokeId();
        copies.push_back(copy->id);
        selection.strokes.insert(copy->id);
        edit.strokes.emplace(copy->id, std::move(copy));
    }
    if (copies.empty())
        return {};
    std::vector<StrokeId> order = orderOf(*painting);
    const auto place = std::find(order.begin(), order.end(), topmost->id) + 1;
    order.insert(place, copies.begin(), copies.end());
    edit.order = std::move(order);
    edit.selection = std::move(selection);
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
