#include "render/renderer.h"

#include "render/cpu/cpu_renderer.h"
#include "render/parallel.h"
#include "render/reference/reference.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

QString whyNoCuda()
{
    return QCoreApplication::translate("Renderer", "this program was built without the CUDA renderer");
}

} // namespace

Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options)
{
    switch (options.backend) {
    case Backend::Reference:
        return makeReferenceRenderer(options.threads);
    case Backend::Cuda:
        return Error{QCoreApplication::translate("Renderer", "The CUDA backend cannot run: %1. Use the CPU backend.")
                         .arg(whyNoCuda())};
    case Backend::Auto:
    case Backend::Cpu:
        break;
    }
    return std::unique_ptr<Renderer>(std::make_unique<CpuRenderer>(options.threads, options.tileSize, options.cull));
}

std::vector<BackendInfo> backends()
{
    const int threads = hardwareThreads();
    const CpuRenderer cpu(threads, 0);
    const auto reference = makeReferenceRenderer(threads);
    return {{cpu.backendName(), cpu.deviceName(), {}},
            {QStringLiteral("CUDA"), {}, whyNoCuda()},
            {reference->backendName(), reference->deviceName(), {}}};
}

int heightForWidth(const Rect &area, int width)
{
    return int(std::lround(area.height() / (area.width() / width)));
}

} // namespace suffuse
