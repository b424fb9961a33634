#include "render/starting_renderer.h"

#include <chrono>

namespace suffuse {

StartingRenderer::StartingRenderer(std::unique_ptr<Renderer> meanwhile, Make make)
    : ReplacedRenderer(std::move(meanwhile)), m_starting(std::async(std::launch::async, std::move(make)))
{}

void StartingRenderer::takeOver()
{
    if (!m_starting.valid() || m_starting.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    Result<std::unique_ptr<Renderer>> started = m_starting.get();
    if (started)
        replace(std::move(*started), {});
    else
        replace(nullptr, started.error());
}

Result<RenderStats> StartingRenderer::render(const RenderRequest &request, Target &target,
                                             const std::atomic<bool> *cancel)
{
    takeOver();
    return current().render(request, target, cancel);
}

} // namespace suffuse
