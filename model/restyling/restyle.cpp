#include "model/restyling/restyle.h"

#include "model/area/outline.h"
#include "model/brush/brush_dynamics.h"
#include "model/brush/brush_width.h"
#include "model/brush/stroke_fit.h"
#include "model/paint/half_width.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"
#include "model/shaping/nodes/reshape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse {

namespace {

constexpr int mostBrushParts = 64;              ///< of one segment
constexpr std::size_t mostBrushSplits = 50'000; ///< of a stroke

/// Whether what the brush lays down is another from place to place, also where the pen does the same.
bool variesAlong(const Brush &brush)
{
    const auto varies = [](const BrushDynamic &d) {
        return d.input == BrushInput::Distance || d.input == BrushInput::Drift;
    };
    return brush.taper.in > 0 || brush.taper.out > 0 || brush.jitter.along ||
           (brush.tip.ratio != 1 && brush.tip.followsPath) || std::ranges::any_of(brush.dynamics, varies);
}

/// With segments that are short enough for the brush.
Stroke splitFor(const Stroke &stroke, const Brush &brush, const std::vector<bool> &chosen, std::vector<int> &sources)
{
    const double longest = 0.5 * brush.spread();
    std::vector<CurvePlace> cuts;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const double length = arcLength(stroke.cubicOf(stroke.segments[k]));
        const bool isMeant = (chosen.empty() || chosen[k]) && !stroke.segments[k].takesPaint();
        const int parts = isMeant ? int(std::clamp(std::ceil(length / longest), 1.0, double(mostBrushParts))) : 1;
        for (int i = 1; i < parts; ++i)
            cuts.push_back({int(k), double(i) / parts});
    }
    if (!cuts.empty() && cuts.size() <= mostBrushSplits)
        return withNodes(stroke, cuts, &sources);
    sources.resize(stroke.segments.size());
    std::iota(sources.begin(), sources.end(), 0);
    return stroke;
}

/// What the brush lays down at a place of the stroke, with its tapering.
Paint paintOf(const Brush &brush, const RememberedPen &pen, StrokeId seed)
{
    const double spread = brush.spread(), length = (pen.distance + pen.rest) / spread;
    Paint paint = paintAt(brush, {pen.pressure, 0, pen.speed / spread, pen.distance / spread}, seed);
    Taper taper = brush.taper;
    taper.tip = float(std::lerp(1.0, double(taper.tip), std::min(1.0, 0.5 * length))); // as the builder does
    paint.size *= taperAt(taper, pen.distance / spread, pen.rest / spread);
    paint.size = std::clamp(paint.size, leastSize, 1.0);
    return paint;
}

/// D that gives the spread of another segment in this one's time.
float diffusionFor(const Segment &segment, const Segment &like)
{
    return float(double(like.diffusion) * double(like.maxAge) / double(segment.maxAge));
}

Segment takeForm(const Segment &segment, const Segment &painted)
{
    Segment result = segment;
    result.diffusion = diffusionFor(segment, painted);
    result.density = painted.density;
    result.anisotropyRatio = painted.anisotropyRatio;
    result.anisotropyAngle = painted.anisotropyAngle;
    return result;
}

Segment takeTexture(const Segment &segment, const Segment &painted, double densityFactor)
{
    Segment result = segment;
    result.granulation = painted.granulation;
    result.maxAge = painted.maxAge;
    result.diffusion = diffusionFor(painted, segment);
    result.density = float(double(segment.density) * densityFactor);
    return result;
}

Segment takeAll(const Segment &segment, const Segment &painted)
{
    Segment result = takeForm(takeTexture(segment, painted, 1), painted);
    result.diffusion = painted.diffusion;
    result.colour = painted.colour;
    return result;
}

Segment taken(const Segment &segment, const Segment &painted, const Restyle &how)
{
    switch (how.part) {
    case BrushPart::Whole:
        return takeAll(segment, painted);
    case BrushPart::Form:
        return takeForm(segment, painted);
    case BrushPart::Texture:
        // A style judges densities, so they are brought to those that the brush's style is made for.
        return takeTexture(segment, painted,
                           how.strongest.peak > 0 ? double(how.brush.peak) / how.strongest.peak : 1.0);
    case BrushPart::Colour:
        break;
    }
    Segment result = segment;
    result.colour = painted.colour;
    return result;
}

