#include "render/probe.h"

#include "model/paint/local_paint.h"
#include "model/painting/influence.h"
#include "render/composition/composition.h"
#include "render/reference/colour.h"
#include "render/reference/compositing.h"
#include "render/reference/density.h"
#include "render/reference/paper.h"
#include "render/reference/picture.h"
#include "render/reference/stroke_source.h"

#include <algorithm>

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

/// What a stroke shows of its picture at the point: nothing if that is missing.
reference::Paint shownOf(const Stroke &stroke, Point x, const ProbeStroke &own)
{
    View view; // in which the picture's pixels are as large as can be
    view.scale = 1e9;
    const auto picture = reference::PictureField::of(stroke, view);
    return picture ? picture->shownAt(x, {own.opacity, {}}) : reference::Paint();
}

/// What strokes are at the point that are drawn as `drawn`, as if they were one: an entry for each, in which the shares
/// are those of its own segments. Most strokes are drawn alone.
std::vector<ProbeStroke> probeStrokes(const reference::Drawing::Drawn &drawn, Microseconds time, Point x, double paper)
{
    const Stroke &stroke = *drawn.stroke;
    std::vector<ProbeStroke> all;
    LocalPaint local;
    std::size_t next = 0; // the segment of the drawn stroke
    for (const StrokePtr &member : drawn.members) {
        ProbeStroke &own = all.emplace_back();
        own.id = member->id, own.name = member->name;
        for (std::size_t k = 0; k < member->segments.size(); ++k, ++next) {
            const Segment &segment = stroke.segments[next];
            const double density = densityAt(stroke, segment, time, x);
            if (!(density > 0))
                continue;
            local.add(segment, stroke.styleOf(segment), density);
            own.shares.push_back({int(k), segment.lift, segment.fade, density, 0});
        }
    }
    ProbeStroke result;
    if (stroke.fill && stroke.fill->age(time) > 0 && stroke.fill->density > 0) {
        const reference::FillSample sample = fillAt(stroke, time, x);
        local.add(*stroke.fill, stroke.style, sample.density, sample.place);
        result.fillDensity = sample.density;
    }
    if (!(local.laid() > 0))
        return all;
    result.fillShare = result.fillDensity / local.laid();
    result.density = local.density();
    result.lifted = local.lifted();
    result.faded = local.faded();
    result.granulation = local.granulation();
    result.modulated = modulation(local.granulation(), paper) * local.density();
    result.densityFunction = local.coverage(paper);
    result.colour = local.colour();
    result.opacity = local.opacity(paper);
    if (stroke.picture) {
        const reference::Paint paint = shownOf(stroke, x, result);
        result.opacity = paint.opacity;
        std::ranges::copy(paint.colour, result.colour.begin());
    }
    for (ProbeStroke &own : all) {
        result.id = own.id, result.name = own.name;
        for (ProbeShare &share : own.shares)
            share.share = share.fades ? 0 : share.density / local.laid();
        result.shares = std::move(own.shares);
        own = result;
    }
    return all;
}

/// How much of the paint that strokes lay together is one's own.
double partOf(const ProbeStroke &stroke)
{
    double part = stroke.fillShare;
    for (const ProbeShare &share : stroke.shares)
        part += share.lifts || share.fades ? 0 : share.share;
    return part;
}

/// Mixes the items of a painting at the point, from bottom to top, with the share that each stroke has.
class Mixer {
public:
    Mixer(const reference::Drawing &drawing, Microseconds time, Point point, double paper)
        : m_drawing(drawing), m_time(time), m_point(point), m_paper(paper)
    {}

    /// The strokes that were mixed, from bottom to top.
    std::vector<ProbeStroke> &strokes() { return m_strokes; }

    /// `canvas`: as for reference::put. The shares of strokes from those on that are mixed here, and `bare`, are those
    /// of the colour in `spot` and of what lies below all; they need not sum up to 1.
    void mix(const std::vector<reference::Item> &items, const reference::Rgb *canvas, reference::Spot &spot,
             double &bare)
    {
        const std::size_t first = m_strokes.size();
        for (std::size_t i = 0; i < items.size(); ++i)
            if (!items[i].isMask)
                mixItem(items, i, canvas, spot, {first, bare});
    }

private:
    /// What lies below: the strokes from `first` on, and the share of what was there before them.
    struct Below {
        std::size_t first;
        double &bare;
    };

