// Goes on with the CPU where a device fails.
#pragma once

#include "render/renderer.h"

#include <mutex>

namespace suffuse {

/// Draws with another renderer until that one's device is lost; then draws the same request with a CpuRenderer at once,
/// and all that follow. Its names and its notice may be asked for by any thread.
class FallbackRenderer : public Renderer {
public:
    /// `options`: for the CPU.
    FallbackRenderer(std::unique_ptr<Renderer> primary, const RendererOptions &options);

    QString backendName() const override;
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_renderer->invalidate(); }
    QString notice() const override;

private:
    mutable std::mutex m_mutex; ///< guards what is pointed to while it is named or replaced
    std::unique_ptr<Renderer> m_renderer;
    RendererOptions m_options;
    QString m_notice;
};

} // namespace suffuse
