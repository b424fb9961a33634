#include "render/starting_renderer.h"

#include <chrono>

namespace suffuse {

StartingRenderer::StartingRenderer(std::unique_ptr<Renderer> meanwhile, Make make)
    : m_renderer(std::move(meanwhile)), m_starting(std::async(std::launch::async, std::move(make)))
{}

Backend StartingRenderer::backend() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->backend();
}

QString StartingRenderer::deviceName() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->deviceName();
}

QString StartingRenderer::notice() const
{
    const std::lock_guard lock(m_mutex);
    const QString own = m_renderer->notice();
    return own.isEmpty() ? m_notice : own;
}

void StartingRenderer::takeOver()
{
    if (!m_starting.valid() || m_starting.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    Result<std::unique_ptr<Renderer>> started = m_starting.get();
    const std::lock_guard lock(m_mutex);
    if (started)
        m_renderer = std::move(*started);
    else
        m_notice = started.error();
}

Result<RenderStats> StartingRenderer::render(const RenderRequest &request, Target &target,
                                             const std::atomic<bool> *cancel)
{
    takeOver();
    return m_renderer->render(request, target, cancel);
}

} // namespace suffuse
