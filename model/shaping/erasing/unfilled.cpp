#include "model/shaping/erasing/unfilled.h"

#include "model/area/outline.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"

namespace suffuse {

Stroke withoutFill(const Stroke &stroke)
{
    constexpr double narrowest = 1; // units: half of the width of the outline
    Stroke result = stroke;
    result.fill = {};
    if (!isFillAlone(stroke))
        return result;
    const Fill &fill = *stroke.fill;
    for (Segment &segment : result.segments) {
        if (segment.takesPaint())
            continue;
        const double age = double(segment.maxAge), spread = spreadAt(double(segment.diffusion), age);
        const double width = std::max(narrowest, spread);
        const WidthValues values =
            valuesForHalfWidth(width, double(segment.diffusion), age, visibleCut(stroke.styleOf(segment)));
        segment.diffusion = float(values.diffusion);
        segment.density = float(values.density);
        segment.colour = fill.colour;
        segment.granulation = fill.granulation;
    }
    return problemOf(result).isEmpty() ? result : stroke;
}

} // namespace suffuse
