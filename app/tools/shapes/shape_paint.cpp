#include "app/tools/shapes/shape_paint.h"

#include "model/area/area_sets.h"
#include "model/area/offset_curve.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "undo/fill_edits.h"

namespace suffuse {

namespace {

/// How wide what curves enclose is that a fill closes, as a strip of the same area and perimeter is wide: of a disc it
/// is the radius. Canvas units.
double widthWithin(std::vector<Cubic> curves)
{
    if (curves.front().p[0] != curves.back().p[3])
        curves.push_back(straightCubic(curves.back().p[3], curves.front().p[0]));
    double perimeter = 0;
    for (const Cubic &curve : curves)
        perimeter += arcLength(curve);
    const double width = perimeter > 0 ? 2 * sizeOf(areaOf({curves}, FillRule::NonZero)) / perimeter : 0;
    return width > 1e-6 * perimeter ? width : 0; // Less is rounding, of a line that goes there and back.
}

/// The fill with a spread that leaves a shape so wide visible. Where paint spreads farther than the shape is wide it
/// gets so thin that styles with a rim show nothing at all.
Fill fitting(Fill fill, double width)
{
    const double spread = 0.5 * width;
    fill.diffusion = std::min(fill.diffusion, float(spread * spread / (4 * double(fill.maxAge))));
    return fill;
}

} // namespace

StrokePtr paintedAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born,
                       ShapePaint paint)
{
    Stroke stroke = strokeAlong(curves, brush, id, born);
    if (stroke.segments.empty())
        return nullptr;
    const double width = paint == ShapePaint::Outline ? 0 : widthWithin(curves);
    if (paint == ShapePaint::Fill && width == 0)
        return nullptr;
    if (paint != ShapePaint::Outline)
        stroke.fill = fitting(usualFill(stroke), width);
    if (paint == ShapePaint::Fill)
        for (Segment &segment : stroke.segments)
            segment.density = 0; // it bounds the fill, and lays no paint
    return problemOf(stroke).isEmpty() ? std::make_shared<const Stroke>(std::move(stroke)) : nullptr;
}

} // namespace suffuse
