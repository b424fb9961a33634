#include "render/threads/parallel.h"
#include "tests/bench/baselines.h"
#include "tests/bench/paper_sources.h"

#include <algorithm>

namespace suffuse::baseline {

namespace {

/// None of the row within reach: first = last.
RowQuadrature onRow(const Source &source, int row, int width, int nodes)
{
    RowQuadrature out;
    const RowSpan span = reachOnRow(source, row, width);
    out.first = span.first;
    out.last = span.last;
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
    const std::vector<SourceStroke> strokes = paperSources(request, nodes, threads);
    std::vector<float> rgba(std::size_t(width) * std::size_t(height) * 4);
    parallelFor(std::size_t(height), threads, [&](std::size_t row) {
        drawRow(strokes, request, int(row), nodes, rgba.data() + row * std::size_t(width) * 4);
    });
    return rgba;
}

} // namespace suffuse::baseline
