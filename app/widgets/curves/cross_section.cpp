#include "app/widgets/curves/cross_section.h"

#include "model/paint/half_width.h"
#include "model/paint/local_paint.h"
#include "model/paint/point_density.h"
#include "model/painting/influence.h"
#include "render/reference/colour.h"

#include <algorithm>

namespace suffuse {

std::vector<CrossSectionPoint> crossSectionOf(const Painting &painting, const Stroke &stroke, int segment,
                                              Microseconds time, int samples)
{
    const Segment &middle = stroke.segments[std::size_t(segment)];
    const double age = middle.age(time);
    if (!(age > 0))
        return {};
    const Cubic cubic = stroke.cubicOf(middle);
    const Point tangent = tangentAt(cubic, 0.5), normal{-tangent.y, tangent.x};
    const double across = diffusionAcross(middle, tangent);
    const double w = halfWidth(across, double(middle.density), age, visibleCut(stroke.styleOf(middle)));
    const double range = std::max(1.5 * w, 2 * spreadAt(across, age));

    const Point from = cubic.at(0.5) - range * normal, to = cubic.at(0.5) + range * normal;
    Rect line;
    line.include(from);
    line.include(to);
    struct Near {
        const Segment *segment;
        DensityOfSegment density;
    };
    std::vector<Near> near;
    for (const Segment &s : stroke.segments)
        if (influenceOf(stroke, s, time).intersects(line))
            near.push_back({&s, DensityOfSegment(s, s.spread(time), CurveDetail::Fine)});

    const reference::Spot ground = reference::bareSpot(painting.canvas.background, false);
    std::vector<CrossSectionPoint> points;
    for (int i = 0; i < samples; ++i) {
        CrossSectionPoint point;
        point.offset = range * (2.0 * i / (samples - 1) - 1);
        const Point fromOrigin = cubic.at(0.5) + point.offset * normal - stroke.origin;
        LocalPaint paint;
        for (const Near &s : near)
            if (const double d = s.density(fromOrigin); d > 0)
                paint.add(*s.segment, stroke.styleOf(*s.segment), d);
        const std::array<double, 4> colour = paint.colour();
        point.density = paint.density();
        point.opacity = paint.opacity(1);
        reference::Spot spot = ground;
        reference::mix(spot, stroke.mix, {point.opacity, {colour[0], colour[1], colour[2]}});
        point.rgb = reference::rgbOfRyb(spot.colour);
        points.push_back(point);
    }
    return points;
}

} // namespace suffuse
