#include "render/probe.h"

#include "model/painting/influence.h"
#include "render/reference/density.h"
#include "render/reference/local_paint.h"
#include "render/reference/paper.h"

namespace suffuse {

namespace {

using reference::LocalDensity;

double densityAt(const Stroke &stroke, const Segment &segment, Microseconds time, Point x)
{
    const double s = segment.spread(time);
    if (!(segment.age(time) > 0) || !(s > 0) || !(segment.density > 0))
        return 0;
    const reference::Kernel kernel =
        segment.isIsotropic() ? reference::isotropicKernel(s)
                              : reference::anisotropicKernel(s, segment.anisotropyRatio, segment.anisotropyAngle);
    // Offsets from the stroke's origin, so that far from the canvas' corner nothing is lost.
    Cubic cubic;
    for (std::size_t i = 0; i < 4; ++i)
        cubic.p[i] = Point{} + segment.bezier[i];
    return reference::segmentDensity(cubic, kernel, segment.density, x - stroke.origin).density;
}

/// Adds a segment of density φ_k to the means; divided by φ later.
void addSegment(LocalDensity &local, const Segment &segment, const Style &style, double density)
{
    local.density += density;
    local.granulation += density * double(segment.granulation);
    const Colour &c = segment.colour;
    const std::array<double, 4> colour{c.red, c.yellow, c.blue, c.opacity};
    for (std::size_t i = 0; i < 4; ++i)
        local.colour[i] += density * colour[i];
    int n = 0;
    while (n < local.styleCount && local.styles[std::size_t(n)].kind != style.kind)
        ++n;
    if (n == local.styleCount)
        local.styles[std::size_t(local.styleCount++)] = {style.kind, 0, {}};
    local.styles[std::size_t(n)].share += density;
    for (std::size_t i = 0; i < 3; ++i)
        local.styles[std::size_t(n)].xi[i] += density * double(style.xi[i]);
}

void divideByDensity(LocalDensity &local)
{
    local.granulation /= local.density;
    for (double &c : local.colour)
        c /= local.density;
    for (auto &style : local.styles) {
        for (double &xi : style.xi)
            xi = style.share > 0 ? xi / style.share : 0;
        style.share /= local.density;
    }
}

ProbeStroke probeStroke(const Stroke &stroke, Microseconds time, Point x, double paper)
{
    ProbeStroke result;
    result.id = stroke.id;
    result.name = stroke.name;
    LocalDensity local;
    local.granulation = 0;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const double density = densityAt(stroke, segment, time, x);
        if (!(density > 0))
            continue;
        addSegment(local, segment, stroke.styleOf(segment), density);
        result.shares.push_back({int(k), density, 0});
    }
    if (!(local.density > 0))
        return result;
    divideByDensity(local);
    for (ProbeShare &share : result.shares)
        share.share = share.density / local.density;
    result.density = local.density;
    result.granulation = local.granulation;
    result.modulated = reference::modulation(local.granulation, paper) * local.density;
    result.densityFunction = reference::localDensityFunction(local, paper, 0);
    result.colour = local.colour;
    result.opacity = result.densityFunction * local.colour[3];
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
        const bool inReach = influenceOf(*stroke, time).contains(point) && here.density > 0;
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
