#include "render/fallback_renderer.h"

#include <QCoreApplication>

namespace suffuse {

FallbackRenderer::FallbackRenderer(std::unique_ptr<Renderer> primary,
                                   std::function<std::unique_ptr<Renderer>()> makeCpu)
    : m_renderer(std::move(primary)), m_makeCpu(std::move(makeCpu))
{}

Backend FallbackRenderer::backend() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->backend();
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
    std::unique_ptr<Renderer> cpu = m_makeCpu();
    {
        const std::lock_guard lock(m_mutex);
        m_notice = QCoreApplication::translate("Renderer", "%1 stopped: %2. The CPU draws now.")
                       .arg(nameOf(m_renderer->backend()), result.error());
        m_renderer = std::move(cpu);
    }
    return m_renderer->render(request, target, cancel);
}

} // namespace suffuse
