#include "tests/bench/editing/editing_benches.h"

#include <limits>

namespace suffuse {

/// The segment whose middle lies nearest to the middle of the canvas, of a stroke with some on either side.
SegmentRef middleSegment(const Painting &painting)
{
    SegmentRef best;
    double least = std::numeric_limits<double>::infinity();
    for (const StrokePtr &stroke : painting.strokes)
        for (int k = 2; k + 2 < int(stroke->segments.size()); ++k) {
            const Point middle = stroke->cubicOf(stroke->segments[std::size_t(k)]).at(0.5);
            if (const double d = length(middle - painting.canvas.area().centre()); d < least) {
                least = d;
                best = {stroke->id, k};
            }
        }
    return best;
}

std::set<StrokeId> firstStrokes(const Painting &painting, std::size_t count)
{
    std::set<StrokeId> strokes;
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.size() < count)
            strokes.insert(stroke->id);
    return strokes;
}

} // namespace suffuse