    void mixItem(const std::vector<reference::Item> &items, std::size_t place, const reference::Rgb *canvas,
                 reference::Spot &spot, const Below &below)
    {
        const reference::Item &item = items[place];
        const std::size_t own = m_strokes.size();
        if (!item.isGroup) {
            if (item.stroke != reference::Item::nothing)
                addStroke(m_drawing.strokes[item.stroke], spot, below);
            return;
        }
        if (!item.isIsolated) {
            for (std::size_t i = 0; i < item.inside.size(); ++i)
                if (!item.inside[i].isMask)
                    mixItem(item.inside, i, canvas, spot, below);
            return;
        }
        reference::Spot layer;
        double nothing = 1, share = 1;
        if (item.base != reference::Item::nothing)
            share *= coverageOf(items, item.base);
        for (std::size_t i = 0; i < item.inside.size(); ++i)
            if (item.inside[i].isMask && item.inside[i].isSeen())
                share *= coverageOf(item.inside, i);
        mix(item.inside, nullptr, layer, nothing);
        const double opacity = item.opacity * share, source = layer.coverage * opacity;
        switch (item.blend) {
        case BlendMode::DestinationIn:
            putOver(own, source, 0, below);
            break;
        case BlendMode::DestinationOut:
            putOver(own, 1 - source, 0, below);
            break;
        case BlendMode::Plus:
            putOver(own, 1, opacity, below);
            break;
        case BlendMode::SourceAtop:
            putOver(own, 1 - source * spot.coverage, opacity * spot.coverage, below);
            break;
        default:
            putOver(own, 1 - source, opacity, below);
        }
        reference::put(item, share, layer, canvas, spot);
    }

    /// Adds strokes that are drawn as one, if they reach the point.
    void addStroke(const reference::Drawing::Drawn &drawn, reference::Spot &spot, const Below &below)
    {
        const std::size_t own = m_strokes.size();
        std::vector<ProbeStroke> all = probeStrokes(drawn, m_time, m_point, m_paper);
        const ProbeStroke &any = all.front();
        const Mix &how = drawn.stroke->mix;
        const double opacity = any.opacity;
        if (any.density > 0 || any.lifted > 0 || opacity > 0)
            reference::mix(spot, how, {opacity, {any.colour[0], any.colour[1], any.colour[2]}});
        for (std::size_t i = 0; i < all.size(); ++i) {
            ProbeStroke &here = all[i];
            const bool inReach =
                influenceOf(*drawn.members[i], m_time).contains(m_point) && (here.density > 0 || here.lifted > 0);
            const double part = drawn.members.size() > 1 ? partOf(here) : 1;
            if (!inReach && !(opacity * part > 0))
                continue;
            here.rybAfter = spot.colour;
            here.rgbAfter = reference::rgbOfRyb(spot.colour);
            here.colourShare = opacity * part;
            m_strokes.push_back(std::move(here));
        }
        letThrough(own, 1 - opacity * (1 - (how.mode == MixMode::Beta ? double(how.beta) : 0)), below);
    }

    void letThrough(std::size_t last, double share, const Below &below)
    {
        for (std::size_t i = below.first; i < last; ++i)
            m_strokes[i].colourShare *= share;
        below.bare *= share;
    }

    /// What lies below strokes from `own` on keeps a share `kept`, and theirs become `above` times as large. What is
    /// taken away below shows the canvas.
    void putOver(std::size_t own, double kept, double above, const Below &below)
    {
        for (std::size_t i = own; i < m_strokes.size(); ++i)
            m_strokes[i].colourShare *= above;
        letThrough(own, kept, below);
        if (above == 0)
            below.bare += 1 - kept;
    }

    /// What an item covers by itself.
    double coverageOf(const std::vector<reference::Item> &items, std::size_t place) const
    {
        Mixer alone(m_drawing, m_time, m_point, m_paper);
        std::vector<reference::Item> copy(items);
        copy[place].blend = BlendMode::Normal;
        reference::Spot spot;
        double bare = 1;
        alone.mixItem(copy, place, nullptr, spot, {0, bare});
        return spot.coverage;
    }

    const reference::Drawing &m_drawing;
    Microseconds m_time;
    Point m_point;
    double m_paper;
    std::vector<ProbeStroke> m_strokes;
};

} // namespace

Painting reaching(const Painting &painting, Microseconds time, Point point)
{
    // What is clipped to strokes, or masked by them, must know of them where they are not, too.
    if (const Composition composition = compositionOf(painting);
        !composition.everywhere.empty() || composition.isBounded)
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
    const reference::Drawing drawing = reference::drawingOf(painting);
    Mixer mixer(drawing, time, point, result.paper);
    mixer.mix(drawing.items, &result.rgbBefore, spot, bare);
    result.strokes = std::move(mixer.strokes());
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
