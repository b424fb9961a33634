// A renderer that draws by the CPU while a device starts.
#pragma once

#include "render/replaced_renderer.h"

#include <functional>
#include <future>

namespace suffuse {

/// Draws with `meanwhile` until another renderer has been made, and with that one from the next request on. A device
/// takes a third of a second to start, and nobody should wait for that to see a painting. Each picture is drawn by one
/// of the two alone: the other one begins with a whole picture.
class StartingRenderer : public ReplacedRenderer {
public:
    using Make = std::function<Result<std::unique_ptr<Renderer>>()>;

    /// `make` is called on a thread of its own, at once. Where it fails, `meanwhile` goes on, and the notice says why.
    StartingRenderer(std::unique_ptr<Renderer> meanwhile, Make make);

    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;

private:
    /// Replaces the renderer if the other one is there.
    void takeOver();

    std::future<Result<std::unique_ptr<Renderer>>> m_starting; ///< not valid once it has been taken; waits when it ends
};

} // namespace suffuse
