#include "undo/history/restore_edit.h"

namespace suffuse {

Edit restorePainting(const Document &document, const Painting &state)
{
    const Painting &now = *document.painting();
    Edit edit;
    for (const StrokePtr &stroke : now.strokes) // Strokes that are not in `state` are removed.
        edit.strokes.emplace(stroke->id, nullptr);
    for (const StrokePtr &stroke : state.strokes)
        edit.strokes[stroke->id] = stroke;
    for (const StrokePtr &stroke : now.strokes)
        if (const StrokePtr &wanted = edit.strokes.at(stroke->id); wanted && *wanted == *stroke)
            edit.strokes.erase(stroke->id);
    if (std::vector<StrokeId> order = orderOf(state); order != orderOf(now))
        edit.order = std::move(order);
    if (state.canvas != now.canvas)
        edit.canvas = state.canvas;
    if (state.groups != now.groups)
        edit.groups = state.groups;
    if (state.swatches != now.swatches)
        edit.swatches = state.swatches;
    const Underlay *a = state.underlay.get(), *b = now.underlay.get();
    if (a != b && (!a || !b || !(*a == *b)))
        edit.underlay = state.underlay;
    return edit;
}

} // namespace suffuse
