#include "render/fitting/fitted_painting.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse::fitting {

namespace {

constexpr float dryingTime = 0.5f;          ///< s, of each segment
constexpr Microseconds strokeTime = 90'000; ///< from one stroke to the next

/// Canvas units for each pixel of the target.
double unitOf(const FitTarget &target)
{
    return target.canvasWidth / target.picture.width;
}

Point pointOf(const FitStroke &stroke, std::size_t i, double unit)
{
    return {stroke[2 * i] * unit, stroke[2 * i + 1] * unit};
}

StrokePtr strokeOf(const FitStroke &n, const FittedStrokes &fitted, std::size_t number, double unit)
{
    const gradient::FlatScene scene = sceneOf({n}, fitted.style, fitted.background, {});
    Stroke stroke;
    stroke.id = StrokeId(number + 1);
    const std::size_t birth = fitted.births.empty() ? number : fitted.births[number];
    stroke.style.kind = fitted.style;
    for (std::size_t i = 0; i < 3; ++i)
        stroke.style.xi[i] = float(scene.strokes[0].xi[i]);
    const Point middle = pointOf(n, strokePoints / 2, unit);
    stroke.origin = {std::round(middle.x), std::round(middle.y)};
    for (std::size_t k = 0; k < strokeCubics; ++k) {
        const gradient::SegmentNumbers &from = scene.segments[k];
        Segment segment;
        for (std::size_t p = 0; p < 4; ++p) {
            const Point at = pointOf(n, 3 * k + p, unit);
            segment.bezier[p] = {float(at.x - stroke.origin.x), float(at.y - stroke.origin.y)};
        }
        const double spread = from.spread * unit;
        segment.diffusion = float(spread * spread / (4 * double(dryingTime)));
        segment.density = float(from.density * unit);
        segment.maxAge = dryingTime;
        segment.born = Microseconds(birth) * strokeTime + Microseconds(k) * (strokeTime / strokeCubics);
        segment.colour = {float(n[Red]), float(n[Yellow]), float(n[Blue]), float(from.opacity)};
        stroke.segments.push_back(std::move(segment));
    }
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// Why a fit cannot go on with a stroke; empty if it can.
QString problemOf(const Stroke &stroke, StyleKind style)
{
    const auto says = [](const char *text) { return QCoreApplication::translate("fitting", text); };
    if (stroke.fill || stroke.picture || stroke.hasErasure())
        return says("it has a fill, a picture, or segments that take paint away");
    if (stroke.segments.size() != strokeCubics)
        return says("it has not three segments");
    if (stroke.style.kind != style || stroke.mix.mode != MixMode::Alpha)
        return says("its style or its mixing is another one than that of the first stroke");
    const Segment &first = stroke.segments.front();
    for (const Segment &s : stroke.segments) {
        if (s.start || s.style || !s.isIsotropic() || !s.rewet.empty())
            return says("it has several chains, styles, tensors or re-wetting");
        if (s.colour != first.colour || s.diffusion != first.diffusion || s.maxAge != first.maxAge ||
            s.density != first.density)
            return says("its segments differ in colour, width or density");
    }
    return {};
}

FitStroke numbersOf(const Stroke &stroke, double unit)
{
    FitStroke out{};
    const Segment &first = stroke.segments.front();
    for (std::size_t k = 0; k < strokeCubics; ++k) {
        const Cubic cubic = stroke.cubicOf(stroke.segments[k]);
        for (std::size_t p = 0; p < 4; ++p) {
            out[2 * (3 * k + p)] = cubic.p[p].x / unit;
            out[2 * (3 * k + p) + 1] = cubic.p[p].y / unit;
        }
    }
    const double spread = std::sqrt(4 * double(first.diffusion) * double(first.maxAge));
    const double peak = double(first.density) / (rootPi * spread * double(stroke.style.xi[0]));
    out[LogSpread] = std::log(spread / unit);
    out[LogPeak] = std::log(std::max(peak, 1e-6));
    out[LogSteepness] = std::log(double(stroke.style.xi[1]) /
                                 (stroke.style.kind == StyleKind::Feathering ? 1 : double(stroke.style.xi[0])));
    out[Red] = double(first.colour.red), out[Yellow] = double(first.colour.yellow),
    out[Blue] = double(first.colour.blue);
    const double opacity = std::clamp(double(first.colour.opacity), 1e-3, 1 - 1e-3);
    out[Opacity] = std::log(opacity / (1 - opacity));
    return out;
}

} // namespace

Painting paintingOf(const FittedStrokes &fitted, const FitTarget &target, const std::vector<Colour> &paints)
{
    Painting out;
    out.canvas.width = target.canvasWidth;
    out.canvas.height = target.canvasHeight;
    out.canvas.background = fitted.background;
    std::vector<StrokePtr> strokes;
    strokes.reserve(fitted.strokes.size());
    for (std::size_t i = 0; i < fitted.strokes.size(); ++i)
        strokes.push_back(strokeOf(fitted.strokes[i], fitted, i, unitOf(target)));
    out.strokes = StrokeList(strokes.begin(), strokes.end());
    for (const Colour &paint : paints)
        out.swatches.push_back({QString(), paint, true});
    return out;
}

Result<FittedStrokes> fittedStrokesOf(const Painting &painting, const FitTarget &target)
{
    FittedStrokes out;
    out.background = painting.canvas.background;
    if (painting.canvas.width != target.canvasWidth || painting.canvas.height != target.canvasHeight)
        return Error{QCoreApplication::translate("fitting",
                                                 "its canvas has %1 × %2 units, and the picture %3 × %4 pixels; "
                                                 "go on with a painting that was fitted to this picture")
                         .arg(painting.canvas.width)
                         .arg(painting.canvas.height)
                         .arg(target.canvasWidth)
                         .arg(target.canvasHeight)};
    for (const StrokePtr &stroke : painting.strokes) {
        if (out.strokes.empty())
            out.style = stroke->style.kind;
        if (const QString problem = problemOf(*stroke, out.style); !problem.isEmpty())
            return Error{QCoreApplication::translate("fitting", "stroke %1: %2; a fit goes on with what a fit made")
                             .arg(stroke->id)
                             .arg(problem)};
        out.strokes.push_back(numbersOf(*stroke, unitOf(target)));
    }
    return out;
}

} // namespace suffuse::fitting
