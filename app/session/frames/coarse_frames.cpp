#include "app/session/frames/coarse_frames.h"

#include "render/threads/parallel.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse {

namespace {

/// Pixels to a side of a tile: of the view it is a large one.
constexpr int coarseTile = 16;

/// A pixel's four channels in lanes of 16 bits, so that they are scaled together.
using Lanes = std::uint64_t;
constexpr Lanes evenBytes = 0x00FF00FF, allLanes = 0x00FF00FF00FF00FF;

Lanes lanesOf(std::uint32_t argb)
{
    return Lanes(argb & evenBytes) | Lanes((argb >> 8) & evenBytes) << 32;
}

std::uint32_t pixelOf(Lanes lanes)
{
    return std::uint32_t(lanes) | std::uint32_t(lanes >> 32) << 8;
}

/// `weight` of 256 goes to `b`.
Lanes mixed(Lanes a, Lanes b, unsigned weight)
{
    return ((a * (256 - weight) + b * weight) >> 8) & allLanes;
}

/// Between which two pixels of a row a place lies, and how near to the second, of 256.
struct Between {
    int first = 0, second = 0;
    unsigned weight = 0;
};

/// Along one side: `size` pixels of the view, `coarse` of those that were drawn, middle on middle.
Between betweenAt(int pixel, int size, int coarse, int factor)
{
    const double at = (pixel + 0.5 - 0.5 * size) / factor + 0.5 * coarse - 0.5;
    const double first = std::floor(at);
    const auto inside = [coarse](double i) { return int(std::clamp(i, 0.0, coarse - 1.0)); };
    return {inside(first), inside(first + 1), unsigned(256 * (at - first))};
}

/// Of a whole side.
std::vector<Between> betweensOf(int size, int coarse, int factor)
{
    std::vector<Between> places(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
        places[std::size_t(i)] = betweenAt(i, size, coarse, factor);
    return places;
}

void enlargeRect(const Picture8 &from, Picture8 &to, const PixelRect &r, std::span<const Between> columns,
                 std::span<const Between> rowPlaces)
{
    columns = columns.subspan(std::size_t(r.x), std::size_t(r.width));
    const int left = columns.front().first, right = columns.back().second;
    std::vector<Lanes> row(std::size_t(right - left + 1));
    for (int y = r.y; y < r.y + r.height; ++y) {
        const Between &rows = rowPlaces[std::size_t(y)];
        const std::uint32_t *upper = from.argb.data() + std::size_t(rows.first) * from.width;
        const std::uint32_t *lower = from.argb.data() + std::size_t(rows.second) * from.width;
        for (int x = left; x <= right; ++x)
            row[std::size_t(x - left)] = mixed(lanesOf(upper[x]), lanesOf(lower[x]), rows.weight);
        std::uint32_t *out = to.argb.data() + std::size_t(y) * to.width + r.x;
        for (const Between &c : columns)
            *out++ = pixelOf(mixed(row[std::size_t(c.first - left)], row[std::size_t(c.second - left)], c.weight));
    }
}

/// All of a view, in parts that several threads can enlarge.
std::vector<PixelRect> bandsOf(const View &view)
{
    constexpr int rows = 64;
    std::vector<PixelRect> bands;
    for (int y = 0; y < view.height; y += rows)
        bands.push_back({0, y, view.width, std::min(rows, view.height - y)});
    return bands;
}

/// A rectangle of the coarse picture in pixels of the view.
PixelRect enlarged(const PixelRect &r, const View &view, const View &coarse, int factor)
{
    const auto edge = [factor](int at, int size, int coarseSize) {
        return std::clamp(int(std::lround((at - 0.5 * coarseSize) * factor + 0.5 * size)), 0, size);
    };
    const int left = edge(r.x, view.width, coarse.width), right = edge(r.x + r.width, view.width, coarse.width);
    const int top = edge(r.y, view.height, coarse.height), bottom = edge(r.y + r.height, view.height, coarse.height);
    return {left, top, right - left, bottom - top};
}

} // namespace

CoarseFrames::CoarseFrames(const RendererOptions &options, MakeRenderer make, int factor)
    : m_options(options), m_make(std::move(make)), m_factor(factor)
{
    m_options.backend = Backend::Cpu;
    m_options.tileSize = coarseTile;
}

FrameResult CoarseFrames::show(const FrameTask &task, FrameBoard &board, FrameInfo &frame)
{
    const RenderRequest &request = task.job.request;
    const bool moved = task.before->view != request.view;
    if (!moved && !isAt(*task.before) && !draw(*task.before))
        return {.outcome = FrameOutcome::Failed};
    Result<RenderStats> stats = draw(request);
    if (!stats)
        return {.outcome = FrameOutcome::Failed};
    bool fits = false;
    board.with([&](ShownFrame &shown) {
        fits = shown.picture.width == request.view.width && shown.picture.height == request.view.height;
        if (!fits)
            return; // the last one stayed on a device
        if (moved)
            stats->dirty = bandsOf(request.view);
        enlargeInto(shown.picture, stats->dirty);
        shown.dirty.insert(shown.dirty.end(), stats->dirty.begin(), stats->dirty.end());
        shown.view = request.view;
    });
    if (!fits)
        return {.outcome = FrameOutcome::Unfit};
    if (moved)
        board.takePatches(); // They lay in another view, and all of it is replaced.
    board.notePatches(stats->dirty);
    FrameResult result{.ms = stats->totalMs, .pixels = stats->pixelsEvaluated * m_factor * m_factor};
    frame.coarseness = m_factor;
    frame.evaluated = stats->pixelsEvaluated;
    frame.stats = std::move(*stats);
    return result;
}

FrameResult CoarseFrames::prepare(const FrameTask &task, const std::atomic<bool> *cancel)
{
    const Result<RenderStats> stats = draw(*task.before, cancel);
    if (!stats)
        return {.outcome = FrameOutcome::Failed};
    return {.outcome = stats->cancelled ? FrameOutcome::Cancelled : FrameOutcome::Done};
}

void CoarseFrames::forget()
{
    m_renderer.reset();
    m_picture = {};
    m_at.reset();
}

View CoarseFrames::coarseView(const View &view) const
{
    View coarse = view; // the same point in the middle
    coarse.scale = view.scale / m_factor;
    coarse.width = (view.width + m_factor - 1) / m_factor;
    coarse.height = (view.height + m_factor - 1) / m_factor;
    return coarse;
}

Result<RenderStats> CoarseFrames::draw(const RenderRequest &request, const std::atomic<bool> *cancel)
{
    if (!m_renderer) {
        Result<std::unique_ptr<Renderer>> renderer = m_make(m_options);
        if (!renderer)
            return Error{renderer.error()};
        m_renderer = std::move(*renderer);
    }
    RenderRequest coarse = request;
    coarse.view = coarseView(request.view);
    Result<RenderStats> stats = m_renderer->render(coarse, m_picture, cancel);
    if (!stats)
        return stats;
    if (stats->cancelled)
        m_at.reset();
    else
        m_at = request;
    for (PixelRect &r : stats->dirty)
        r = enlarged(r, request.view, coarse.view, m_factor);
    std::erase_if(stats->dirty, [](const PixelRect &r) { return r.isEmpty(); });
    return stats;
}

void CoarseFrames::enlargeInto(Picture8 &picture, const std::vector<PixelRect> &rects) const
{
    const std::vector<Between> columns = betweensOf(picture.width, m_picture.width, m_factor);
    const std::vector<Between> rows = betweensOf(picture.height, m_picture.height, m_factor);
    parallelFor(rects.size(), m_options.threads,
                [&](std::size_t i) { enlargeRect(m_picture, picture, rects[i], columns, rows); });
}

} // namespace suffuse
