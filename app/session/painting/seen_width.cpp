#include "app/session/painting/seen_width.h"

#include "model/paint/half_width.h"

namespace suffuse {

std::optional<SeenWidth> seenWidth(const Stroke &stroke, int index, Microseconds T)
{
    const Segment &segment = stroke.segments[std::size_t(index)];
    SeenWidth seen;
    const double age = segment.age(T);
    seen.age = age > 0 ? age : double(segment.maxAge);
    seen.across = diffusionAcross(segment, tangentAt(stroke.cubicOf(segment), 0.5)) / double(segment.diffusion);
    seen.cut = visibleCut(stroke.styleOf(segment));
    seen.width = halfWidth(seen.across * double(segment.diffusion), double(segment.density), seen.age, seen.cut);
    return seen.cut > 0 ? std::optional(seen) : std::nullopt;
}

void setSeenWidth(Segment &segment, const SeenWidth &seen, double width, bool diffusionAlone)
{
    const double diffusion = seen.across * double(segment.diffusion);
    if (diffusionAlone) {
        if (width > 0 && segment.density > 0)
            segment.diffusion =
                float(diffusionForHalfWidth(width, double(segment.density), seen.age, seen.cut) / seen.across);
        return;
    }
    const WidthValues values = valuesForHalfWidth(width, diffusion, seen.age, seen.cut);
    if (values.diffusion != diffusion)
        segment.diffusion = float(values.diffusion / seen.across);
    segment.density = float(values.density);
}

} // namespace suffuse
