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
    Result<RenderStats> result = current().render(request, target, cancel);
    if (result || !current().isLost())
        return result;
    const QString notice = QCoreApplication::translate("Renderer", "%1 stopped: %2. The CPU draws now.")
                               .arg(nameOf(current().backend()), result.error());
    replace(m_makeCpu(), notice);
    return current().render(request, target, cancel);
}

} // namespace suffuse
