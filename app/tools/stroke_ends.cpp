#include "app/tools/stroke_ends.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "model/painting/editable.h"
#include "model/shaping/nodes/reshape.h"

namespace suffuse {

std::optional<NodeRef> selectedEndAt(const CanvasWidget &canvas, const Painting &painting, Point pixel)
{
    constexpr double reach = 8; // logical pixels
    std::optional<NodeRef> found;
    const std::set<StrokeId> &selected = canvas.selection().strokes;
    if (selected.empty())
        return found;
    double nearest = reach * canvas.devicePixelRatioF();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!selected.contains(stroke->id) || isLocked(*stroke))
            continue;
        for (const int node : endNodesOf(*stroke))
            if (const double d = length(canvas.view().toPixels(nodePosition(*stroke, node)) - pixel); d <= nearest) {
                nearest = d;
                found = {stroke->id, node};
            }
    }
    return found;
}

} // namespace suffuse
