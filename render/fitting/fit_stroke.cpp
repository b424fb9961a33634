#include "render/fitting/fit_stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse::fitting {

namespace {

constexpr double spreadsBeyond = 1; ///< that a stroke may lie beyond the picture

/// ξ2 from … to …, and the greatest peak, for each kind of style.
struct StyleRange {
    double leastSteepness, greatestSteepness, leastPeak, greatestPeak;
};

StyleRange rangeOf(StyleKind kind)
{
    switch (kind) {
    case StyleKind::Feathering:
        return {0.5, 8, 0.05, 60};
    case StyleKind::Uniform:
        return {0.02, 0.6, 0.5, 60};
    case StyleKind::Edge:
        break;
    }
    return {0.2, 1.2, 0.5, 60}; // ξ2 ≤ 2^(1/3) ξ1, so that the middle does not become negative
}

constexpr double edgeDepth = 0.8; // ξ3

} // namespace

double widthOf(const FitStroke &stroke, StyleKind style)
{
    const double s = std::exp(stroke[LogSpread]), peak = std::max(0.0, stroke[LogPeak]);
    const double soft = style == StyleKind::Feathering ? std::numbers::ln2 / std::exp(stroke[LogSteepness]) : 0.05;
    return 2 * s * std::sqrt(peak + soft);
}

void keepWithin(FitStroke &stroke, const FitLimits &limits)
{
    const StyleRange range = rangeOf(limits.style);
    stroke[LogSteepness] =
        std::clamp(stroke[LogSteepness], std::log(range.leastSteepness), std::log(range.greatestSteepness));
    stroke[LogPeak] = std::clamp(stroke[LogPeak], std::log(range.leastPeak), std::log(range.greatestPeak));
    for (const std::size_t colour : {Red, Yellow, Blue})
        stroke[colour] = std::clamp(stroke[colour], 0.0, 1.0);
    stroke[Opacity] = std::clamp(stroke[Opacity], -6.0, 6.0);
    double width = widthOf(stroke, limits.style);
    if (limits.greatestWidth > 0 && width > limits.greatestWidth)
        stroke[LogSpread] += std::log(limits.greatestWidth / width);
    else if (width < limits.leastWidth)
        stroke[LogSpread] += std::log(limits.leastWidth / width);
    stroke[LogSpread] = std::clamp(stroke[LogSpread], std::log(limits.leastSpread), std::log(limits.greatestSpread));
    if (limits.width <= 0)
        return;
    const double beyond = spreadsBeyond * std::exp(stroke[LogSpread]);
    for (std::size_t k = 0; k < std::size_t(2 * strokePoints); k += 2) {
        stroke[k] = std::clamp(stroke[k], -beyond, limits.width + beyond);
        stroke[k + 1] = std::clamp(stroke[k + 1], -beyond, limits.height + beyond);
    }
}

gradient::FlatScene sceneOf(const std::vector<FitStroke> &strokes, StyleKind style, const Colour &background,
                            const View &view)
{
    gradient::FlatScene scene;
    scene.view = view;
    scene.background[0] = double(background.red);
    scene.background[1] = double(background.yellow);
    scene.background[2] = double(background.blue);
    setNumbers(strokes, style, scene);
    return scene;
}

void setNumbers(const std::vector<FitStroke> &strokes, StyleKind style, gradient::FlatScene &scene)
{
    scene.strokes.resize(strokes.size());
    scene.segments.resize(strokes.size() * strokeCubics);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const FitStroke &n = strokes[i];
        gradient::FlatStroke &stroke = scene.strokes[i];
        stroke.first = std::uint32_t(i * strokeCubics);
        stroke.count = strokeCubics;
        stroke.kind = style;
        stroke.xi[0] = 1;
        stroke.xi[1] = std::exp(n[LogSteepness]);
        stroke.xi[2] = style == StyleKind::Edge ? edgeDepth : 0;
        stroke.oneColour = true;
        const double spread = std::exp(n[LogSpread]), density = std::exp(n[LogPeak]) * rootPi * spread;
        const double opacity = 1 / (1 + std::exp(-n[Opacity]));
        for (std::size_t k = 0; k < strokeCubics; ++k) {
            gradient::SegmentNumbers &segment = scene.segments[i * strokeCubics + k];
            for (std::size_t p = 0; p < 4; ++p) {
                segment.x[p] = n[2 * (3 * k + p)];
                segment.y[p] = n[2 * (3 * k + p) + 1];
            }
            segment.spread = spread;
            segment.density = density;
            for (std::size_t c = 0; c < 3; ++c)
                segment.colour[c] = n[Red + c];
            segment.opacity = opacity;
            segment.granulation = 1;
        }
    }
}

std::vector<StrokeSlope> slopesOf(const gradient::FlatGradient &by, const gradient::FlatScene &scene,
                                  const std::vector<FitStroke> &strokes)
{
    std::vector<StrokeSlope> out(strokes.size(), StrokeSlope{});
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        StrokeSlope &slope = out[i];
        const double steepness = scene.strokes[i].xi[1];
        slope[LogSteepness] = by.strokes[i].xi[1] * steepness;
        for (std::size_t k = 0; k < strokeCubics; ++k) {
            const gradient::SegmentNumbers &d = by.segments[i * strokeCubics + k],
                                           &at = scene.segments[i * strokeCubics + k];
            for (std::size_t p = 0; p < 4; ++p) {
                slope[2 * (3 * k + p)] += d.x[p];
                slope[2 * (3 * k + p) + 1] += d.y[p];
            }
            // s is moved at a constant peak, so that φˢ goes with it.
            slope[LogSpread] += d.spread * at.spread + d.density * at.density;
            slope[LogPeak] += d.density * at.density;
            for (std::size_t c = 0; c < 3; ++c)
                slope[Red + c] += d.colour[c];
            slope[Opacity] += d.opacity * at.opacity * (1 - at.opacity);
        }
    }
    return out;
}

} // namespace suffuse::fitting
