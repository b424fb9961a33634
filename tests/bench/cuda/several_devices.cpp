#include "tests/bench/cuda/several_devices.h"

#include "model/document/timelapse.h"
#include "render/backends.h"
#include "render/bench/plan.h"
#include "render/sequence.h"

#include <QElapsedTimer>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

namespace suffuse {

namespace {

double secondsSince(const QElapsedTimer &timer)
{
    return double(timer.nsecsElapsed()) * 1e-9;
}

/// A picture of 32768 × 24576 pixels, which no memory need hold, in 48 parts that the devices take one after another;
/// seconds from ready devices to the last part, as 8 bits in memory.
Result<double> inParts(const std::vector<std::unique_ptr<Renderer>> &renderers, const PaintingPtr &painting)
{
    constexpr int columns = 8, rows = 6, side = 4096;
    const Rect all = painting->canvas.area();
    std::atomic<int> next = 0;
    std::mutex mutex;
    QString error;
    const auto draw = [&](Renderer &renderer) {
        Picture8 part;
        for (int i = next++; i < columns * rows; i = next++) {
            const double width = all.width() / columns, height = all.height() / rows;
            RenderRequest request;
            request.painting = painting;
            request.time = painting->end();
            request.view = View::ofArea(
                Rect::of(all.left + i % columns * width, all.top + i / columns * height, width, height), side, side);
            if (const auto stats = renderer.render(request, part); !stats || !renderer.notice().isEmpty()) {
                const std::lock_guard lock(mutex);
                error = stats ? renderer.notice() : stats.error();
            }
        }
    };
    QElapsedTimer timer;
    timer.start();
    {
        std::vector<std::jthread> threads;
        for (const auto &renderer : renderers)
            threads.emplace_back([&] { draw(*renderer); });
    }
    return error.isEmpty() ? Result<double>(secondsSince(timer)) : Error{error};
}

/// 300 frames of 1920 × 1440 pixels; seconds from ready devices to the last frame, each as 8 bits in memory.
Result<double> film(const std::vector<std::unique_ptr<Renderer>> &renderers, const PaintingPtr &painting)
{
    RenderRequest request;
    request.painting = painting;
    request.view = View::ofArea(painting->canvas.area(), 1920, 1440);
    QElapsedTimer timer;
    timer.start();
    const auto drawn = renderSequence(renderers, request, timelapseMoments(*painting, {300, 0.5}), 0,
                                      [](std::size_t, const FloatPicture &frame) {
                                          thread_local Picture8 raw;
                                          if (raw.width != frame.width)
                                              raw.resize(frame.width, frame.height);
                                          raw.store({0, 0, frame.width, frame.height}, frame.at(0, 0), frame.width);
                                          return Result<void>();
                                      });
    return drawn ? Result<double>(secondsSince(timer)) : Error{drawn.error()};
}

/// The same by one device and by all, in turn, after a first time that is not counted; medians.
Result<std::vector<CudaFact>>
onSeveral(const QString &name,
          const std::function<Result<double>(const std::vector<std::unique_ptr<Renderer>> &)> &take, int runs,
          const QString &painting)
{
    std::vector<std::vector<std::unique_ptr<Renderer>>> made;
    for (const int devices : {1, allDevices}) {
        RendererOptions cuda;
        cuda.backend = Backend::Cuda;
        cuda.devices = devices;
        auto renderers = makeRenderers(cuda);
        if (!renderers)
            return Error{renderers.error()};
        made.push_back(std::move(*renderers));
    }
    std::map<std::size_t, std::vector<double>> seconds;
    for (int run = -1; run < std::min(runs, 9); ++run)
        for (const auto &renderers : made) {
            const Result<double> took = take(renderers);
            if (!took)
                return Error{took.error()};
            if (run >= 0)
                seconds[renderers.size()].push_back(*took);
        }
    std::vector<CudaFact> facts;
    for (auto &[devices, times] : seconds)
        facts.push_back(
            {QStringLiteral("%1-%2-devices").arg(name).arg(devices), painting, bench::timingOf(times).medianMs, "s"});
    return facts;
}

} // namespace

Result<std::vector<CudaFact>> timesOnSeveralDevices(const CudaCase &c, int runs)
{
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    Result<std::vector<CudaFact>> facts = onSeveral(
        "32768x24576-in-parts", [&](const auto &renderers) { return inParts(renderers, *painting); }, runs, c.name);
    if (!facts)
        return facts;
    const Result<std::vector<CudaFact>> films = onSeveral(
        "film", [&](const auto &renderers) { return film(renderers, *painting); }, runs, c.name);
    if (!films)
        return films;
    facts->insert(facts->end(), films->begin(), films->end());
    return facts;
}

} // namespace suffuse
