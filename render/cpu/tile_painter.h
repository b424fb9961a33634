// Paints one tile: every stroke that meets it, from bottom to top.
#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/layer_cache.h"
#include "render/cpu/tile_strokes.h"
#include "render/scene/paper.h"

namespace suffuse::cpu {

/// What all tiles of a picture share.
struct Frame {
    View view;
    Canvas canvas;
    std::shared_ptr<const PaperTexture> paperImage;
    bool transparent = false;
    const Kernels *kernels = nullptr;
};

/// How a tile is painted with layers (render/cpu/layer_cache.h).
struct TilePlan {
    std::size_t below = 0;    ///< so many of its strokes lie below the first edited one and are not in `under`
    TileLayers *layers = nullptr;
    bool haveUnder = false;   ///< in the layers: it is what to start from
    bool storeUnder = false;  ///< into the layers, before the first edited stroke
    bool storeOver = false;   ///< strokes after the first edited one, as a map
    bool applyOver = false;   ///< instead of those strokes
};

/// Evaluates `tile` (its corner on the picture's 8-pixel grid) into `rgba`, rows of tile.width pixels. `strokes` in
/// order; with layers, the one at `plan.below` may be the edited one (`edited` names it).
void paintTile(const Frame &frame, const PixelRect &tile, const TileStrokes &strokes, const TilePlan &plan,
               const SceneStroke *edited, float *rgba);

} // namespace suffuse::cpu
