#include "render/backends.h"

#include "render/cpu/cpu_renderer.h"
#include "render/cuda/cuda_renderer.h"
#include "render/fallback_renderer.h"
#include "render/threads/parallel.h"
#include "render/reference/reference.h"

#include <QCoreApplication>

namespace suffuse {

Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options)
{
    if (options.backend == Backend::Reference)
        return makeReferenceRenderer(options.threads);
    if (options.backend != Backend::Cpu) {
        Result<std::unique_ptr<Renderer>> cuda = makeCudaRenderer(options);
        if (cuda)
            return std::unique_ptr<Renderer>(std::make_unique<FallbackRenderer>(std::move(*cuda), options));
        if (options.backend == Backend::Cuda)
            return Error{
                QCoreApplication::translate("Renderer", "The CUDA backend cannot run: %1. Use the CPU backend.")
                    .arg(cuda.error())};
    }
    return std::unique_ptr<Renderer>(std::make_unique<CpuRenderer>(options.threads, options.tileSize, options.cull));
}

std::vector<BackendInfo> backends()
{
    const int threads = hardwareThreads();
    const CpuRenderer cpu(threads, 0);
    const auto reference = makeReferenceRenderer(threads);
    const auto cuda = makeCudaRenderer({.devices = allDevices});
    return {{cpu.backendName(), cpu.deviceName(), {}},
            {QStringLiteral("CUDA"), cuda ? (*cuda)->deviceName() : QString(), cuda ? QString() : cuda.error()},
            {reference->backendName(), reference->deviceName(), {}}};
}

} // namespace suffuse
