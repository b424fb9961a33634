#include "render/reference/reference.h"

#include "render/reference/band.h"

#include <QCoreApplication>

#include <algorithm>
#include <chrono>
#include <functional>

namespace suffuse {

namespace {

constexpr int bandRows = 8;

bool isSet(const std::atomic<bool> *cancel)
{
    return cancel && cancel->load(std::memory_order_relaxed);
}

/// Calls work(next) on every thread. next() hands out 0 … count − 1, each once, and then −1.
void onThreads(const Threads &threads, int count, const std::function<void(const std::function<int()> &)> &work)
{
    std::atomic<int> taken = 0;
    const std::function<int()> next = [&taken, count] {
        const int i = taken.fetch_add(1);
        return i < count ? i : -1;
    };
    parallelFor(std::size_t(std::min(threads.count(), count)), threads, [&](std::size_t) { work(next); });
}

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

ReferenceRenderer::ReferenceRenderer(int threads) : m_threads(threads) {}

QString ReferenceRenderer::deviceName() const
{
    return QCoreApplication::translate("ReferenceRenderer", "%1 threads · double").arg(m_threads.count());
}

Result<RenderStats> ReferenceRenderer::render(const RenderRequest &request, Target &target,
                                              const std::atomic<bool> *cancel)
{
    if (!request.part.isEmpty())
        return render(ofPart(request), target, cancel);
    const auto start = std::chrono::steady_clock::now();
    const View &view = request.view;
    const Canvas &canvas = request.painting->canvas;
    auto texture = paperTexture(canvas.paper);
    if (!texture)
        return Error{texture.error()};

    const reference::Drawing drawing = reference::drawingOf(*request.painting);
    reference::Scene scene{view,
                           {},
                           drawing.items,
                           {canvas.paper, *texture},
                           canvas.background,
                           request.transparent};
    scene.strokes.resize(drawing.strokes.size());
    onThreads(m_threads, int(drawing.strokes.size()), [&](const std::function<int()> &next) {
        for (int i = next(); i >= 0 && !isSet(cancel); i = next())
            scene.strokes[std::size_t(i)] =
                reference::strokeSource(*drawing.strokes[std::size_t(i)].stroke, request.time, view);
    });

    RenderStats stats;
    stats.nodesMs = millisecondsSince(start);
    for (const reference::StrokeSource &stroke : scene.strokes)
        for (const reference::SegmentSource &segment : stroke.segments)
            stats.nodes += 10 * segment.panels.size();

    target.resize(view.width, view.height);
    const auto tilesStart = std::chrono::steady_clock::now();
    stats.tiles = (view.height + bandRows - 1) / bandRows;
    std::atomic<int> done = 0;
    onThreads(m_threads, stats.tiles, [&](const std::function<int()> &next) {
        reference::BandPainter painter(scene);
        for (int i = next(); i >= 0 && !isSet(cancel); i = next()) {
            const int first = i * bandRows, count = std::min(bandRows, view.height - first);
            const std::vector<float> &rgba = painter.draw(first, count, cancel);
            if (rgba.empty())
                return;
            target.store({0, first, view.width, count}, rgba.data(), view.width);
            ++done;
        }
    });
    stats.tilesEvaluated = done;
    stats.cancelled = done < stats.tiles;
    if (!stats.cancelled)
        stats.dirty = {{0, 0, view.width, view.height}};
    stats.pixelsEvaluated = pixelsIn(stats.dirty);
    stats.tilesMs = millisecondsSince(tilesStart);
    stats.totalMs = millisecondsSince(start);
    return stats;
}

std::unique_ptr<Renderer> makeReferenceRenderer(int threads)
{
    return std::make_unique<ReferenceRenderer>(threads);
}

} // namespace suffuse
