#include "tests/bench/cuda/paper_scene.h"

#include "render/threads/parallel.h"
#include "tests/bench/baselines.h"
#include "tests/bench/paper_sources.h"

#include <algorithm>
#include <cmath>

namespace suffuse::baseline {

namespace {

CurveRecord curveOf(const Source &source)
{
    CurveRecord out{};
    const auto powers = [](double a, double b, double c, double d, float *to) {
        const double of[] = {a, 3 * (b - a), 3 * (a - 2 * b + c), d - a + 3 * (b - c)};
        std::copy(of, of + 4, to);
    };
    const std::array<Point, 4> &p = source.cubic.p;
    powers(p[0].x, p[1].x, p[2].x, p[3].x, out.x);
    powers(p[0].y, p[1].y, p[2].y, p[3].y, out.y);
    out.middleX = float(source.x);
    out.middleY = float(source.y);
    out.reach = float(source.reach);
    out.spread = float(source.spread);
    out.density = float(source.density);
    std::copy(source.colour, source.colour + 4, out.colour);
    return out;
}

QuadratureRecord quadratureOf(const Source &source, std::size_t stroke, int points)
{
    QuadratureRecord out{};
    out.middleX = float(source.x);
    out.middleY = float(source.y);
    out.reach = float(source.reach);
    out.scale = source.scale;
    std::copy(source.nodeX, source.nodeX + points, out.x);
    std::copy(source.nodeY, source.nodeY + points, out.y);
    std::copy(source.exponent, source.exponent + points, out.exponent);
    std::copy(source.colour, source.colour + 4, out.colour);
    out.stroke = std::uint32_t(stroke);
    return out;
}

/// The same constants as the CPU baseline's.
ShadeRecord shadeOf(const StrokeShade &shade)
{
    ShadeRecord out{};
    const auto &xi = shade.style.xi;
    out.kind = int(shade.style.kind);
    out.xi1 = xi[0];
    out.xi2 = xi[1];
    out.xi3 = xi[2];
    const float phi0 = std::max(0.0f, xi[0] - 8 * xi[1]);
    out.f0 = 1 / (1 + std::exp((xi[0] - phi0) / xi[1]));
    out.gain = 1 / (1 - out.f0);
    if (shade.style.kind == StyleKind::Edge) {
        const double r = std::pow(double(xi[1]) / xi[0], 3);
        out.cut = float(xi[0] * std::pow((r + std::sqrt(r * r + 4 * (1 / double(xi[2]) - 1))) / 2, -1.0 / 3));
    }
    out.keep = shade.keep;
    const Colour &c = shade.colour;
    const float colour[] = {c.red, c.yellow, c.blue, c.opacity};
    std::copy(colour, colour + 4, out.colour);
    out.varies = shade.varies;
    return out;
}

} // namespace

PaperScene paperScene(const RenderRequest &request, int points)
{
    PaperScene out;
    out.width = request.view.width;
    out.height = request.view.height;
    out.points = points == 5 ? 5 : 8;
    const Colour &c = request.painting->canvas.background;
    const float background[] = {c.red * c.opacity, c.yellow * c.opacity, c.blue * c.opacity};
    std::copy(background, background + 3, out.background);
    const Rule rule = gaussRule(out.points);
    std::copy(rule.x, rule.x + out.points, out.ruleX);
    std::copy(rule.weight, rule.weight + out.points, out.ruleWeight);
    for (const SourceStroke &stroke : paperSources(request, out.points, 0)) {
        if (stroke.sources.empty())
            continue;
        ShadeRecord shade = shadeOf(stroke.shade);
        shade.firstSegment = std::uint32_t(out.curves.size());
        shade.segments = std::uint32_t(stroke.sources.size());
        for (const Source &source : stroke.sources) {
            out.curves.push_back(curveOf(source));
            out.quadratures.push_back(quadratureOf(source, out.strokes.size(), out.points));
        }
        out.strokes.push_back(shade);
    }
    return out;
}

PaperWork paperWork(const RenderRequest &request, int points)
{
    const int width = request.view.width, height = request.view.height;
    const std::vector<SourceStroke> strokes = paperSources(request, points, 0);
    std::vector<double> pairs(strokes.size(), 0);
    parallelFor(strokes.size(), 0, [&](std::size_t i) {
        for (const Source &source : strokes[i].sources) {
            const int last = std::min(height, int(source.y + source.reach) + 1);
            for (int row = std::max(0, int(source.y - source.reach)); row < last; ++row) {
                const RowSpan span = reachOnRow(source, row, width);
                pairs[i] += span.last - span.first;
            }
        }
    });
    // As the kernels' comments count.
    PaperWork out;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        out.pairs += pairs[i];
        out.asWritten += pairs[i] * (34 * points + 5 + 9) + double(strokes[i].sources.size()) * width * height * 5;
        out.port += pairs[i] * (5.75 * points + 4 + (strokes[i].shade.varies ? 9 : 1));
    }
    return out;
}

} // namespace suffuse::baseline
