#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/tile_painter.h"
#include "render/scene/frame_history.h"
#include "render/threads/parallel.h"

namespace suffuse {

/// Tiles on all cores, evaluating only what differs from the last call.
class CpuRenderer : public Renderer {
public:
    /// `tileSize`: a multiple of 8, 0 for the default; `threads`: 0 for all cores; `cull`: see RendererOptions.
    CpuRenderer(int threads, int tileSize, bool cull = true);

    Backend backend() const override { return Backend::Cpu; }
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_history.forget(); }

private:
    /// A tile that one call evaluates.
    struct Job {
        int column = 0;
        int row = 0;
        cpu::TilePlan plan;
        std::size_t from = 0, to = 0;       ///< the strokes that it needs, of the scene's order,
        std::vector<std::uint32_t> strokes; ///< and those of them whose bounds meet it
    };

    /// Drops layers that no longer hold, and finds what of the changed strokes stays.
    void followEdits(const FrameHistory::Step &step);
    std::vector<Job> planJobs(bool interactive);
    /// Gives each job its strokes: rows of tiles first, then columns, so that it costs what strokes touch.
    void binStrokes(std::vector<Job> &jobs) const;
    /// Sums of what stays of a stroke that changes, for the job's tile; null where nothing does.
    const cpu::StrokePrefix *prefixOf(const Job &job, std::uint32_t stroke, cpu::TileStrokes &strokes) const;
    void paint(const Job &job, Target &target);

    const Threads m_threads;
    FrameHistory m_history;
    cpu::LayerCache m_layers{std::size_t(64) << 20};
    std::vector<cpu::SteadyStroke> m_changed; ///< strokes that differ from the frame before, ascending
    cpu::Frame m_frame;
};

} // namespace suffuse
