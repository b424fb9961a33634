// Draws one tile, and goes back through it.
#pragma once

#include "render/gradient/tile_kernels.h"
#include "render/gradient/tile_list.h"

namespace suffuse::gradient {

/// Derivatives by all that a tile shows, in the order of its list: what the tiles write, each for itself, and what is
/// added up in the order of the tiles.
template <class Number>
struct TileSlopes {
    std::vector<NodeSlopes<Number>> nodes;
    std::vector<StrokeSlopes<Number>> strokes;
    std::vector<Number> values; ///< `values` of each run, where they vary
};

/// The pixels of a tile that lie within the picture.
struct TilePlace {
    int x, y, width, height;
};

/// The memory of one thread: all that the way back through a tile needs.
template <class Number>
class TileWork {
public:
    /// Takes the R, Y, B of the scene's ground, and its paper, for the pixels of a tile.
    void begin(const FlatScene &scene, const TilePlace &place);
    /// Mixes all strokes of the list. `keep`: for `back`.
    void draw(const FlatScene &scene, const SceneNodes &nodes, const TileList &list, bool keep);
    /// R, G, B of what was drawn.
    const ColourTile<Number> &rgb();
    /// Takes ∂L/∂(R, G, B) of the tile.
    ColourTile<Number> &slopes() { return m_by; }
    /// Goes back from them through all strokes.
    void back(const FlatScene &scene, const SceneNodes &nodes, const TileList &list, TileSlopes<Number> &out);

private:
    static Shading<Number> shadingOf(const FlatScene &scene, const FlatStroke &stroke);
    void strokeBack(const FlatScene &scene, const SceneNodes &nodes, const TileList &list, std::size_t at,
                    TileSlopes<Number> &out);

    const TileKernels<Number> &m_kernels = tileKernels<Number>();
    TilePlace m_place{};
    bool m_paper = false;
    alignas(64) Number m_eta[tileSize];
    ColourTile<Number> m_ryb, m_rgb, m_by;
    SumSlopes<Number> m_bySums{};
    std::vector<TileNode<Number>> m_nodes;
    std::vector<StrokeTile<Number>> m_strokes;
    std::vector<ValueTile<Number>> m_values; ///< of strokes whose values vary
};

extern template class TileWork<float>;
extern template class TileWork<double>;

} // namespace suffuse::gradient
