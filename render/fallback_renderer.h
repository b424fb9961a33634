// A renderer that goes on with the CPU when a device fails.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <mutex>

namespace suffuse {

/// Draws with another renderer until its device is lost. Then it draws the same request, and all that follow, with a
/// CPU renderer. Any thread may ask for its backend and its notice.
class FallbackRenderer : public Renderer {
public:
    /// `makeCpu` makes the renderer that draws once `primary` is lost. It must not fail, and is called at most once.
    FallbackRenderer(std::unique_ptr<Renderer> primary, std::function<std::unique_ptr<Renderer>()> makeCpu);

    Backend backend() const override;
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_renderer->invalidate(); }
    QString notice() const override;

private:
    mutable std::mutex m_mutex; ///< guards the pointer while the renderer is named or replaced
    std::unique_ptr<Renderer> m_renderer;
    const std::function<std::unique_ptr<Renderer>()> m_makeCpu;
    QString m_notice;
};

} // namespace suffuse
