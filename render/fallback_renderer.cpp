#include "render/fallback_renderer.h"

#include "render/cpu/cpu_renderer.h"

#include <QCoreApplication>

namespace suffuse {

FallbackRenderer::FallbackRenderer(std::unique_ptr<Renderer> primary, const RendererOptions &options)
    : m_renderer(std::move(primary)), m_options(options)
{}

QString FallbackRenderer::backendName() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->backendName();
}

QString FallbackRenderer::deviceName() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->deviceName();
}

QString FallbackRenderer::notice() const
{
    const std::lock_guard lock(m_mutex);
    return m_notice;
}

Result<RenderStats> FallbackRenderer::render(const RenderRequest &request, Target &target,
                                             const std::atomic<bool> *cancel)
{
    Result<RenderStats> result = m_renderer->render(request, target, cancel);
    if (result || !m_renderer->isLost())
        return result;
    auto cpu = std::make_unique<CpuRenderer>(m_options.threads, m_options.tileSize, m_options.cull);
    {
        const std::lock_guard lock(m_mutex);
        m_notice = QCoreApplication::translate("Renderer", "%1 stopped: %2. The CPU draws now.")
                       .arg(m_renderer->backendName(), result.error());
        m_renderer = std::move(cpu);
    }
    return m_renderer->render(request, target, cancel);
}

} // namespace suffuse
