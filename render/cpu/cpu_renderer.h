#pragma once

#include "render/cpu/tile_painter.h"
#include "render/dirty_region.h"
#include "render/live_scene.h"

namespace suffuse {

/// Tiles on all cores, evaluating only what differs from the last call.
class CpuRenderer : public Renderer {
public:
    /// `tileSize`: a multiple of 8, 0 for the default; `threads`: 0 for all cores; `cull`: see RendererOptions.
    CpuRenderer(int threads, int tileSize, bool cull = true);

    QString backendName() const override { return QStringLiteral("CPU"); }
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_target = 0; }

private:
    bool sameFrame(const RenderRequest &request, const Target &target) const;
    void markDifferences(const SceneChange &change);
    /// A tile that one call evaluates.
    struct Job {
        int column = 0;
        int row = 0;
        cpu::TilePlan plan;
        std::size_t from = 0, to = 0;       ///< the strokes that it needs, of the scene's order,
        std::vector<std::uint32_t> strokes; ///< and those of them whose bounds meet it
    };

    /// Where the scene's strokes begin to differ from the last frame's, or noEdit.
    std::size_t firstDifference(const SceneChange &change) const;
    /// Decides which layers still hold and where the edited strokes begin.
    void updateLayers(const SceneChange &change, bool interactive);
    void forgetLayers();
    std::vector<Job> planJobs(bool interactive);
    /// Gives each job its strokes: rows of tiles first, then columns, so that it costs what strokes touch.
    void binStrokes(std::vector<Job> &jobs) const;
    void paint(const Job &job, Target &target);
    std::size_t tileIndex(int column, int row) const { return std::size_t(row) * std::size_t(m_region.columns()) + std::size_t(column); }

    int m_threads;
    int m_tileSize;
    LiveScene m_scene;
    DirtyRegion m_region;
    static constexpr std::size_t noEdit = SIZE_MAX;
    cpu::LayerCache m_layers{std::size_t(40) << 20};
    std::size_t m_edited = noEdit;  ///< index in the scene of the first edited stroke: what lies below is in the layers
    bool m_oneEdited = false;       ///< it alone differs from the frame before
    std::vector<std::uint8_t> m_approximate; ///< tiles drawn with an over map, by index
    cpu::Frame m_frame;
    std::uint64_t m_target = 0; ///< serial of the one drawn last
};

} // namespace suffuse
