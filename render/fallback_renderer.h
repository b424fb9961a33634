// A renderer that goes on with the CPU when a device fails, or cannot draw a painting.
#pragma once

#include "render/replaced_renderer.h"

#include <functional>

namespace suffuse {

/// Draws with another renderer until its device is lost. Then it draws the same request, and all that follow, with a
/// CPU renderer. Paintings that the other one cannot draw are drawn by the CPU, too, one by one.
class FallbackRenderer : public ReplacedRenderer {
public:
    /// `makeCpu` makes the renderer that draws instead of `primary`. It must not fail, and is called at most once.
    FallbackRenderer(std::unique_ptr<Renderer> primary, std::function<std::unique_ptr<Renderer>()> makeCpu);

    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;

private:
    /// Lets the one draw that can draw the painting.
    void choose(const Painting &painting);

    const std::function<std::unique_ptr<Renderer>()> m_makeCpu;
    std::unique_ptr<Renderer> m_aside; ///< the one of both that does not draw now; null before the CPU was needed
    bool m_cpuDraws = false;
};

} // namespace suffuse
