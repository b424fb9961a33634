// Renderers that are slow, or say so.
#pragma once

#include "render/backends.h"

namespace suffuse {

/// Passes everything on; what came of a frame is changed on its way back.
class SlowRenderer : public Renderer {
public:
    using Slow = std::function<void(const RenderRequest &, RenderStats &)>;

    SlowRenderer(std::unique_ptr<Renderer> renderer, Slow slow)
        : m_renderer(std::move(renderer)), m_slow(std::move(slow))
    {}
    Backend backend() const override { return m_renderer->backend(); }
    QString deviceName() const override { return m_renderer->deviceName(); }
    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        Result<RenderStats> stats = m_renderer->render(request, target, cancel);
        if (stats)
            m_slow(request, *stats);
        return stats;
    }
    void invalidate() override { m_renderer->invalidate(); }

private:
    std::unique_ptr<Renderer> m_renderer;
    Slow m_slow;
};

inline Result<std::unique_ptr<Renderer>> makeSlow(const RendererOptions &options, SlowRenderer::Slow slow)
{
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
    if (!renderer)
        return renderer;
    return std::unique_ptr<Renderer>(std::make_unique<SlowRenderer>(std::move(*renderer), std::move(slow)));
}

} // namespace suffuse
