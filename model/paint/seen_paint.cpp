#include "model/paint/seen_paint.h"

#include "model/paint/local_paint.h"
#include "model/paint/point_density.h"

namespace suffuse {

SeenPaint seenPaint(const Stroke &stroke, Microseconds T, Point point)
{
    const Point at = point - stroke.origin;
    SeenPaint seen;
    LocalPaint paint;
    double largest = 0;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double spread = segment.spread(T);
        if (!(spread > 0) || !reaches(segment, spread, at))
            continue;
        const double density = segmentDensity(segment, spread, at, CurveDetail::Rough);
        paint.add(segment, stroke.styleOf(segment), density);
        if (density > largest && !segment.lift) {
            largest = density;
            seen.segment = int(k);
        }
    }
    seen.density = paint.density();
    seen.opacity = paint.opacity(1);
    return seen;
}

} // namespace suffuse
