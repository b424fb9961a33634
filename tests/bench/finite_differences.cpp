#include "render/threads/parallel.h"
#include "tests/bench/baselines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse::baseline {

namespace {

/// A grid of floats, one a pixel, with its corner in the picture.
struct Grid {
    int x = 0, y = 0, width = 0, height = 0;
    int stride() const { return (width + padding + 15) / 16 * 16; }
    std::vector<float> values;
    void allocate() { values.assign(std::size_t(stride()) * std::size_t(height) + 4 * padding, 0.0f); }
};

struct Field {
    StrokeShade shade;
    std::vector<Grid> planes; ///< φ, then Σφ_kC_k where colours vary; empty: nothing there
};

/// Shares a point mass out to the four pixels around it.
void deposit(std::vector<Grid> &planes, Point p, const float *masses)
{
    const double fx = p.x - 0.5 - planes[0].x, fy = p.y - 0.5 - planes[0].y;
    const int x = int(std::floor(fx)), y = int(std::floor(fy));
    if (x < 0 || y < 0 || x + 1 >= planes[0].width || y + 1 >= planes[0].height)
        return;
    const float u = float(fx - x), v = float(fy - y);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        float *at = planes[i].values.data() + std::ptrdiff_t(y) * planes[i].stride() + x;
        at[0] += masses[i] * (1 - u) * (1 - v);
        at[1] += masses[i] * u * (1 - v);
        at[planes[i].stride()] += masses[i] * (1 - u) * v;
        at[planes[i].stride() + 1] += masses[i] * u * v;
    }
}

void depositSegment(std::vector<Grid> &planes, const Stroke &stroke, const Segment &segment, const View &view)
{
    const Cubic cubic = stroke.cubicOf(segment);
    double polygon = 0;
    for (int i = 0; i < 3; ++i)
        polygon += length(cubic.p[std::size_t(i) + 1] - cubic.p[std::size_t(i)]);
    const int samples = std::max(2, int(std::ceil(2 * polygon * view.scale)));
    const Colour &c = segment.colour;
    for (int i = 0; i < samples; ++i) {
        const double t = (i + 0.5) / samples;
        const float mass =
            float(double(segment.density) * view.scale * length(cubic.derivative(t)) * view.scale / samples);
        const float masses[] = {mass, mass * c.red, mass * c.yellow, mass * c.blue, mass * c.opacity};
        deposit(planes, view.toPixels(cubic.at(t)), masses);
    }
}

/// Columns, then rows: with one D the two directions commute, so each is done in one go.
void diffuse(Grid &grid, float r, int steps)
{
    const BaselineKernels &kernels = baselineKernels();
    std::vector<float> factors(2 * std::size_t(std::max(grid.width, grid.height)));
    kernels.diffuseColumns(grid.values.data(), grid.stride(), grid.width, grid.height, r, steps, factors.data());
    Grid turned;
    turned.width = grid.height;
    turned.height = grid.width;
    turned.allocate();
    constexpr int block = 16;
    const auto transpose = [](const Grid &from, Grid &to) {
        for (int y0 = 0; y0 < from.height; y0 += block)
            for (int x0 = 0; x0 < from.width; x0 += block)
                for (int x = x0; x < std::min(x0 + block, from.width); ++x)
                    for (int y = y0; y < std::min(y0 + block, from.height); ++y)
                        to.values[std::size_t(x) * std::size_t(to.stride()) + std::size_t(y)] =
                            from.values[std::size_t(y) * std::size_t(from.stride()) + std::size_t(x)];
    };
    transpose(grid, turned);
    kernels.diffuseColumns(turned.values.data(), turned.stride(), turned.width, turned.height, r, steps,
                           factors.data());
    transpose(turned, grid);
}

