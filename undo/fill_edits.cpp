#include "undo/fill_edits.h"

#include "model/area/outline.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"
#include "model/shaping/erasing/unfilled.h"
#include "model/shaping/transform.h"
#include "undo/edits.h"

#include <algorithm>

namespace suffuse {

namespace {

/// The exact box of what the stroke encloses, offsets from its origin. Handles may reach far beyond the curves.
Rect enclosedBox(const Stroke &stroke)
{
    Rect box;
    for (const std::vector<Cubic> &loop : closedOutline(stroke))
        for (const Cubic &curve : loop)
            box = box.united(curveBox(curve));
    return box.isEmpty() ? outlineBox(stroke) : box; // a loop without extent
}

} // namespace

Fill usualFill(const Stroke &stroke)
{
    const auto paints = std::ranges::find_if(stroke.segments, [](const Segment &s) { return !s.takesPaint(); });
    Fill fill;
    fill.density = float(2 * visibleCut(stroke.style)); // It is half of that along a long straight edge.
    fill.born = stroke.born();
    for (const Segment &segment : stroke.segments) // An outline that is being drawn encloses nothing yet.
        if (!segment.takesPaint())
            fill.born = std::max(fill.born, segment.born);
    if (paints == stroke.segments.end())
        return fill;
    fill.diffusion = paints->diffusion;
    fill.granulation = paints->granulation;
    fill.maxAge = paints->maxAge;
    fill.colour = paints->colour;
    return fill;
}

Edit addFills(const Document &document, const std::set<StrokeId> &strokes)
{
    return changeStrokes(document, strokes, [](Stroke &stroke) {
        if (!stroke.fill)
            stroke.fill = usualFill(stroke);
    });
}

Edit removeFills(const Document &document, const std::set<StrokeId> &strokes)
{
    return changeStrokes(document, strokes, [](Stroke &stroke) {
        if (stroke.fill)
            stroke = withoutFill(stroke);
    });
}

Edit addGradients(const Document &document, const std::set<StrokeId> &strokes)
{
    return changeStrokes(document, strokes, [](Stroke &stroke) {
        if (!stroke.fill || stroke.fill->gradient)
            return;
        const Rect box = enclosedBox(stroke);
        Fill fill = *stroke.fill;
        const auto middle = float(box.centre().y);
        fill.gradient = Gradient{{float(box.left), middle}, {float(box.right), middle}, fill.colour};
        if (fill.gradient->from == fill.gradient->to)
            fill.gradient->to.x += 1;
        fill.gradient->colour.opacity = 0;
        stroke.fill = fill;
    });
}

namespace {

Edit changeGradients(const Document &document, const std::set<StrokeId> &strokes,
                     const std::function<void(Fill &)> &change)
{
    return changeFills(document, *document.painting(), strokes, [&](Fill &now, const Fill &) {
        if (now.gradient)
            change(now);
    });
}

} // namespace

Edit removeGradients(const Document &document, const std::set<StrokeId> &strokes)
{
    return changeGradients(document, strokes, [](Fill &fill) { fill.gradient.reset(); });
}

Edit swapGradients(const Document &document, const std::set<StrokeId> &strokes)
{
    return changeGradients(document, strokes, [](Fill &fill) { std::swap(fill.colour, fill.gradient->colour); });
}

Edit changeFills(const Document &document, const Painting &before, const std::set<StrokeId> &strokes,
                 const std::function<void(Fill &now, const Fill &then)> &change)
{
    return changeStrokes(document, strokes, [&](Stroke &stroke) {
        if (!stroke.fill)
            return;
        const StrokePtr then = before.find(stroke.id);
        Stroke changed = stroke;
        Fill fill = *stroke.fill;
        change(fill, then && then->fill ? *then->fill : *stroke.fill);
        changed.fill = fill;
        if (problemOf(changed).isEmpty())
            stroke.fill = changed.fill;
    });
}

} // namespace suffuse
