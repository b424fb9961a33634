#include "render/probe.h"

#include "model/paint/local_paint.h"
#include "model/painting/influence.h"
#include "render/reference/colour.h"
#include "render/reference/density.h"
#include "render/reference/stroke_source.h"
#include "render/reference/paper.h"

namespace suffuse {

namespace {

double densityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point x)
{
    const double s = segment.spread(time);
    if (!(segment.age(time) > 0) || !(s > 0) || !(segment.density > 0))
        return 0;
    const reference::Kernel kernel =
        segment.isIsotropic() ? reference::isotropicKernel(s)
                              : reference::anisotropicKernel(s, segment.anisotropyRatio, segment.anisotropyAngle);
    // Offsets from the stroke's origin lose no digits far from the corner of the canvas.
    Cubic cubic;
    for (std::size_t i = 0; i < 4; ++i)
        cubic.p[i] = Point{} + segment.bezier[i];
    return reference::segmentDensity(cubic, kernel, segment.density, x - stroke.origin).density;
}

reference::FillSample fillAt(const Stroke &stroke, Microseconds time, Point x)
{
    // As a picture of no size around the point, in which the spread has so many pixels that nothing is seen of them.
    Stroke spread = stroke;
    spread.fill = stroke.fill->spreading(time);
    const Fill &fill = *spread.fill;
    View view;
    view.centre = x;
    view.scale = 64 / (fill.spread(time) * std::sqrt(std::min(1.0, double(fill.anisotropyRatio))));
    return reference::FillSource(spread, time, view, reference::reachOf(spread, time)).at({});
}

ProbeStroke probeStroke(const Stroke &stroke, Microseconds time, Point x, double paper)
{
    ProbeStroke result;
    result.id = stroke.id;
    result.name = stroke.name;
    LocalPaint local;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double density = densityAt(stroke, segment, time, x);
        if (!(density > 0))
            continue;
        local.add(segment, stroke.styleOf(segment), density);
        result.shares.push_back({int(k), segment.lift, density, 0});
    }
    if (stroke.fill && stroke.fill->age(time) > 0 && stroke.fill->density > 0) {
        const reference::FillSample sample = fillAt(stroke, time, x);
        local.add(*stroke.fill, stroke.style, sample.density, sample.place);
        result.fillDensity = sample.density;
    }
    if (!(local.laid() > 0))
        return result;
    result.fillShare = result.fillDensity / local.laid();
    for (ProbeShare &share : result.shares)
        share.share = share.density / local.laid();
    result.density = local.density();
    result.lifted = local.lifted();
    result.granulation = local.granulation();
    result.modulated = modulation(local.granulation(), paper) * local.density();
    result.densityFunction = local.coverage(paper);
    result.colour = local.colour();
    result.opacity = local.opacity(paper);
    return result;
}

} // namespace

Result<Probe> probe(const Painting &painting, Microseconds time, double x, double y)
{
    auto texture = paperTexture(painting.canvas.paper);
    if (!texture)
        return Error{texture.error()};
    const Point point{x, y};
    Probe result;
    result.paper = reference::PaperField(painting.canvas.paper, *texture).at(point, 0);
    reference::Spot spot = reference::bareSpot(painting.canvas.background, false);
    result.rybBefore = spot.colour;
    result.rgbBefore = reference::rgbOfRyb(spot.colour);
    for (const StrokePtr &stroke : painting.strokes) {
        if (!painting.isVisible(*stroke))
            continue;
        ProbeStroke here = probeStroke(*stroke, time, point, result.paper);
        const bool inReach = influenceOf(*stroke, time).contains(point) && (here.density > 0 || here.lifted > 0);
        if (!inReach && !(here.opacity > 0))
            continue;
        reference::mix(spot, stroke->mix, {here.opacity, {here.colour[0], here.colour[1], here.colour[2]}});
        here.rybAfter = spot.colour;
        here.rgbAfter = reference::rgbOfRyb(spot.colour);
        result.strokes.push_back(std::move(here));
    }
    return result;
}

} // namespace suffuse
