#pragma once

#include "render/cpu/tile_painter.h"
#include "render/dirty_region.h"

namespace suffuse {

/// Tiles on all cores, evaluating only what differs from the last call.
class CpuRenderer : public Renderer {
public:
    /// `tileSize`: a multiple of 8, 0 for the default; `threads`: 0 for all cores.
    CpuRenderer(int threads, int tileSize);

    QString backendName() const override { return QStringLiteral("CPU"); }
    QString deviceName() const override;
    Result<RenderStats> render(const RenderRequest &request, Target &target,
                               const std::atomic<bool> *cancel = nullptr) override;
    void invalidate() override { m_target = 0; }

private:
    /// A stroke's state when it was last seen: enough to tell whether it differs.
    struct Entry {
        std::shared_ptr<const SceneStroke> scene;
        bool dry = false; ///< no segment spreads any more at the time it was built for
        Microseconds time = 0;
        std::uint64_t seen = 0;
    };
    bool sameFrame(const RenderRequest &request, const Target &target) const;
    void updateScene(const RenderRequest &request);
    void markDifferences(const std::vector<std::shared_ptr<const SceneStroke>> &before);
    /// The strokes that meet a row of tiles, with the nodes that do.
    std::vector<cpu::TileStroke> rowStrokes(int row) const;
    void paint(int column, int row, const std::vector<cpu::TileStroke> &strokes, Target &target);

    int m_threads;
    int m_tileSize;
    std::unordered_map<StrokeId, Entry> m_entries;
    std::vector<std::shared_ptr<const SceneStroke>> m_scene; ///< visible strokes, bottom to top
    std::uint64_t m_generation = 0;
    DirtyRegion m_region;
    cpu::Frame m_frame;
    std::uint64_t m_target = 0; ///< serial of the one drawn last
};

} // namespace suffuse
