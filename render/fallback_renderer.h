// Goes on with the CPU where a device fails.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <mutex>

namespace suffuse {

/// Draws with another renderer until that one's device is lost; then draws the same request with the one that stands in
/// for it at once, and all that follow. What it is and its notice may be asked for by any thread.
class FallbackRenderer : public Renderer {
public:
    /// `makeCpu` makes the renderer that draws once `primary` is lost. It cannot fail, and is called once at most.
    FallbackRenderer(std::unique_ptr<Renderer> primary, std::function<std::unique_ptr<Renderer>()> makeCpu);

    Backend backend() const override;
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_renderer->invalidate(); }
    QString notice() const override;

private:
    mutable std::mutex m_mutex; ///< guards what is pointed to while it is named or replaced
    std::unique_ptr<Renderer> m_renderer;
    const std::function<std::unique_ptr<Renderer>()> m_makeCpu;
    QString m_notice;
};

} // namespace suffuse
