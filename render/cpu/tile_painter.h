// Paints one tile: every stroke that meets it, from bottom to top.
#pragma once

#include "render/cpu/layer_cache.h"
#include "render/paper.h"
#include "render/scene.h"

#include <array>
#include <optional>
#include <span>

namespace suffuse::cpu {

/// What all tiles of a picture share.
struct Frame {
    View view;
    Canvas canvas;
    std::shared_ptr<const PaperTexture> paperImage;
    bool transparent = false;
    const Kernels *kernels = nullptr;
};

/// Nodes of a stroke, as indices.
using NodeList = std::span<const std::uint32_t>;

/// The strokes that show in a tile, in order, with their nodes by block (rows of blocks first).
class TileStrokes {
public:
    /// Starts a tile of at most gridSide × gridSide blocks; keeps its memory.
    void begin(const Kernels &kernels, const PixelRect &tile);
    /// Adds a stroke; false where it shows nothing in any block.
    bool add(const SceneStroke &stroke);
    std::size_t size() const { return m_strokes.size(); }
    const SceneStroke &operator[](std::size_t i) const { return *m_strokes[i].scene; }
    /// The nodes of stroke `i` that meet a block; none where it shows nothing there.
    std::optional<NodeList> nodesAt(std::size_t i, std::size_t block) const
    {
        const Run &run = m_strokes[i].blocks[block];
        if (run.count < 0)
            return {};
        return NodeList(m_nodes.data() + run.from, std::size_t(run.count));
    }

private:
    struct Run {
        std::uint32_t from = 0;
        int count = -1; ///< negative: it shows nothing
    };
    struct Entry {
        const SceneStroke *scene = nullptr;
        std::array<Run, gridSide * gridSide> blocks;
    };

    const Kernels *m_kernels = nullptr;
    Grid m_grid;
    Area m_area;
    std::vector<Entry> m_strokes;
    std::vector<std::uint32_t> m_nodes, m_runs;
    std::size_t m_used = 0; ///< of m_nodes
};

/// How a tile is painted with layers (render/cpu/layer_cache.h).
struct TilePlan {
    std::size_t below = 0;    ///< so many of its strokes lie below the first edited one; 0 where `under` holds them
    TileLayers *layers = nullptr;
    bool storeUnder = false;  ///< into the layers, before the first edited stroke
    bool storeOver = false;   ///< strokes after the first edited one, as a map
    bool applyOver = false;   ///< instead of those strokes
};

/// Evaluates `tile` (its corner on the picture's 8-pixel grid) into `rgba`, rows of tile.width pixels. `strokes` in
/// order; with layers, the one at `plan.below` may be the edited one (`edited` names it).
void paintTile(const Frame &frame, const PixelRect &tile, const TileStrokes &strokes, const TilePlan &plan,
               const SceneStroke *edited, float *rgba);

} // namespace suffuse::cpu
