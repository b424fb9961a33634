#include "tests/bench/paper_sources.h"

#include "render/threads/parallel.h"
#include "tests/bench/baselines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse::baseline {

namespace {

Source sourceOf(const Stroke &stroke, const Segment &segment, const RenderRequest &request, const Rule &rule, int nodes)
{
    const View &view = request.view;
    const Cubic cubic = stroke.cubicOf(segment);
    const double s = segment.spread(request.time) * view.scale;
    Source out;
    out.spread = s;
    out.density = double(segment.density) * view.scale;
    for (std::size_t i = 0; i < 4; ++i)
        out.cubic.p[i] = view.toPixels(cubic.p[i]);
    double length = 0;
    for (int i = 0; i < nodes; ++i) {
        const Point p = view.toPixels(cubic.at(rule.x[i]));
        const double step = rule.weight[i] * suffuse::length(cubic.derivative(rule.x[i])) * view.scale;
        length += step;
        const double density = out.density * step / (std::numbers::pi * s * s);
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

} // namespace

// By Newton's iteration on the Legendre polynomial.
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

std::vector<SourceStroke> paperSources(const RenderRequest &request, int nodes, int threads)
{
    const Rule rule = gaussRule(nodes);
    std::vector<SourceStroke> strokes(request.painting->strokes.size());
    parallelFor(strokes.size(), threads, [&](std::size_t i) {
        const Stroke &stroke = *request.painting->strokes[i];
        if (request.painting->isVisible(stroke))
            strokes[i] = sourcesOf(stroke, request, rule, nodes);
    });
    return strokes;
}

RowSpan reachOnRow(const Source &source, int row, int width)
{
    const double dy = row + 0.5 - source.y, square = source.reach * source.reach - dy * dy;
    if (square <= 0)
        return {};
    const double half = std::sqrt(square);
    const int first = std::clamp(int(std::ceil(source.x - half - 0.5)), 0, width);
    return {first, std::clamp(int(std::floor(source.x + half - 0.5)) + 1, first, width)};
}

} // namespace suffuse::baseline
