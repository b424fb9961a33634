#include "render/replaced_renderer.h"

namespace suffuse {

Backend ReplacedRenderer::backend() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->backend();
}

QString ReplacedRenderer::deviceName() const
{
    const std::lock_guard lock(m_mutex);
    return m_renderer->deviceName();
}

QString ReplacedRenderer::notice() const
{
    const std::lock_guard lock(m_mutex);
    const QString own = m_renderer->notice();
    return own.isEmpty() ? m_notice : own;
}

void ReplacedRenderer::replace(std::unique_ptr<Renderer> next, const QString &notice)
{
    const std::lock_guard lock(m_mutex);
    if (next)
        m_renderer.swap(next);
    m_notice = notice;
}

} // namespace suffuse
