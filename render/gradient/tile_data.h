// What a tile is computed from and to, and the loops that do it.
#pragma once

#include "render/gradient/flat_scene.h"

#include <cstddef>
#include <cstdint>

namespace suffuse::gradient {

/// A tile has so many pixels on each side; those beyond the picture are computed and left out.
inline constexpr int tileSide = 16, tileSize = tileSide * tileSide;
/// Values that may vary along a stroke: R, Y, B, opacity, ω; then φ⁺ itself.
inline constexpr int values = 5, planes = values + 1;

/// What nodes are places on: a segment, or the outline of a fill.
enum class Source : std::uint8_t { Segment, Outline };

/// A node as a tile sees it, in pixels. That of a segment is weight · (e^(−u²) − cut) (e^(−v²) − cut), both cut off at
/// 0; that of an outline weight · ½erfc(−u) (e^(−v²) − cut).
template <class Number>
struct TileNode {
    Number x, y;    ///< from the centre of the tile's first pixel
    Number inverse; ///< 1/s
    Number weight;  ///< negative if it takes paint away
    Number cut;
    Number reach; ///< R s, pixels
};

/// Derivatives of a loss by a node's numbers.
template <class Number>
struct NodeSlopes {
    Number weight, x, y, spread;
};

/// What a stroke does with its density.
template <class Number>
struct Shading {
    StyleKind kind;
    Number xi[3];
    Number keep;             ///< 1 − β
    Number constant[values]; ///< what does not vary
    bool varies;             ///< whether values are taken from planes
    bool fades;              ///< whether less of the opacity is left
    Number leastLaid; ///< of φ⁺ where values are divided by it: outside of a fill errors of its nodes are left
};

/// What the pixels of a vector show of a stroke, so that most need not be looked at on the way back.
enum class Shown : std::uint8_t { Nothing, Something, FullPaint };

/// φ, −½∂φ/∂x, −½∂φ/∂y of a stroke at the pixels of a tile; and what the way back needs: the R, Y, B below it, and F
/// with its derivatives by φ′ and h².
template <class Number>
struct alignas(64) StrokeTile {
    Number sums[3][tileSize];
    Number below[3][tileSize];
    Number mean[tileSize], byDensity[tileSize], bySquare[tileSize];
    Number left[tileSize]; ///< e^(−φ_f), which is left of the opacity; only where a stroke fades
    Shown shown[tileSize]; ///< at the first pixel of each vector
};

/// Σφ_k·value over the nodes that lay paint, and φ⁺.
template <class Number>
struct alignas(64) ValueTile {
    Number sums[planes][tileSize];
};

/// R, Y, B or R, G, B of a tile, or the derivatives of a loss by them.
template <class Number>
struct alignas(64) ColourTile {
    Number v[3][tileSize];
};

/// Derivatives by the sums of a stroke.
template <class Number>
struct alignas(64) SumSlopes {
    Number sums[3][tileSize];
    Number planes[gradient::planes][tileSize]; ///< only of what varies
    Number fading[3][tileSize];                ///< by φ_f, and by its slopes, which are 0; only of what fades
    int firstRow, endRow;                      ///< all others are 0
};

/// Derivatives by what is the same at all pixels.
template <class Number>
struct StrokeSlopes {
    Number xi[3];
    Number constant[values];
};

/// Which of some nodes are looked for: those whose distance from the pixels of a tile is `near` at most. If
/// `leftwards`, pixels reach to the left without end.
struct NodeSearch {
    const float *x, *y;       ///< places of nodes, pixels
    std::uint32_t first, end; ///< the nodes to look through
    float left, top;          ///< centre of the tile's first pixel
    float near;
    bool leftwards = false;
};
/// There must be room for so many more nodes than are found.
inline constexpr int searchMargin = 16;

template <class Number>
struct TileKernels {
    /// Writes down the nodes that are found, in their order. Returns their number.
    std::size_t (*findNodes)(const NodeSearch &search, std::uint32_t *found);
    /// Sets sums to those of nodes, or adds them if `add`. `source`: what all of them are.
    void (*accumulate)(Source source, const TileNode<Number> *nodes, int count, bool add, Number (*sums)[tileSize]);
    /// Adds the nodes of one segment, which lays paint, or of a fill to the planes.
    void (*addValues)(Source source, const TileNode<Number> *nodes, int count, const double *value,
                      ValueTile<Number> &to);
    /// Sets e^(−φ_f) of nodes that make paint paler.
    void (*fade)(const TileNode<Number> *nodes, int count, Number *left);
    /// Mixes a stroke, whose sums are there, into the R, Y, B of a tile. `eta` is the paper, or null for 1. With `keep`
    /// it writes down what the way back needs.
    void (*mixStroke)(const Shading<Number> &how, StrokeTile<Number> &stroke, const ValueTile<Number> *varying,
                      const Number *eta, bool keep, ColourTile<Number> &ryb);
    void (*toRgb)(const ColourTile<Number> &ryb, ColourTile<Number> &rgb);
    /// Replaces ∂L/∂(R, G, B) by ∂L/∂(R, Y, B).
    void (*rgbBack)(const ColourTile<Number> &ryb, ColourTile<Number> &by);
    /// Replaces the derivatives by what is above a stroke by those by what is below it, and finds those by the stroke.
    /// Returns false if these are all 0.
    bool (*strokeBack)(const Shading<Number> &how, const StrokeTile<Number> &stroke, const ValueTile<Number> *varying,
                       const Number *eta, bool xi, ColourTile<Number> &by, SumSlopes<Number> &out,
                       StrokeSlopes<Number> &constants);
    /// Finds the derivatives by nodes from those by sums.
    void (*nodesBack)(Source source, const TileNode<Number> *nodes, int count, const Number (*bySums)[tileSize],
                      int firstRow, int endRow, NodeSlopes<Number> *out);
    /// The same for the nodes of one segment that lays paint or of a fill, whose values vary; `byValue` gets the
    /// derivatives by these.
    void (*valuesBack)(Source source, const TileNode<Number> *nodes, int count, const double *value,
                       const SumSlopes<Number> &by, NodeSlopes<Number> *out, Number *byValue);
};

} // namespace suffuse::gradient
