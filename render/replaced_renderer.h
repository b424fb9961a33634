// A renderer behind which another one takes over.
#pragma once

#include "render/renderer.h"

#include <mutex>

namespace suffuse {

/// Stands for the renderer that draws now. Any thread may ask for its backend and its notice, also while it is
/// replaced; only the thread that draws replaces it.
class ReplacedRenderer : public Renderer {
public:
    Backend backend() const override;
    QString deviceName() const override;
    QString notice() const override;
    void invalidate() override { m_renderer->invalidate(); }
    bool isLost() const override { return m_renderer->isLost(); }

protected:
    explicit ReplacedRenderer(std::unique_ptr<Renderer> first) : m_renderer(std::move(first)) {}

    Renderer &current() { return *m_renderer; }
    /// From now on `next` draws, if it is one. `notice` is what a user is told unless `next` has something to say.
    void replace(std::unique_ptr<Renderer> next, const QString &notice);

private:
    mutable std::mutex m_mutex; ///< guards both while others ask
    std::unique_ptr<Renderer> m_renderer;
    QString m_notice;
};

} // namespace suffuse
