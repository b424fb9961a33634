// What a renderer that draws into one target again and again remembers of its last frame, and what the next one must
// evaluate anew.
#pragma once

#include "render/scene/dirty_region.h"
#include "render/scene/live_scene.h"
#include "render/threads/parallel.h"

namespace suffuse {

class FrameHistory {
public:
    static constexpr std::size_t noEdit = SIZE_MAX;

    /// `cull`: see RendererOptions.
    FrameHistory(int tileSize, bool cull) : m_tileSize(tileSize), m_scene(cull) {}

    /// What one frame changes.
    struct Step {
        SceneChange scene;
        bool whole = false;       ///< another target, view or paper: everything is dirty
        bool keepsUnder = false;  ///< layers below the first edited stroke still hold (docs/solver.md, "Layers"),
        bool raisesUnder = false; ///< though they end lower than it now: what lies between rests again;
        bool keepsOver = false;   ///< and those above it
    };
    /// Brings scene and region up to date with the request; resizes the target where its size changes.
    Step advance(const RenderRequest &request, Target &target, Threads threads);
    /// The next step is whole.
    void forget() { m_target = 0; }
    /// Tile (column, row) was drawn; `approximate`: with an over map.
    void drawn(int column, int row, bool approximate)
    {
        m_region.clean(column, row);
        m_approximate[tileIndex(column, row)] = approximate;
        m_anyApproximate |= approximate;
    }
    /// All dirty tiles were drawn, none of them with an over map.
    void drawnAll();

    const LiveScene &scene() const { return m_scene; }
    const DirtyRegion &region() const { return m_region; }
    /// Index in the scene of the first edited stroke, what lies below being worth a layer; or noEdit.
    std::size_t edited() const { return m_edited; }
    /// It alone differs from the frame before.
    bool oneEdited() const { return m_oneEdited; }
    std::size_t tileIndex(int column, int row) const
    {
        return std::size_t(row) * std::size_t(m_region.columns()) + std::size_t(column);
    }

private:
    bool sameFrame(const RenderRequest &request, const Target &target) const;
    void markDifferences(const SceneChange &change, Threads threads);
    /// Where the scene's strokes begin to differ from the last frame's, or noEdit.
    std::size_t firstDifference(const SceneChange &change) const;
    /// Decides which layers still hold and where the edited strokes begin.
    void followEdits(Step &step, bool interactive);

    int m_tileSize;
    LiveScene m_scene;
    DirtyRegion m_region;
    std::size_t m_edited = noEdit;
    bool m_oneEdited = false;
    std::vector<std::uint8_t> m_approximate; ///< tiles drawn with an over map, by index
    bool m_anyApproximate = false;           ///< some of them may be
    View m_view;
    bool m_transparent = false;
    Canvas m_canvas;
    std::uint64_t m_target = 0; ///< serial of the one drawn last
};

} // namespace suffuse
