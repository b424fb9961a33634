#include "render/cost.h"

#include "model/painting/influence.h"

#include <algorithm>

namespace suffuse {

namespace {

// Measured on an EPYC with AVX-512: nodes of the sample paintings (docs/performance.md), and pixels of strokes.
constexpr double secondsPerSegment = 3e-6, secondsPerStrokePixel = 3e-9, secondsPerPixel = 5e-9;

Rect inPixels(const Rect &box, const View &view)
{
    Rect out;
    for (const double x : {box.left, box.right})
        for (const double y : {box.top, box.bottom})
            out.include(view.toPixels({x, y}));
    return out;
}

/// Pixels of the picture in a box of pixels.
double pixelsOf(const Rect &box, const View &view)
{
    const double width = std::min(box.right, double(view.width)) - std::max(box.left, 0.0);
    const double height = std::min(box.bottom, double(view.height)) - std::max(box.top, 0.0);
    return width > 0 && height > 0 ? width * height : 0;
}

} // namespace

double cpuSeconds(const RenderRequest &request)
{
    double seconds = secondsPerPixel * request.view.width * request.view.height;
    const Visibility isVisible(request.painting->groups);
    for (const StrokePtr &stroke : request.painting->strokes) {
        if (!isVisible(*stroke))
            continue;
        seconds += secondsPerSegment * double(stroke->segments.size());
        const Rect box = influenceOf(*stroke, request.time);
        // The boxes of the segments overlap, and lie in that of the stroke.
        double parts = 0;
        for (const Segment &segment : stroke->segments)
            if (const Rect part = influenceOf(*stroke, segment, request.time); !part.isEmpty())
                parts += pixelsOf(inPixels(part, request.view), request.view);
        if (!box.isEmpty())
            seconds += secondsPerStrokePixel * std::min(parts, pixelsOf(inPixels(box, request.view), request.view));
    }
    return seconds;
}

} // namespace suffuse
