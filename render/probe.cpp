#include "render/probe.h"

#include "model/paint/local_paint.h"
#include "model/painting/influence.h"
#include "render/composition/composition.h"
#include "render/reference/colour.h"
#include "render/reference/compositing.h"
#include "render/reference/density.h"
#include "render/reference/paper.h"
#include "render/reference/stroke_source.h"

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

/// Mixes the items of a painting at the point, from bottom to top, with the share that each stroke has.
class Mixer {
public:
    Mixer(const Painting &painting, Microseconds time, Point point, Probe &result)
        : m_time(time), m_point(point), m_result(result)
    {
        for (const StrokePtr &stroke : painting.strokes)
            if (painting.isVisible(*stroke))
                m_strokes.push_back(stroke.get());
    }

    /// `canvas`: as for reference::put. The shares of strokes from `first` on, and `bare`, are those of the colour in
    /// `spot` and of what lies below all; they need not sum up to 1.
    void mix(const std::vector<reference::Item> &items, const reference::Rgb *canvas, reference::Spot &spot,
             double &bare)
    {
        const std::size_t first = m_result.strokes.size();
        const auto letThrough = [&](std::size_t last, double share) {
            for (std::size_t i = first; i < last; ++i)
                m_result.strokes[i].colourShare *= share;
            bare *= share;
        };
        for (const reference::Item &item : items) {
            const std::size_t own = m_result.strokes.size();
            if (!item.isGroup) {
                const Stroke &stroke = *m_strokes[item.stroke];
                if (!add(stroke, spot))
                    continue;
                ProbeStroke &here = m_result.strokes.back();
                letThrough(own,
                           1 - here.opacity * (1 - (stroke.mix.mode == MixMode::Beta ? double(stroke.mix.beta) : 0)));
                here.colourShare = here.opacity;
                continue;
            }
            reference::Spot layer;
            double nothing = 1;
            mix(item.inside, nullptr, layer, nothing);
            const double source = layer.coverage * item.opacity;
            switch (item.blend) {
            case BlendMode::DestinationIn:
                letThroughOver(own, source, 0, letThrough, bare);
                break;
            case BlendMode::DestinationOut:
                letThroughOver(own, 1 - source, 0, letThrough, bare);
                break;
            case BlendMode::Plus:
                letThroughOver(own, 1, item.opacity, letThrough, bare);
                break;
            case BlendMode::SourceAtop:
                letThroughOver(own, 1 - source * spot.coverage, item.opacity * spot.coverage, letThrough, bare);
                break;
            default:
                letThroughOver(own, 1 - source, item.opacity, letThrough, bare);
            }
            reference::put(item, layer, canvas, spot);
        }
    }

private:
    /// Adds a stroke. Returns false if it does not reach the point.
    bool add(const Stroke &stroke, reference::Spot &spot)
    {
        ProbeStroke here = probeStroke(stroke, m_time, m_point, m_result.paper);
        const bool inReach = influenceOf(stroke, m_time).contains(m_point) && (here.density > 0 || here.lifted > 0);
        if (!inReach && !(here.opacity > 0))
            return false;
        reference::mix(spot, stroke.mix, {here.opacity, {here.colour[0], here.colour[1], here.colour[2]}});
        here.rybAfter = spot.colour;
        here.rgbAfter = reference::rgbOfRyb(spot.colour);
        m_result.strokes.push_back(std::move(here));
        return true;
    }

    /// What lies below strokes from `own` on keeps a share `below`, and theirs become `above` times as large. What is
    /// taken away below shows the canvas.
    template <class LetThrough>
    void letThroughOver(std::size_t own, double below, double above, LetThrough letThrough, double &bare)
    {
        for (std::size_t i = own; i < m_result.strokes.size(); ++i)
            m_result.strokes[i].colourShare *= above;
        letThrough(own, below);
        if (above == 0)
            bare += 1 - below;
    }

    std::vector<const Stroke *> m_strokes; ///< the visible ones
    Microseconds m_time;
    Point m_point;
    Probe &m_result;
};

} // namespace

Painting reaching(const Painting &painting, Microseconds time, Point point)
{
    if (!compositionOf(painting).everywhere.empty())
        return painting;
    Painting near = painting;
    near.strokes.clear();
    for (const StrokePtr &stroke : painting.strokes)
        if (influenceOf(*stroke, time).contains(point))
            near.strokes.push_back(stroke);
    return near;
}

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
    spot.coverage = 0; // The canvas is no paint.
    double bare = 1;
    Mixer(painting, time, point, result).mix(reference::itemsOf(painting), &result.rgbBefore, spot, bare);
    result.rybAfter = spot.colour;
    result.rgbAfter = reference::rgbOfRyb(spot.colour);
    double sum = bare;
    for (const ProbeStroke &stroke : result.strokes)
        sum += stroke.colourShare;
    for (ProbeStroke &stroke : result.strokes)
        stroke.colourShare /= sum;
    result.canvasShare = bare / sum;
    return result;
}

} // namespace suffuse
