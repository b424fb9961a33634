#include "undo/run_edits.h"

#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "undo/history/remap.h"

namespace suffuse {

std::vector<bool> chosenSegments(const Stroke &stroke, const Selection &selection)
{
    std::vector<bool> chosen;
    const auto first = selection.segments.lower_bound({stroke.id, 0});
    for (auto it = first; it != selection.segments.end() && it->stroke == stroke.id; ++it) {
        chosen.resize(stroke.segments.size());
        if (std::size_t(it->segment) < chosen.size())
            chosen[std::size_t(it->segment)] = true;
    }
    return chosen;
}

Edit reshapeSelection(const Document &document, const Painting &before, const Selection &selection,
                      const ReshapeRuns &change)
{
    Edit edit;
    Selection after = selection;
    std::map<StrokeId, StrokePtr> inDocument;
    for (const StrokePtr &stroke : document.painting()->strokes)
        if (selection.strokes.contains(stroke->id))
            inDocument.emplace(stroke->id, stroke);
    const Editable isEditable(before.groups);
    for (const StrokePtr &stroke : before.strokes) {
        const StrokeId id = stroke->id;
        const auto it = inDocument.find(id);
        if (it == inDocument.end() || !isEditable(*stroke))
            continue;
        const StrokePtr &shown = it->second;
        std::vector<int> sources;
        Stroke result = change(*stroke, chosenSegments(*stroke, selection), &sources);
        if (!problemOf(result).isEmpty())
            continue;
        if (!sources.empty() && sources.size() != stroke->segments.size())
            remap(after, id, sources);
        if (result == *stroke) {
            if (shown != stroke)
                edit.strokes.emplace(id, stroke);
        } else if (result != *shown) {
            edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(result)));
        }
    }
    if (!edit.strokes.empty() && after != document.selection())
        edit.selection = std::move(after);
    return edit;
}

Edit tweakStrokes(const Document &document, const std::vector<StrokePtr> &strokes, const std::vector<Tweak> &touches)
{
    Edit edit;
    Selection after = document.selection();
    const Painting &painting = *document.painting();
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : strokes) {
        if (!isEditable(*stroke))
            continue;
        std::optional<Stroke> result;
        for (const Tweak &touch : touches) {
            std::vector<int> sources;
            if (result ? !tweak(*result, touch, &sources) : !(result = tweaked(*stroke, touch, &sources)))
                continue;
            if (!sources.empty())
                remap(after, stroke->id, sources);
        }
        if (result && *result != *stroke)
            edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(*result)));
    }
    if (!edit.strokes.empty() && after != document.selection())
        edit.selection = std::move(after);
    return edit;
}

Edit redrawStroke(const Document &document, StrokeId id, const Stroke &line, double reach, RedrawValues values)
{
    Edit edit;
    const Painting &painting = *document.painting();
    const StrokePtr stroke = painting.find(id);
    if (!stroke || painting.isLocked(*stroke))
        return edit;
    const std::optional<RedrawnPart> part = partToRedraw(*stroke, pointsAlong(line), reach);
    std::vector<int> sources;
    std::optional<Stroke> result = part ? redrawn(*stroke, *part, line, reach, values, &sources) : std::nullopt;
    if (!result || *result == *stroke)
        return edit;
    Selection after = document.selection();
    remap(after, id, sources);
    edit.strokes.emplace(id, std::make_shared<const Stroke>(std::move(*result)));
    if (after != document.selection())
        edit.selection = std::move(after);
    return edit;
}

} // namespace suffuse
