#include "render/parallel.h"
#include "tests/bench/baselines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse::baseline {

namespace {

struct Rule {
    double x[8]; ///< on [0, 1]
    double weight[8];
};

/// Gauss-Legendre points by Newton's iteration on the Legendre polynomial.
Rule gaussRule(int n)
{
    Rule rule{};
    for (int i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 50; ++step) {
            double before = 1, value = x;
            for (int k = 2; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
                before = value;
                value = next;
            }
            slope = n * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        rule.x[i] = 0.5 * (1 - x);
        rule.weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

/// A segment in pixels.
struct Source {
    double x = 0, y = 0; ///< midpoint
    double reach = 0;
    float scale = 0; ///< √(log₂e)/s
    float nodeX[8];
    float nodeY[8];
    float exponent[8]; ///< log₂ of the node's density
    float colour[4];
};

struct SourceStroke {
    StrokeShade shade;
    std::vector<Source> sources;
    Rect reach; ///< of all of them
};

Source sourceOf(const Stroke &stroke, const Segment &segment, const RenderRequest &request, const Rule &rule, int nodes)
{
    const View &view = request.view;
    const Cubic cubic = stroke.cubicOf(segment);
    const double s = segment.spread(request.time) * view.scale;
    Source out;
    double length = 0;
    for (int i = 0; i < nodes; ++i) {
        const Point p = view.toPixels(cubic.at(rule.x[i]));
        const double step = rule.weight[i] * suffuse::length(cubic.derivative(rule.x[i])) * view.scale;
        length += step;
        const double density = double(segment.density) * view.scale * step / (std::numbers::pi * s * s);
        out.nodeX[i] = float(p.x);
        out.nodeY[i] = float(p.y);
        out.exponent[i] = float(std::log2(std::max(density, 1e-30)));
    }
    const Point middle = view.toPixels(cubic.at(0.5));
    out.x = middle.x;
    out.y = middle.y;
    out.reach = 0.5 * length + 0.1 * view.width;
    out.scale = float(std::sqrt(std::numbers::log2e) / s);
    const Colour &c = segment.colour;
    const float colour[] = {c.red, c.yellow, c.blue, c.opacity};
    std::copy(colour, colour + 4, out.colour);
    return out;
}

SourceStroke sourcesOf(const Stroke &stroke, const RenderRequest &request, const Rule &rule, int nodes)
{
    SourceStroke out;
    out.shade = shadeOf(stroke);
    for (const Segment &segment : stroke.segments) {
        if (segment.spread(request.time) <= 0)
            continue;
        const Source source = sourceOf(stroke, segment, request, rule, nodes);
        out.reach = out.reach.united(
            Rect::of(source.x - source.reach, source.y - source.reach, 2 * source.reach, 2 * source.reach));
        out.sources.push_back(source);
    }
    return out;
}

/// Pixels of the row within the segment's reach; none: first = last.
RowQuadrature onRow(const Source &source, int row, int width, int nodes)
{
    RowQuadrature out;
    const double dy = row + 0.5 - source.y, square = source.reach * source.reach - dy * dy;
    if (square <= 0)
        return out;
    const double half = std::sqrt(square);
    out.first = std::clamp(int(std::ceil(source.x - half - 0.5)), 0, width);
    out.last = std::clamp(int(std::floor(source.x + half - 0.5)) + 1, out.first, width);
    out.nodes = nodes;
    out.scale = source.scale;
    for (int i = 0; i < nodes; ++i) {
        const float across = source.scale * (float(row) + 0.5f - source.nodeY[i]);
        out.offset[i] = -source.scale * source.nodeX[i];
        out.exponent[i] = source.exponent[i] - across * across;
    }
    return out;
}

void drawRow(const std::vector<SourceStroke> &strokes, const RenderRequest &request, int row, int nodes, float *rgba)
{
    const int width = request.view.width;
    const BaselineKernels &kernels = baselineKernels();
    RowPlanes backdrop = backgroundRow(request.painting->canvas, width);
    RowPlanes sums(sumPlanes, width);
    for (const SourceStroke &stroke : strokes) {
        if (stroke.reach.isEmpty() || row + 0.5 < stroke.reach.top || row + 0.5 > stroke.reach.bottom)
            continue;
        const int first = std::clamp(int(stroke.reach.left), 0, width);
        const int last = std::clamp(int(stroke.reach.right) + 1, first, width);
        for (int plane = 0; plane < (stroke.shade.varies ? sumPlanes : 1); ++plane)
            std::fill(sums.plane[std::size_t(plane)] + first, sums.plane[std::size_t(plane)] + last + padding, 0.0f);
        for (const Source &source : stroke.sources) {
            const RowQuadrature quadrature = onRow(source, row, width, nodes);
            if (quadrature.first < quadrature.last)
                kernels.addSegment(quadrature, stroke.shade.varies ? source.colour : nullptr, sums.plane.data());
        }
        kernels.mixStroke(stroke.shade, sums.plane.data(), first, last, backdrop.plane.data());
    }
    kernels.finishRow(backdrop.plane.data(), width, rgba);
}

} // namespace

StrokeShade shadeOf(const Stroke &stroke)
{
    StrokeShade out;
    out.style = stroke.style;
    out.colour = stroke.segments.front().colour;
    for (const Segment &s : stroke.segments)
        out.varies = out.varies || !(s.colour == out.colour);
    out.keep = stroke.mix.mode == MixMode::Beta ? 1 - stroke.mix.beta : 1;
    return out;
}

RowPlanes backgroundRow(const Canvas &canvas, int width)
{
    RowPlanes out(3, width);
    const Colour &c = canvas.background;
    const float ryb[] = {c.red * c.opacity, c.yellow * c.opacity, c.blue * c.opacity};
    for (std::size_t i = 0; i < 3; ++i)
        std::fill(out.plane[i], out.plane[i] + width + padding, ryb[i]);
    return out;
}

std::vector<float> paperMethod(const RenderRequest &request, int nodes, int threads)
{
    const int width = request.view.width, height = request.view.height;
    nodes = nodes == 5 ? 5 : 8;
    const Rule rule = gaussRule(nodes);
    std::vector<SourceStroke> strokes(request.painting->strokes.size());
    parallelFor(strokes.size(), threads, [&](std::size_t i) {
        const Stroke &stroke = *request.painting->strokes[i];
        if (request.painting->isVisible(stroke))
            strokes[i] = sourcesOf(stroke, request, rule, nodes);
    });
    std::vector<float> rgba(std::size_t(width) * std::size_t(height) * 4);
    parallelFor(std::size_t(height), threads, [&](std::size_t row) {
        drawRow(strokes, request, int(row), nodes, rgba.data() + row * std::size_t(width) * 4);
    });
    return rgba;
}

} // namespace suffuse::baseline
