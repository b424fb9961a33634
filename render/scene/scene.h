// A painting prepared for one view: its strokes in order, with their nodes in pixels.
#pragma once

#include "render/math/shade_params.h"
#include "render/nodes/node_builder.h"
#include "render/picture_grid.h"
#include "render/renderer.h"
#include "render/scene/node_boxes.h"
#include "render/scene/picture.h"
#include "render/scene/scene_fill.h"
#include "render/threads/parallel.h"

#include <unordered_map>

namespace suffuse {

/// A node in double precision, of a segment so wide on the screen (s > deepSpread px) that floats would lose its edge.
struct DeepNode {
    double x = 0, y = 0;        ///< pixels
    double a = 0, b = 0, c = 0; ///< px⁻²
    double weight = 0;
    std::uint32_t row = 0;
};

/// A segment with s < 1 px (4 px if it lifts paint, 2 px if it fades it). The pixels that it reaches are supersampled
/// 2^level × 2^level.
struct SmallSegment {
    int level = 0;
    int quarter = 0; ///< below levelQuarters; 2^level·s ≥ 2^(1 − (quarter + 1)/4) px (or liftFineness times that)
    Rect reach;      ///< canvas units
};

/// Small segments are looked for in runs of so many.
inline constexpr std::size_t smallRun = 16;

struct SceneStroke {
    StrokePtr stroke;
    std::shared_ptr<const StrokeNodes> source;
    PixelRect bounds;            ///< the pixels of the grid's window that it can change; empty if there are none
    /// the separable nodes first: those that lay paint, those that lift it, those that fade it; then the oblique ones
    UnsetVector<ViewNode> nodes;
    NodeBoxStore boxes;          ///< the boxes of `nodes`, in pixels from the corner of the grid's window
    int laying = 0;  ///< how many separable nodes lay paint
    int painted = 0; ///< how many lay or lift it
    int separable = 0;
    std::vector<DeepNode> deep;
    std::shared_ptr<const SceneFill> fill; ///< null if it has none that could be seen
    std::shared_ptr<const ScenePicture> picture; ///< what it is painted with in place of its colours; null for them
    std::vector<SmallSegment> small;
    std::vector<Rect> smallRuns; ///< the box of each run of `smallRun` of them
    ShadeParams shade;
    float level[3] = {0, 0,
                      0}; ///< of each kind of style: it shows nothing where densities stay below (render/math/style.h)
    bool hasLevels = false;
    float lowest = -1; ///< the lowest of the levels; a density above it shows in any case
    int channels = 0;
    std::vector<float> values; ///< the channels of each row of `source`
    float keep = 1;            ///< eq 23: 1 − β
    bool granulated = false;
    /// whether densities are so calm that samples of a pixel can be told from its centre (render/math/bends.h)
    bool calm = false;
    bool outside = false; ///< whether it has no nodes because it cannot reach the window
    /// as pixelBounds gives them for each group of `source`; only if that was asked for
    std::vector<PixelRect> groupBounds;
    std::shared_ptr<const SceneStroke> dry; ///< the stroke once it has dried, if LiveScene has seen it so in this view
};

/// Whether something of the stroke is evaluated in double.
inline bool isDeep(const SceneStroke &stroke)
{
    return !stroke.deep.empty() || (stroke.fill && stroke.fill->deep);
}

/// True only if opacity is exactly zero for all densities φ⁺ and slopes (per pixel) up to these.
inline bool canVanish(const SceneStroke &stroke, float density, float slope)
{
    if (!stroke.hasLevels || density > stroke.lowest)
        return false;
    for (int k = 0; k < stroke.shade.kinds; ++k)
        if (!vanishes(stroke.shade, k, stroke.level[k], density * 1.001f, 0.5f * slope * 1.001f))
            return false;
    return true;
}

/// The pixels that a group can change, rounded outwards and clipped to the grid's window.
PixelRect pixelBounds(const StrokeNodes &nodes, const NodeGroup &group, Point origin, const PictureGrid &grid);

/// Prepares a stroke. `changes` says that it will be compared, group by group, with what it becomes. The bits are the
/// same for any number of threads.
SceneStroke makeSceneStroke(StrokePtr stroke, std::shared_ptr<const StrokeNodes> nodes, const PictureGrid &grid,
                            Threads threads = 1, bool changes = false, std::shared_ptr<SceneFill> fill = nullptr);

/// The part of the canvas that lies in the grid's window, as a box in canvas units.
Rect visibleBox(const PictureGrid &grid);

} // namespace suffuse