/// Style, mixing and name; those of a part of the stroke are its segments' own, as far as segments have them.
void takeStyle(Stroke &stroke, const Restyle &how, const std::vector<bool> &meant, bool whole)
{
    if (how.part != BrushPart::Whole && how.part != BrushPart::Texture)
        return;
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        if (meant[k]) {
            if (whole)
                stroke.segments[k].style.reset();
            else
                stroke.segments[k].style = how.brush.style;
        }
    if (!whole)
        return;
    stroke.style = how.brush.style;
    stroke.mix = how.brush.mix;
    if (how.part == BrushPart::Whole)
        stroke.brush = how.brush.name;
}

/// What a fill takes of the brush; when, where and in which shape it is stays.
Fill filledBy(const Fill &fill, const Style &style, const Restyle &how)
{
    const Segment laid = valuesAtFullPressure(how.brush);
    const bool whole = how.part == BrushPart::Whole;
    Fill result = fill;
    if (whole || how.part == BrushPart::Texture) {
        result.granulation = laid.granulation;
        result.maxAge = laid.maxAge;
        result.diffusion = float(double(fill.diffusion) * double(fill.maxAge) / double(laid.maxAge)); // as wide as it was
        const double before = visibleCut(style), after = visibleCut(how.brush.style);
        if (before > 0 && after > 0) // as dense to the eye as it was
            result.density = float(double(fill.density) * after / before);
    }
    if (whole || how.part == BrushPart::Form)
        result.diffusion = float(double(laid.diffusion) * double(laid.maxAge) / double(result.maxAge));
    if (whole || how.part == BrushPart::Colour) {
        result.colour = laid.colour;
        result.gradient.reset();
    }
    return result;
}

} // namespace

Stroke restyled(const Stroke &stroke, const Restyle &how, const std::vector<bool> &chosen, std::vector<int> *sources)
{
    std::vector<int> origins(stroke.segments.size());
    std::iota(origins.begin(), origins.end(), 0);
    const bool splits = how.part != BrushPart::Texture && variesAlong(how.brush) && !isFillAlone(stroke);
    Stroke result = splits ? splitFor(stroke, how.brush, chosen, origins) : stroke;
    const std::vector<RememberedPen> pens = penOf(result, how.painted, how.strongest);
    std::vector<bool> meant;
    std::vector<Segment> painted;
    double widest = 0;
    for (std::size_t k = 0; k < result.segments.size(); ++k) {
        const Segment &segment = result.segments[k];
        meant.push_back((chosen.empty() || chosen[std::size_t(origins[k])]) && !segment.takesPaint());
        Segment laid;
        setPaint(laid, how.brush, paintOf(how.brush, pens[k], stroke.id), tangentAt(result.cubicOf(segment), 0.5));
        widest = std::max(widest, spreadAt(laid.diffusion, laid.maxAge));
        painted.push_back(std::move(laid));
    }
    const double length = pens.back().distance + pens.back().rest;
    const double raise = length > 0 ? shortStrokeRaise(length, widest) : 1;
    for (std::size_t k = 0; k < result.segments.size(); ++k) {
        painted[k].density = float(std::min(1e12, double(painted[k].density) * raise));
        Segment next = taken(result.segments[k], painted[k], how);
        if (onlyBounds(result, k))
            next.density = 0;
        if (meant[k] && problemOf(next).isEmpty())
            result.segments[k] = std::move(next);
    }
    const auto lays = [&](std::size_t k) { return meant[k] && !onlyBounds(result, k); };
    bool meansFill = bool(stroke.fill);
    for (std::size_t k = 0; k < meant.size() && !chosen.empty(); ++k)
        meansFill = meansFill && !lays(k);
    if (meansFill)
        result.fill = filledBy(*stroke.fill, stroke.style, how);
    takeStyle(result, how, meant, chosen.empty());
    if (sources)
        *sources = std::move(origins);
    return problemOf(result).isEmpty() ? result : stroke;
}

} // namespace suffuse
