// A renderer that goes on with the CPU when a device fails.
#pragma once

#include "render/replaced_renderer.h"

#include <functional>

namespace suffuse {

/// Draws with another renderer until its device is lost. Then it draws the same request, and all that follow, with a
/// CPU renderer.
class FallbackRenderer : public ReplacedRenderer {
public:
    /// `makeCpu` makes the renderer that draws once `primary` is lost. It must not fail, and is called at most once.
    FallbackRenderer(std::unique_ptr<Renderer> primary, std::function<std::unique_ptr<Renderer>()> makeCpu);

    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;

private:
    const std::function<std::unique_ptr<Renderer>()> m_makeCpu;
};

} // namespace suffuse
