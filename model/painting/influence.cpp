#include "model/painting/influence.h"

namespace suffuse {

Rect influenceOf(const Stroke &stroke, const Segment &segment, Microseconds T)
{
    const double spread = segment.spread(T) * std::sqrt(std::max(1.0, double(segment.anisotropyRatio)));
    if (!(spread > 0))
        return {};
    return stroke.cubicOf(segment).controlBox().grown(reachInSpreads * spread);
}

Rect influenceOfFill(const Stroke &stroke, Microseconds T)
{
    Rect box;
    if (!stroke.fill || !(stroke.fill->age(T) > 0))
        return box;
    for (const Segment &segment : stroke.segments)
        if (!segment.takesPaint())
            box = box.united(stroke.cubicOf(segment).controlBox());
    const Fill &fill = *stroke.fill;
    return box.grown(reachInSpreads * fill.spread(T) * std::sqrt(std::max(1.0, double(fill.anisotropyRatio))));
}

Rect influenceOf(const Stroke &stroke, Microseconds T)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        box = box.united(influenceOf(stroke, segment, T));
    return box.united(influenceOfFill(stroke, T));
}

Rect influenceOf(const Painting &painting, Microseconds T)
{
    Rect box;
    const Visibility isVisible(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (isVisible(*stroke))
            box = box.united(influenceOf(*stroke, T));
    return box;
}

} // namespace suffuse
