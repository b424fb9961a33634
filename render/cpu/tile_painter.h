// Paints one tile: all strokes that meet it, from bottom to top.
#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/layer_cache.h"
#include "render/cpu/paper_tiles.h"
#include "render/cpu/tile_strokes.h"

namespace suffuse::cpu {

/// What all tiles of a picture share.
struct Frame {
    PictureGrid grid;
    Canvas canvas;
    PaperTiles *paper = nullptr;
    bool transparent = false;
    const Kernels *kernels = nullptr;
    const Composition *composition = nullptr;
};

/// What is edited: a stroke, or how a layer is put.
struct Edited {
    const SceneStroke *stroke = nullptr;
    std::size_t place = 0; ///< of the stroke among those of the composition
    int layer = Layer::none;
};

/// How a tile is painted with layers (render/cpu/layer_cache.h).
struct TilePlan {
    std::size_t tile = 0;  ///< its place among the tiles of the picture
    std::size_t below = 0; ///< how many of its strokes lie below the first edited one and are not in `under`
    TileLayers *layers = nullptr;
    bool haveUnder = false;  ///< whether `under` of the layers is filled, so that painting starts from it
    bool storeUnder = false; ///< whether `under` is to be filled before the first edited stroke
    bool storeOver = false;  ///< whether what lies above what is edited is to be stored in steps
    bool applyOver = false;  ///< whether these steps are used instead of the strokes there
    bool onlyMet = false;    ///< whether only blocks need be painted that what is edited meets, or met before
};

/// Whether each block of a tile was painted.
using PaintedBlocks = std::array<bool, gridSide * gridSide>;

/// Evaluates `tile`, whose corner lies on the grid's 8-pixel cells, into `rgba`, in rows of tile.width pixels.
/// `strokes` are in order, and know their places among those of the composition. With layers, the one at `plan.below`
/// may be the edited one. Blocks that are not painted have any values.
PaintedBlocks paintTile(const Frame &frame, const PixelRect &tile, TileStrokes &strokes, const TilePlan &plan,
                        const Edited &edited, float *rgba);

} // namespace suffuse::cpu