/// The stroke's box in pixels and 4 s around it, as far as the picture and 4 s around that go.
Grid gridOf(const Stroke &stroke, const RenderRequest &request)
{
    Rect box;
    double spread = 0;
    for (const Segment &s : stroke.segments) {
        spread = std::max(spread, s.spread(request.time) * request.view.scale);
        for (const Offset &o : s.bezier)
            box.include(request.view.toPixels(stroke.origin + o));
    }
    Grid grid;
    const double margin = 4 * spread + 2;
    const double left = std::max(box.left - margin, -margin), top = std::max(box.top - margin, -margin);
    const double right = std::min(box.right + margin, request.view.width + margin);
    const double bottom = std::min(box.bottom + margin, request.view.height + margin);
    if (spread <= 0 || !(left < right && top < bottom))
        return grid;
    grid.x = int(std::floor(left));
    grid.y = int(std::floor(top));
    grid.width = int(std::ceil(right)) - grid.x;
    grid.height = int(std::ceil(bottom)) - grid.y;
    grid.allocate();
    return grid;
}

Field fieldOf(const Stroke &stroke, const RenderRequest &request, int steps)
{
    Field out;
    out.shade = shadeOf(stroke);
    const Grid empty = gridOf(stroke, request);
    if (empty.values.empty())
        return out;
    const std::size_t planes = out.shade.varies ? sumPlanes : 1;
    // Segments of one spread diffuse together.
    std::map<double, std::vector<const Segment *>> bySpread;
    for (const Segment &s : stroke.segments)
        if (const double spread = s.spread(request.time) * request.view.scale; spread > 0)
            bySpread[spread].push_back(&s);
    for (const auto &[spread, segments] : bySpread) {
        std::vector<Grid> part(planes, empty);
        for (const Segment *s : segments)
            depositSegment(part, stroke, *s, request.view);
        for (Grid &grid : part)
            diffuse(grid, float(spread * spread / (4 * steps)), steps);
        if (out.planes.empty()) {
            out.planes = std::move(part);
            continue;
        }
        for (std::size_t i = 0; i < planes; ++i)
            for (std::size_t k = 0; k < part[i].values.size(); ++k)
                out.planes[i].values[k] += part[i].values[k];
    }
    return out;
}

void mixRow(const Field &field, int row, int width, float *const *backdrop)
{
    if (field.planes.empty())
        return;
    const Grid &grid = field.planes.front();
    if (row < grid.y || row >= grid.y + grid.height)
        return;
    const float *sums[sumPlanes] = {};
    for (std::size_t i = 0; i < field.planes.size(); ++i)
        sums[i] = field.planes[i].values.data() + std::ptrdiff_t(row - grid.y) * grid.stride() - grid.x;
    baselineKernels().mixStroke(field.shade, sums, std::max(grid.x, 0), std::min(grid.x + grid.width, width), backdrop);
}

} // namespace

std::vector<float> finiteDifferences(const RenderRequest &request, int steps, int threads)
{
    const int width = request.view.width, height = request.view.height;
    std::vector<StrokePtr> strokes;
    for (const StrokePtr &s : request.painting->strokes)
        if (request.painting->isVisible(*s))
            strokes.push_back(s);
    std::vector<RowPlanes> rows;
    for (int row = 0; row < height; ++row)
        rows.push_back(backgroundRow(request.painting->canvas, width));
    constexpr std::size_t batch = 64;
    for (std::size_t from = 0; from < strokes.size(); from += batch) {
        std::vector<Field> fields(std::min(batch, strokes.size() - from));
        parallelFor(fields.size(), threads,
                    [&](std::size_t i) { fields[i] = fieldOf(*strokes[from + i], request, steps); });
        parallelFor(rows.size(), threads, [&](std::size_t row) {
            for (const Field &field : fields)
                mixRow(field, int(row), width, rows[row].plane.data());
        });
    }
    std::vector<float> rgba(std::size_t(width) * std::size_t(height) * 4);
    parallelFor(rows.size(), threads, [&](std::size_t row) {
        baselineKernels().finishRow(rows[row].plane.data(), width, rgba.data() + row * std::size_t(width) * 4);
    });
    return rgba;
}

} // namespace suffuse::baseline
