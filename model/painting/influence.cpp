#include "model/painting/influence.h"

namespace suffuse {

Rect influenceOf(const Stroke &stroke, const Segment &segment, Microseconds T)
{
    const double spread = segment.spread(T) * std::sqrt(std::max(1.0, double(segment.anisotropyRatio)));
    if (!(spread > 0))
        return {};
    return stroke.cubicOf(segment).controlBox().grown(reachInSpreads * spread);
}

Rect influenceOf(const Stroke &stroke, Microseconds T)
{
    Rect box;
    for (const Segment &segment : stroke.segments)
        box = box.united(influenceOf(stroke, segment, T));
    return box;
}

Rect influenceOf(const Painting &painting, Microseconds T)
{
    Rect box;
    for (const StrokePtr &stroke : painting.strokes)
        if (painting.isVisible(*stroke))
            box = box.united(influenceOf(*stroke, T));
    return box;
}

} // namespace suffuse
