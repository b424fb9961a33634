#include "render/fallback_renderer.h"

#include <QCoreApplication>

namespace suffuse {

FallbackRenderer::FallbackRenderer(std::unique_ptr<Renderer> primary,
                                   std::function<std::unique_ptr<Renderer>()> makeCpu)
    : ReplacedRenderer(std::move(primary)), m_makeCpu(std::move(makeCpu))
{}

Result<RenderStats> FallbackRenderer::render(const RenderRequest &request, Target &target,
                                             const std::atomic<bool> *cancel)
{
    choose(*request.painting);
    Result<RenderStats> result = current().render(request, target, cancel);
    if (result || !current().isLost())
        return result;
    const QString notice = QCoreApplication::translate("Renderer", "%1 stopped: %2. The CPU draws now.")
                               .arg(nameOf(current().backend()), result.error());
    replace(m_aside ? std::move(m_aside) : m_makeCpu(), notice);
    m_aside.reset();
    m_cpuDraws = true;
    current().invalidate(); // It may have drawn another painting into this target before.
    return current().render(request, target, cancel);
}

void FallbackRenderer::choose(const Painting &painting)
{
    if (m_cpuDraws && !m_aside)
        return; // The device is lost.
    Renderer &device = m_cpuDraws ? *m_aside : current();
    const QString problem = device.problemWith(painting);
    if (problem.isEmpty() == !m_cpuDraws)
        return;
    const QString notice =
        problem.isEmpty() ? QString()
                          : QCoreApplication::translate("Renderer", "%1. The CPU draws this painting.").arg(problem);
    m_aside = replace(m_aside ? std::move(m_aside) : m_makeCpu(), notice);
    m_cpuDraws = !m_cpuDraws;
    current().invalidate(); // Meanwhile the other one has drawn into its target.
}

} // namespace suffuse
