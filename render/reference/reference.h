// The truth: the contract of a picture in double precision, as plainly as it can be computed (docs/reference.md).
#pragma once

#include "render/renderer.h"
#include "render/threads/parallel.h"

namespace suffuse {

/// Always draws the whole picture, a band of rows at a time on each thread. `cancel` is checked before every band and
/// every stroke. It shares no mathematics with the other backends.
class ReferenceRenderer : public Renderer {
public:
    /// `threads` is 0 for all cores.
    explicit ReferenceRenderer(int threads);

    Backend backend() const override { return Backend::Reference; }
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override {}

private:
    const Threads m_threads;
};

std::unique_ptr<Renderer> makeReferenceRenderer(int threads);

} // namespace suffuse
