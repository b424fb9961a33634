#include "app/tools/shapes/shape_paint.h"

#include "model/painting/validate.h"
#include "undo/fill_edits.h"

namespace suffuse {

StrokePtr paintedAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born,
                       ShapePaint paint)
{
    Stroke stroke = strokeAlong(curves, brush, id, born);
    if (stroke.segments.empty())
        return nullptr;
    if (paint != ShapePaint::Outline)
        stroke.fill = usualFill(stroke);
    if (paint == ShapePaint::Fill)
        for (Segment &segment : stroke.segments)
            segment.density = 0; // it bounds the fill, and lays no paint
    return problemOf(stroke).isEmpty() ? std::make_shared<const Stroke>(std::move(stroke)) : nullptr;
}

} // namespace suffuse
