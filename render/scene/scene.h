// A painting prepared for one view: strokes in order, with their nodes in pixels.
#pragma once

#include "render/math/shade_params.h"
#include "render/nodes/node_builder.h"
#include "render/renderer.h"
#include "render/scene/node_boxes.h"
#include "render/threads/parallel.h"

#include <unordered_map>

namespace suffuse {

/// Double-precision node of a segment so wide on screen (s > deepSpread px) that floats would lose its edge.
struct DeepNode {
    double x = 0, y = 0;        ///< pixels
    double a = 0, b = 0, c = 0; ///< px⁻²
    double weight = 0;
    std::uint32_t row = 0;
};

/// A segment with s < 1 px (4 px where it takes paint away): the pixels that it reaches are supersampled 2^level ×
/// 2^level.
struct SmallSegment {
    int level = 0;
    Rect reach; ///< canvas units
};

struct SceneStroke {
    StrokePtr stroke;
    std::shared_ptr<const StrokeNodes> source;
    PixelRect bounds;            ///< pixels of the picture that it can touch; empty: none
    UnsetVector<ViewNode> nodes; ///< the separable ones first
    NodeBoxStore boxes;          ///< of `nodes`
    int separable = 0;
    std::vector<DeepNode> deep;
    std::vector<SmallSegment> small;
    ShadeParams shade;
    float level[3] = {0, 0,
                      0}; ///< of each kind of style: it shows nothing where densities stay below (render/math/style.h)
    bool hasLevels = false;
    float lowest = -1; ///< of the levels: a density above shows in any case
    int channels = 0;
    std::vector<float> values; ///< channels a row of `source`
    float keep = 1;            ///< eq 23: 1 − β
    bool granulated = false;
    std::vector<PixelRect> groupBounds; ///< as pixelBounds, of each group of `source`; only where that was asked for
    std::shared_ptr<const SceneStroke> dry; ///< the same once it has dried, where LiveScene has seen it so in this view
};

/// True only where opacity is exactly zero for every density φ⁺ and slope (per pixel) up to these.
inline bool canVanish(const SceneStroke &stroke, float density, float slope)
{
    if (!stroke.hasLevels || density > stroke.lowest)
        return false;
    for (int k = 0; k < stroke.shade.kinds; ++k)
        if (!vanishes(stroke.shade, k, stroke.level[k], density * 1.001f, 0.5f * slope * 1.001f))
            return false;
    return true;
}

/// Pixels that a group can change, rounded outwards and cut to the picture.
PixelRect pixelBounds(const StrokeNodes &nodes, const NodeGroup &group, Point origin, const View &view);

/// `changes`: it will be compared with what it becomes, group by group. The same bits for any number of threads.
SceneStroke makeSceneStroke(StrokePtr stroke, std::shared_ptr<const StrokeNodes> nodes, const View &view,
                            Threads threads = 1, bool changes = false);

/// The canvas as the view shows it, as a box in canvas units.
Rect visibleBox(const View &view);

} // namespace suffuse
