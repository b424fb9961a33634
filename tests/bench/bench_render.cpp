// Google Benchmark programs over the renderer's jobs: for work on the renderer itself (--benchmark_filter, perf).
#include "render/bench/generator.h"
#include "render/backends.h"

#include <benchmark/benchmark.h>

#include <QCoreApplication>

#include <map>

using namespace suffuse;

namespace {

PaintingPtr paintingOf(int segments, double spreadLow, double spreadHigh)
{
    static std::map<std::tuple<int, double, double>, PaintingPtr> made;
    PaintingPtr &painting = made[{segments, spreadLow, spreadHigh}];
    if (!painting) {
        bench::PaintingOptions options;
        options.segments = segments;
        options.strokes = std::max(1, segments / 23);
        options.spreadLow = spreadLow;
        options.spreadHigh = spreadHigh;
        painting = std::make_shared<const Painting>(bench::makePainting(options));
    }
    return painting;
}

std::unique_ptr<Renderer> rendererWith(int threads)
{
    RendererOptions options;
    options.backend = Backend::Cpu;
    options.threads = threads;
    return std::move(*makeRenderer(options));
}

RenderRequest requestFor(const PaintingPtr &painting, int width)
{
    const Rect area = painting->canvas.area();
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = View::ofArea(area, width, heightForWidth(area, width));
    return request;
}

/// Arguments: segments, width, threads. Everything but the nodes.
void fullRender(benchmark::State &state, double spreadLow, double spreadHigh)
{
    const RenderRequest request =
        requestFor(paintingOf(int(state.range(0)), spreadLow, spreadHigh), int(state.range(1)));
    const auto renderer = rendererWith(int(state.range(2)));
    Picture8 picture;
    (void)renderer->render(request, picture);
    double nodes = 0;
    for ([[maybe_unused]] auto _ : state) {
        renderer->invalidate();
        const auto stats = renderer->render(request, picture);
        nodes = double(stats->nodes);
    }
    state.counters["nodes"] = nodes;
}

/// Arguments: segments, width, threads. A fresh renderer each time; the time is that of its nodes.
void nodeBuild(benchmark::State &state)
{
    const RenderRequest request = requestFor(paintingOf(int(state.range(0)), 6, 20), int(state.range(1)));
    for ([[maybe_unused]] auto _ : state) {
        const auto renderer = rendererWith(int(state.range(2)));
        Picture8 picture;
        const auto stats = renderer->render(request, picture);
        state.SetIterationTime(stats->nodesMs * 1e-3);
    }
}

/// Arguments: segments, width, threads. One stroke's density goes up and down.
void drag(benchmark::State &state)
{
    const PaintingPtr painting = paintingOf(int(state.range(0)), 6, 20);
    RenderRequest request = requestFor(painting, int(state.range(1)));
    const auto renderer = rendererWith(int(state.range(2)));
    Picture8 picture;
    (void)renderer->render(request, picture);
    request.interactive = true;
    float factor = 1;
    const std::size_t index = painting->strokes.size() / 2;
    for ([[maybe_unused]] auto _ : state) {
        factor = factor == 1 ? 1.05f : 1;
        Painting edited = *painting;
        Stroke stroke = *painting->strokes[index];
        for (Segment &s : stroke.segments)
            s.density *= factor;
        edited.strokes[index] = std::make_shared<const Stroke>(std::move(stroke));
        request.painting = std::make_shared<const Painting>(std::move(edited));
        (void)renderer->render(request, picture);
    }
}

/// Arguments: segments below, width, threads, segments of a stroke whose last 140 grow and spread on top of them.
void liveStroke(benchmark::State &state)
{
    const PaintingPtr painting = paintingOf(int(state.range(0)), 6, 20);
    RenderRequest request = requestFor(painting, int(state.range(1)));
    const auto renderer = rendererWith(int(state.range(2)));
    Picture8 picture;
    const Microseconds start = painting->end() + 1'000'000;
    const int end = int(state.range(3));
    int segments = end - 140;
    for ([[maybe_unused]] auto _ : state) {
        Painting edited = *painting;
        edited.strokes.push_back(std::make_shared<const Stroke>(
            bench::makeLiveStroke(painting->canvas, 13, segments, painting->nextStrokeId(), start)));
        request.painting = std::make_shared<const Painting>(std::move(edited));
        request.time = start + Microseconds(segments) * 1'000'000 / 60;
        (void)renderer->render(request, picture);
        segments = segments == end ? end - 140 : segments + 1;
    }
}

} // namespace

BENCHMARK_CAPTURE(fullRender, tiny, 2.0, 4.0)->Args({230, 64, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(fullRender, spread6to20, 6.0, 20.0)
    ->ArgNames({"segments", "width", "threads"})
    ->ArgsProduct({{17917}, {1024, 2880}, {1, 2}})
    ->ArgsProduct({{1000, 10000, 100000}, {1024}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(fullRender, spread32to72, 32.0, 72.0)
    ->ArgNames({"segments", "width", "threads"})
    ->Args({17917, 1024, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(nodeBuild)
    ->ArgNames({"segments", "width", "threads"})
    ->ArgsProduct({{17917}, {1024}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK(drag)
    ->ArgNames({"segments", "width", "threads"})
    ->ArgsProduct({{17917}, {1024, 2880}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(liveStroke)
    ->ArgNames({"segments", "width", "threads", "live"})
    ->ArgsProduct({{17917}, {1024, 2880, 3840}, {2}, {200, 2000}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
