// Paints one tile: every stroke that meets it, from bottom to top.
#pragma once

#include "render/paper.h"
#include "render/scene.h"

namespace suffuse::cpu {

/// What all tiles of a picture share.
struct Frame {
    View view;
    Canvas canvas;
    std::shared_ptr<const PaperTexture> paperImage;
    bool transparent = false;
    const Kernels *kernels = nullptr;
};

/// A stroke's nodes that may touch a tile, in the stroke's order.
struct TileStroke {
    const SceneStroke *stroke = nullptr;
    std::vector<const ViewNode *> nodes;
    int separable = 0; ///< the first ones, with b = 0
};

/// Keeps a stroke's nodes whose boxes meet `area` (pixels); false where they add nothing there.
bool selectNodes(const Kernels &kernels, const SceneStroke &stroke, const std::vector<const ViewNode *> &nodes,
                 const Rect &area, TileStroke &out);

/// Evaluates `tile` (its corner on the picture's 8-pixel grid) into `rgba`, rows of tile.width pixels.
void paintTile(const Frame &frame, const PixelRect &tile, const std::vector<TileStroke> &strokes, float *rgba);

} // namespace suffuse::cpu
