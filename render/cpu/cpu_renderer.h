#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/tile_painter.h"
#include "render/scene/frame_history.h"
#include "render/threads/parallel.h"

namespace suffuse {

/// Draws tiles on all cores, and evaluates only what differs from the last call.
class CpuRenderer : public Renderer {
public:
    /// `tileSize` is a multiple of 8, or 0 for the default; `threads` is 0 for all cores; for `cull` see
    /// RendererOptions.
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
        std::size_t from = 0, to = 0;       ///< the range of the scene's order with the strokes that it needs,
        std::vector<std::uint32_t> strokes; ///< and those of them whose bounds meet the tile
    };

    /// Drops layers that are no longer valid, and finds what stays of the changed strokes.
    void followEdits(const FrameHistory::Step &step);
    /// Whether what lies above what is edited can be kept: one stroke or layer is edited, and it bounds no layer.
    bool keepsOver() const;
    std::vector<Job> planJobs(bool interactive);
    /// Gives each job its strokes, by rows of tiles first and then by columns, so that the cost is in proportion to
    /// what strokes touch.
    void binStrokes(std::vector<Job> &jobs) const;
    /// The sums of what stays of a stroke that changes, for the job's tile; null if nothing stays.
    const cpu::StrokePrefix *prefixOf(const Job &job, std::uint32_t stroke, cpu::TileStrokes &strokes) const;
    /// Returns a box in the picture around what was painted.
    PixelRect paint(const Job &job, Target &target);
    /// Stores what was painted of a tile, and returns a box around it.
    PixelRect store(const PixelRect &tile, const cpu::PaintedBlocks &painted, const float *rgba, Target &target) const;

    const Threads m_threads;
    FrameHistory m_history;
    cpu::LayerCache m_layers{std::size_t(256) << 20};
    std::vector<cpu::SteadyStroke> m_changed; ///< the strokes that differ from the frame before, in ascending order
    cpu::Frame m_frame;
    cpu::PaperTiles m_paper;
};

} // namespace suffuse
