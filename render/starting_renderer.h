// A renderer that draws by the CPU while a device starts.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <future>
#include <mutex>

namespace suffuse {

/// Draws with `meanwhile` until another renderer has been made, and with that one from the next request on. A device
/// takes a third of a second to start, and nobody should wait for that to see a painting. Each picture is drawn by one
/// of the two alone: the other one begins with a whole picture. Any thread may ask for its backend and its notice.
class StartingRenderer : public Renderer {
public:
    using Make = std::function<Result<std::unique_ptr<Renderer>>()>;

    /// `make` is called on a thread of its own, at once. Where it fails, `meanwhile` goes on, and the notice says why.
    StartingRenderer(std::unique_ptr<Renderer> meanwhile, Make make);

    Backend backend() const override;
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_renderer->invalidate(); }
    QString notice() const override;
    bool isLost() const override { return m_renderer->isLost(); }

private:
    /// Replaces the renderer if the other one is there.
    void takeOver();

    mutable std::mutex m_mutex; ///< guards the pointer and the notice while others ask
    std::unique_ptr<Renderer> m_renderer;
    QString m_notice;
    std::future<Result<std::unique_ptr<Renderer>>> m_starting; ///< not valid once it has been taken; waits when it ends
};

} // namespace suffuse
