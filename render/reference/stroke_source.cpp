#include "render/reference/stroke_source.h"

#include "model/painting/influence.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace suffuse::reference {

namespace {

constexpr double leastReach = 6.5;
constexpr double greatestReach = 27.3; // e^−745 is the least double.
constexpr double thinPixels = 0.125;   // Thinner segments would need too many panels to keep them.

/// The curve in pixels. Subtracting in double before scaling loses no digits at deep zoom.
Cubic toPixels(const Stroke &stroke, const Segment &segment, const View &view)
{
    const Point d = stroke.origin - view.centre;
    const double c = std::cos(view.rotation), s = std::sin(view.rotation);
    Cubic cubic;
    for (std::size_t i = 0; i < 4; ++i) {
        Point p = d + segment.bezier[i];
        if (view.mirrored)
            p.x = -p.x;
        cubic.p[i] = {view.scale * (c * p.x - s * p.y) + 0.5 * view.width,
                      view.scale * (s * p.x + c * p.y) + 0.5 * view.height};
    }
    return cubic;
}

Kernel kernelInPixels(const Segment &segment, double spread, const View &view)
{
    const double s = spread * view.scale;
    if (segment.isIsotropic())
        return isotropicKernel(s);
    const double angle = segment.anisotropyAngle;
    const double turned = (view.mirrored ? std::numbers::pi - angle : angle) + view.rotation;
    return anisotropicKernel(s, segment.anisotropyRatio, turned);
}

bool isFilled(const Stroke &stroke, Microseconds time)
{
    return stroke.fill && stroke.fill->age(time) > 0 && stroke.fill->density > 0;
}

/// The kinds in the order of the enumeration, if the styles of segments differ; otherwise none.
std::vector<StyleKind> mixedKinds(const Stroke &stroke, Microseconds time)
{
    const Style *first = nullptr;
    bool differ = false;
    std::array<bool, 3> there{};
    for (const Segment &segment : stroke.segments) {
        if (segment.age(time) <= 0 || segment.takesPaint())
            continue;
        const Style &style = stroke.styleOf(segment);
        differ = differ || (first && !(*first == style));
        first = first ? first : &style;
        there[std::size_t(style.kind)] = true;
    }
    if (isFilled(stroke, time)) {
        differ = differ || (first && !(*first == stroke.style));
        there[std::size_t(stroke.style.kind)] = true;
    }
    std::vector<StyleKind> kinds;
    for (StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
        if (differ && there[std::size_t(kind)])
            kinds.push_back(kind);
    return kinds;
}

template <class Source>
std::vector<double> channelsOf(const Source &segment, const Style &style, const std::vector<StyleKind> &kinds)
{
    const Colour &c = segment.colour;
    std::vector<double> channels{segment.granulation, c.red, c.yellow, c.blue, c.opacity};
    for (StyleKind kind : kinds) {
        const bool own = kind == style.kind;
        channels.push_back(own ? 1 : 0);
        for (float xi : style.xi)
            channels.push_back(own ? double(xi) : 0);
    }
    return channels;
}

/// The smallest k ≤ 6 with s·2^k ≥ least; s is in pixels.
int levelOf(double s, double least)
{
    int k = 0;
    while (k < 6 && std::ldexp(s, k) < least)
        ++k;
    return k;
}

SegmentSource segmentSource(const Stroke &stroke, const Segment &segment, Microseconds time, const View &view,
                            const StrokeSource &whole)
{
    SegmentSource source;
    source.curve = toPixels(stroke, segment, view);
    source.kernel = kernelInPixels(segment, segment.spread(time), view);
    source.factor = double(segment.density) * view.scale * source.kernel.norm;
    source.reach = whole.reach * source.kernel.largerSpread;
    source.box = source.curve.controlBox().grown(source.reach);
    source.onTheFly = source.kernel.smallerSpread < thinPixels;
    source.channels = channelsOf(segment, stroke.styleOf(segment), whole.kinds);
    source.lifts = segment.lift;
    source.fades = segment.fade;
    if (source.factor > 0) // What adds nothing does not decide how others are sampled.
        source.level = levelOf(source.kernel.smallerSpread, segment.lift ? 4 : segment.fade ? 2 : 1);
    source.influence = influenceOf(stroke, segment, time);

    const Rect picture = Rect::of(0, 0, view.width, view.height).grown(source.reach);
    if (!source.onTheFly && source.factor > 0)
        appendPanels(
            source.curve, source.kernel, [&picture](const Rect &box) { return !box.intersects(picture); },
            source.panels);
    return source;
}

} // namespace

double reachOf(const Stroke &stroke, Microseconds time)
{
    double most = 0; // a bound of the density anywhere
    double least = std::numeric_limits<double>::infinity();
    for (const Segment &segment : stroke.segments) {
        if (segment.age(time) <= 0)
            continue;
        const Style &style = stroke.styleOf(segment);
        if (!segment.takesPaint())
            least = std::min(least, double(style.xi[0]));
        if (!segment.takesPaint() && style.kind == StyleKind::Uniform)
            least = std::min(least, double(style.xi[1]));
        const double s = segment.spread(time);
        const Kernel kernel =
            segment.isIsotropic() ? isotropicKernel(s) : anisotropicKernel(s, segment.anisotropyRatio, 0);
        most += double(segment.density) * kernel.norm * polygonLength(stroke.cubicOf(segment));
    }
    if (isFilled(stroke, time)) {
        most += double(stroke.fill->density);
        least = std::min(least, double(stroke.style.xi[0]));
        if (stroke.style.kind == StyleKind::Uniform)
            least = std::min(least, double(stroke.style.xi[1]));
    }
    if (!(most > 0))
        return leastReach;
    return std::clamp(std::sqrt(std::max(0.0, std::log(most / (1e-14 * least)))), leastReach, greatestReach);
}

StrokeSource strokeSource(const Stroke &stroke, Microseconds time, const View &view)
{
    StrokeSource source;
    source.mix = stroke.mix;
    source.style = stroke.style;
    source.kinds = mixedKinds(stroke, time);
    source.channels = FirstStyleChannel + 4 * source.kinds.size();
    source.reach = reachOf(stroke, time);
    if (stroke.picture) {
        source.picture = PictureField::of(stroke, view);
        if (!source.picture)
            return source;
    }
    bool lays = false;
    for (const Segment &segment : stroke.segments) {
        if (segment.age(time) <= 0)
            continue;
        if (!lays && !segment.takesPaint())
            source.style = stroke.styleOf(segment);
        lays = lays || !segment.takesPaint();
        source.segments.push_back(segmentSource(stroke, segment, time, view, source));
        source.box = source.box.united(source.segments.back().box);
    }
    if (isFilled(stroke, time)) {
        source.fill.emplace(stroke, time, view, source.reach);
        source.fill->setChannels(channelsOf(*stroke.fill, stroke.style, source.kinds));
        source.box = source.box.united(source.fill->box());
    }
    return source;
}

} // namespace suffuse::reference
