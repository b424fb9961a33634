#include "render/backends.h"

#include "render/cost.h"
#include "render/cpu/cpu_renderer.h"
#include "render/cuda/cuda_differentiator.h"
#include "render/cuda/cuda_renderer.h"
#include "render/fallback_renderer.h"
#include "render/reference/reference.h"
#include "render/starting_renderer.h"
#include "render/threads/parallel.h"

#include <QCoreApplication>

#include <algorithm>
#include <thread>
#include <vector>

namespace suffuse {

namespace {

std::unique_ptr<Renderer> makeCpuRenderer(const RendererOptions &options)
{
    return std::make_unique<CpuRenderer>(options.threads, options.tileSize, options.cull);
}

QString cudaCannotRun(const QString &why)
{
    return QCoreApplication::translate("Renderer", "The CUDA backend cannot run: %1. Use the CPU backend.").arg(why);
}

/// A renderer on GPUs that goes on with the CPU when they fail.
Result<std::unique_ptr<Renderer>> makeDeviceRenderer(const RendererOptions &options)
{
    Result<std::unique_ptr<Renderer>> cuda = makeCudaRenderer(options);
    if (!cuda)
        return cuda;
    return std::unique_ptr<Renderer>(
        std::make_unique<FallbackRenderer>(std::move(*cuda), [options] { return makeCpuRenderer(options); }));
}

/// Draws a small picture, since a device loads its programs when they are first used.
void warmUp(Renderer &renderer)
{
    RenderRequest request;
    request.painting = std::make_shared<const Painting>();
    request.view = View::ofArea(Rect::of(0, 0, 16, 16), 16, 16);
    Picture8 picture;
    (void)renderer.render(request, picture);
}

} // namespace

Result<std::unique_ptr<Renderer>> makeRendererAtOnce(const RendererOptions &options)
{
    if (options.backend == Backend::Cpu || options.backend == Backend::Reference)
        return makeRenderer(options);
    const auto make = [options]() -> Result<std::unique_ptr<Renderer>> {
        Result<std::unique_ptr<Renderer>> device = makeDeviceRenderer(options);
        if (!device)
            return Error{QStringLiteral("CUDA: %1").arg(device.error())};
        warmUp(**device);
        return device;
    };
    return std::unique_ptr<Renderer>(std::make_unique<StartingRenderer>(makeCpuRenderer(options), make));
}

Backend quickestBackend(const RenderRequest &request, std::size_t pictures, const RendererOptions &options)
{
    constexpr double secondsToStart = 0.5; // of one GPU, on the machines that were measured (docs/performance.md)
    const double seconds = double(pictures) * cpuSeconds(request) / Threads(options.threads).count();
    return seconds < secondsToStart ? Backend::Cpu : Backend::Auto;
}

Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options)
{
    if (options.backend == Backend::Reference)
        return makeReferenceRenderer(options.threads);
    if (options.backend != Backend::Cpu) {
        Result<std::unique_ptr<Renderer>> cuda = makeDeviceRenderer(options);
        if (cuda)
            return cuda;
        if (options.backend == Backend::Cuda)
            return Error{cudaCannotRun(cuda.error())};
    }
    return makeCpuRenderer(options);
}

Result<std::unique_ptr<gradient::Differentiator>> makeDifferentiator(Backend backend, const Threads &threads)
{
    if (backend == Backend::Reference)
        return Error{QCoreApplication::translate("Renderer", "The reference finds no gradients. Use the CPU backend.")};
    if (backend != Backend::Cpu) {
        Result<std::unique_ptr<gradient::Differentiator>> cuda = makeCudaDifferentiator(threads);
        if (cuda)
            return cuda;
        if (backend == Backend::Cuda)
            return Error{cudaCannotRun(cuda.error())};
    }
    return gradient::makeCpuDifferentiator(threads);
}

Result<std::vector<std::unique_ptr<Renderer>>> makeRenderers(const RendererOptions &options)
{
    const bool onGpus = options.backend == Backend::Auto || options.backend == Backend::Cuda;
    const int found = onGpus ? std::max(1, cudaDeviceCount()) : 1;
    const int count = options.devices == allDevices ? found : std::clamp(options.devices, 1, found);
    std::vector<Result<std::unique_ptr<Renderer>>> made;
    for (int i = 0; i < count; ++i)
        made.emplace_back(Error{});
    const auto make = [&](int i) {
        RendererOptions one = options;
        one.devices = 1;
        one.firstDevice = i;
        one.threads = std::max(1, Threads(options.threads).count() / count); // They work at the same time.
        if (i > 0)
            one.backend = Backend::Cuda;
        made[std::size_t(i)] = makeRenderer(one);
    };
    {
        std::vector<std::jthread> others; // Each device takes its time to start.
        for (int i = 1; i < count; ++i)
            others.emplace_back(make, i);
        make(0);
    }
    if (!made.front())
        return Error{made.front().error()};
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (Result<std::unique_ptr<Renderer>> &renderer : made)
        if (renderer) // A device that does not start leaves its work to the others.
            renderers.push_back(std::move(*renderer));
    return renderers;
}

std::vector<BackendInfo> backends()
{
    const int threads = hardwareThreads();
    const CpuRenderer cpu(threads, 0);
    const auto reference = makeReferenceRenderer(threads);
    const auto cuda = makeCudaRenderer({.devices = allDevices});
    return {{Backend::Cpu, cpu.deviceName(), {}},
            {Backend::Cuda, cuda ? (*cuda)->deviceName() : QString(), cuda ? QString() : cuda.error()},
            {Backend::Reference, reference->deviceName(), {}}};
}

} // namespace suffuse
