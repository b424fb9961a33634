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
    /// A visible stroke's state when it was last seen: enough to tell whether it differs.
    struct Entry {
        StrokePtr stroke;
        std::shared_ptr<const SceneStroke> scene;
        Microseconds driesAt = 0;
        Microseconds time = 0; ///< that the scene was built for
    };
    bool sameFrame(const RenderRequest &request, const Target &target) const;
    void updateScene(const RenderRequest &request);
    /// Brings the entries into the order of the painting's visible strokes, keeping what is known of each.
    void alignEntries(const Painting &painting);
    void markDifferences(const std::vector<std::shared_ptr<const SceneStroke>> &before);
    /// What one call evaluates.
    struct Job {
        int column = 0;
        int row = 0;
        cpu::TilePlan plan;
    };
    /// Strokes of a row of tiles, from the bottom and from the first edited one on.
    struct Row {
        std::vector<cpu::TileStroke> strokes;
        std::size_t below = 0; ///< so many lie below the first edited one
    };

    /// Decides which layers still hold and where the edited strokes begin.
    void updateLayers(const std::vector<std::shared_ptr<const SceneStroke>> &before, bool incremental, bool interactive);
    std::vector<Job> planJobs(bool interactive);
    /// The strokes that meet a row of tiles, with the nodes that do; `fromEdited`: none below the first edited one.
    Row rowStrokes(int row, bool fromEdited) const;
    void paint(const Job &job, const Row &row, Target &target);
    std::size_t tileIndex(int column, int row) const { return std::size_t(row) * std::size_t(m_region.columns()) + std::size_t(column); }

    int m_threads;
    int m_tileSize;
    std::vector<Entry> m_entries; ///< as m_scene
    std::vector<std::shared_ptr<const SceneStroke>> m_scene; ///< visible strokes, bottom to top
    DirtyRegion m_region;
    static constexpr std::size_t noEdit = SIZE_MAX;
    cpu::LayerCache m_layers{std::size_t(48) << 20};
    std::size_t m_edited = noEdit;  ///< index in the scene of the first edited stroke: what lies below is in the layers
    bool m_oneEdited = false;       ///< it alone differs from the frame before
    std::vector<std::uint8_t> m_approximate; ///< tiles drawn with an over map, by index
    cpu::Frame m_frame;
    std::uint64_t m_target = 0; ///< serial of the one drawn last
};

} // namespace suffuse
