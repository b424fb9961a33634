// Which strokes and nodes can be seen in a tile.
#pragma once

#include "render/gradient/scene_nodes.h"
#include "render/gradient/tile_data.h"
#include "render/threads/unset_vector.h"

namespace suffuse::gradient {

/// Nodes of one segment or fill, among those of a tile.
struct TileRun {
    std::uint32_t segment, first, end;
};

/// A stroke that can be seen in a tile, with its runs there: those that make it paler, from firstRun on, then those of
/// its paint, from firstPaint on. That of its fill is the last one.
struct TileStroke {
    std::uint32_t stroke, firstRun, firstPaint, endRun;
};

/// What can be seen in a tile, in the order of the strokes. It keeps its memory.
struct TileList {
    std::vector<TileStroke> strokes;
    std::vector<TileRun> runs;
    UnsetVector<std::uint32_t> nodes;
};

/// What is found out about the strokes of a scene once for all tiles.
class StrokeFinder {
public:
    using FindNodes = std::size_t (*)(const NodeSearch &, std::uint32_t *);
    explicit StrokeFinder(FindNodes findNodes) : m_findNodes(findNodes) {}

    /// Prepares for a scene; what stands in `nodes` must stay until the next call.
    void prepare(const FlatScene &scene, const SceneNodes &nodes, int columns, int rows);
    /// Lists what can be seen in the tile in this column and row.
    void list(int column, int row, TileList &out) const;

private:
    struct Reach {
        std::uint32_t stroke;
        float left, top, right, bottom; ///< pixels
        float level;                    ///< its style shows nothing below this density
        bool fades;                     ///< whether some of its segments make it paler
    };
    void addStroke(const Reach &reach, float x, float y, TileList &out) const;
    /// Adds the nodes of a segment or fill that reach a tile. Returns whether there are any.
    bool addRun(std::uint32_t segment, float x, float y, TileList &out) const;
    /// Adds the nodes of a fill. Returns whether it can be seen in the tile.
    bool addFill(std::uint32_t fill, float x, float y, TileList &out) const;

    FindNodes m_findNodes;
    const FlatScene *m_scene = nullptr;
    const SceneNodes *m_nodes = nullptr;
    std::vector<std::vector<Reach>> m_rows; ///< the strokes that reach each row of tiles, in their order
};

} // namespace suffuse::gradient
