// Finds which strokes show in a tile, and which of their nodes meet each of its blocks.
#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/prefix_sums.h"
#include "render/cpu/tile_fill.h"

#include <array>
#include <optional>
#include <span>

namespace suffuse::cpu {

/// Nodes of a stroke, as indices.
using NodeList = std::span<const std::uint32_t>;

/// The nodes [from, to) of a stroke.
struct NodeRange {
    std::size_t from = 0, to = 0;
    int size() const { return int(to - from); }
};

ListedNodes listedOf(const SceneStroke &stroke, NodeList nodes);

/// Finds the runs of the nodes' boxes that meet `area`. They are written to `room`, as places in the range.
int findRuns(const Kernels &kernels, const SceneStroke &stroke, const NodeRange &range, const Area &area,
             std::vector<std::uint32_t> &room, Meeting &meeting);

/// Returns false only if a stroke shows nothing in an area that its nodes meet in this way.
bool shows(const SceneStroke &stroke, const Meeting &meeting);

Area areaOf(const Rect &rect);

/// A stroke's fill in a block; null where there is none.
struct BlockFill {
    TileFill *tile = nullptr;
    FillPresence presence = FillPresence::Nothing;

    explicit operator bool() const { return presence != FillPresence::Nothing; }
};

/// Adds bounds of what a fill has in an area.
void include(const SceneFill &fill, FillPresence presence, Meeting &meeting);

/// The strokes that show in a tile, in order, with their nodes by block (rows of blocks first).
class TileStrokes {
public:
    /// Begins a tile of at most gridSide × gridSide blocks. It keeps its memory. `window` is that of the strokes' grid.
    void begin(const Kernels &kernels, const PixelRect &tile, const PixelRect &window);
    /// Adds a stroke, which has this place among all. Its sums start from `prefix` if there is one. Returns false if it
    /// shows nothing in any block.
    bool add(const SceneStroke &stroke, std::size_t place, const StrokePrefix *prefix = nullptr);
    /// Extends `prefix`, which belongs to the tile, to the first `steady` nodes of the stroke.
    void settle(const SceneStroke &stroke, std::size_t steady, StrokePrefix &prefix);

    std::size_t size() const { return m_strokes.size(); }
    const SceneStroke &operator[](std::size_t i) const { return *m_strokes[i].scene; }
    std::size_t placeOf(std::size_t i) const { return m_strokes[i].place; }
    /// The nodes of stroke `i` after its prefix that meet a block. No value if it shows nothing there.
    std::optional<NodeList> nodesAt(std::size_t i, std::size_t block) const
    {
        const Run &run = m_strokes[i].blocks[block];
        if (run.count < 0)
            return {};
        return NodeList(m_nodes.data() + run.from, std::size_t(run.count));
    }
    BlockFill fillAt(std::size_t i, std::size_t block)
    {
        const Entry &entry = m_strokes[i];
        if (entry.fill < 0)
            return {};
        return {m_fills[std::size_t(entry.fill)].get(), entry.presence[block]};
    }
    /// The sums of the nodes before them; empty if there are none.
    std::span<const float> sumsAt(std::size_t i, std::size_t block) const
    {
        const StrokePrefix *prefix = m_strokes[i].prefix;
        return prefix ? std::span(prefix->blocks[block].sums) : std::span<const float>{};
    }

private:
    struct Run {
        std::uint32_t from = 0;
        int count = -1; ///< negative: it shows nothing
    };
    struct Entry {
        const SceneStroke *scene = nullptr;
        std::size_t place = 0;
        const StrokePrefix *prefix = nullptr;
        std::array<Run, gridSide * gridSide> blocks;
        int fill = -1; ///< index in m_fills
        std::array<FillPresence, gridSide * gridSide> presence;
    };
    using Cells = std::array<Meeting, gridSide * gridSide>;

    /// Finds what there is of a stroke's fill in each block. Returns false if there is nothing.
    bool findFill(const SceneStroke &stroke, Entry &entry);
    /// Lists the nodes in the first runs of m_runs by block, behind the part of m_nodes that is in use. Returns the
    /// room of a block.
    std::size_t list(const SceneStroke &stroke, const NodeRange &range, int runs, Cells &cells);
    std::size_t blockCount() const { return std::size_t(m_grid.columns * m_grid.rows); }

    const Kernels *m_kernels = nullptr;
    PixelRect m_tile;
    Grid m_grid; ///< the blocks, in pixels from the corner of the window, as boxes are
    Area m_area;
    std::vector<Entry> m_strokes;
    std::vector<std::unique_ptr<TileFill>> m_fills; ///< some of which are in use; they keep their memory
    std::size_t m_usedFills = 0;
    std::vector<std::uint32_t> m_nodes, m_runs;
    std::size_t m_used = 0; ///< how much of m_nodes is in use
};

} // namespace suffuse::cpu
