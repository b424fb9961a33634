// What a renderer that draws into one target again and again remembers of its last frame, and what must be evaluated
// anew for the next one.
#pragma once

#include "render/scene/dirty_region.h"
#include "render/scene/live_scene.h"
#include "render/threads/parallel.h"

namespace suffuse {

class FrameHistory {
public:
    static constexpr std::size_t noEdit = SIZE_MAX;

    /// `cull`: see RendererOptions. `bulk`: see LiveScene.
    FrameHistory(int tileSize, bool cull, BulkNodeBuilder *bulk = nullptr) : m_tileSize(tileSize), m_scene(cull, bulk)
    {}

    /// What one frame changes.
    struct Step {
        SceneChange scene;
        bool whole = false; ///< whether everything is dirty, since target, view or paper changed
        bool moved = false; ///< whether the target's pixels were moved, and what came into view is dirty
        /// whether layers below the first edited stroke are still valid (docs/solver.md, "Layers"),
        bool keepsUnder = false;
        bool raisesUnder = false; ///< though they end below it, since what lies between no longer changes;
        bool keepsOver = false;   ///< and whether those above it are
    };
    /// Brings scene and region up to date with the request, whose picture lies in `grid`. Resizes the target if its
    /// size changes. Where the view moved by whole pixels, and nothing else changed, it moves the target's pixels.
    /// `stop`: as in LiveScene::update.
    Step advance(const RenderRequest &request, const PictureGrid &grid, Target &target, Threads threads,
                 const std::atomic<bool> *stop = nullptr);
    /// Forgets the last frame, so that the next step is whole.
    void forget() { m_target = 0; }
    /// Notes that a tile was drawn; `approximate` says that an over map was used.
    void drawn(int column, int row, bool approximate)
    {
        m_region.clean(column, row);
        m_approximate[tileIndex(column, row)] = approximate;
        m_anyApproximate |= approximate;
    }
    /// Notes that all dirty tiles were drawn without an over map.
    void drawnAll();

    const PictureGrid &grid() const { return m_grid; }
    const LiveScene &scene() const { return m_scene; }
    const DirtyRegion &region() const { return m_region; }
    /// The index in the scene of the first edited stroke, if what lies below it is worth a layer; otherwise noEdit.
    std::size_t edited() const { return m_edited; }
    /// Whether that stroke alone differs from the frame before.
    bool oneEdited() const { return m_edits == Edits::OneStroke; }
    /// The layer, which begins with that stroke, whose opacity or mode alone differs from the frame before; or
    /// Layer::none.
    int layerEdited() const { return m_edits == Edits::OnePut ? m_layer : Layer::none; }
    std::size_t tileIndex(int column, int row) const
    {
        return std::size_t(row) * std::size_t(m_region.columns()) + std::size_t(column);
    }

private:
    /// What differs from the frame before.
    enum class Edits : std::uint8_t { Other, OneStroke, OnePut };

    bool samePaper(const RenderRequest &request, const Target &target) const;
    /// Moves the target's pixels to where they lie now, if that is all that the request asks for.
    bool move(const RenderRequest &request, const PictureGrid &grid, Target &target);
    void markDifferences(const SceneChange &change, Threads threads);
    /// Where the scene's strokes begin to differ from those of the last frame, or noEdit.
    std::size_t firstDifference(const SceneChange &change) const;
    /// Decides which layers are still valid, and where the edited strokes begin.
    void followEdits(Step &step, bool interactive);

    int m_tileSize;
    LiveScene m_scene;
    DirtyRegion m_region;
    std::size_t m_edited = noEdit;
    Edits m_edits = Edits::Other, m_kept = Edits::Other; ///< now, and when layers above were kept
    int m_layer = Layer::none;                           ///< the one that was put anew last
    std::vector<std::uint8_t> m_approximate;             ///< whether each tile was drawn with an over map
    bool m_anyApproximate = false;                       ///< whether some of them may be
    PictureGrid m_grid;
    PaintingPtr m_painting;
    Microseconds m_time = 0;
    bool m_transparent = false;
    Canvas m_canvas;
    std::uint64_t m_target = 0; ///< the serial of the target that was drawn last
};

} // namespace suffuse
