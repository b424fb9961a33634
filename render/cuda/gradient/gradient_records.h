// The memory of the programs that find the gradient of a picture. The header is C++17, since .cu files include it.
#pragma once

#include "model/painting/style.h"

#include <cstdint>

namespace suffuse::cuda {

/// A tile has so many pixels on each side.
inline constexpr int gradientSide = 16, gradientSize = gradientSide * gradientSide;
/// R, Y, B, opacity, ω.
inline constexpr int gradientValues = 5;
/// Planes of a tile that are kept of a stroke for the way back: φ, −½∂φ/∂x, −½∂φ/∂y, R, Y, B below it; and, where
/// values vary along strokes, Σφ_k·value and φ⁺, and e^(−φ_f).
inline constexpr int keptPlanes = 6, valuePlanes = gradientValues + 1;

/// A segment in canvas units, as render/gradient/flat_scene.h has it, and what was chosen of its nodes.
struct GradientSegment {
    double x[4], y[4], density, spread;
    double radius, cut, gain; ///< as in SegmentRule
    float value[gradientValues];
    std::uint32_t firstNode, endNode;
    std::uint32_t firstEntry; ///< of its nodes' entries
    std::uint16_t mostX,
        mostY; ///< Each node meets at most so many columns and rows of tiles, and has an entry for each.
    std::uint32_t lift, fade;
};

/// A stroke, whose segments and nodes lie side by side.
struct GradientStroke {
    std::uint32_t first, end; ///< segments
    std::uint32_t firstNode, endNode;
    float xi[3];
    float keep;
    float constant[gradientValues]; ///< what does not vary
    StyleKind kind;
    bool varies;
    bool fades; ///< whether some segments make it paler
};

/// A node of a quadrature, by polynomials of its segment's control points.
struct GradientRule {
    double point[4], slope[4], weight;
};

/// A node in pixels, and the tiles that it can reach.
struct alignas(16) GradientNode {
    double x, y;
    float weight; ///< negative if it takes paint away
    float inverse, cut, reach;
    std::uint32_t entry; ///< the first of its entries, which lie row by row of its tiles
    std::int16_t tileX, tileY, tilesX, tilesY;
    std::uint32_t segment;
};

/// What a tile says of a node: derivatives by its weight, x, y and spread; then by ξ and the values, which the stroke's
/// nodes share there, and which stand with the first of them.
struct alignas(16) GradientEntry {
    static constexpr int ofNode = 4, numbers = ofNode + 3 + gradientValues;
    float v[numbers];
};

/// What of a tile may see a stroke: a box in pixels with the reach of its nodes.
struct alignas(16) GradientBox {
    float left, top, right, bottom;
};

/// Derivatives by a segment's numbers in canvas units, and its share of those by the stroke's ξ.
struct GradientSums {
    double x[4], y[4], density, spread, value[gradientValues], xi[3];
};

/// pixel = matrix · canvas + shift.
struct GradientView {
    double xx, xy, yx, yy, shiftX, shiftY, scale;
};

/// Holds everything that the programs of one call read and write. All pointers are the device's.
struct GradientWork {
    GradientView view;
    int width = 0, height = 0, columns = 0, rows = 0; ///< pixels, tiles
    float background[3] = {0, 0, 0};                  ///< R, Y, B
    const float *paper = nullptr;                     ///< η of each pixel, row by row; null: 1
    bool byXi = true;
    bool varies = false; ///< whether any stroke's values vary, or any fades

    const GradientSegment *segments = nullptr;
    std::uint32_t segmentCount = 0;
    const GradientStroke *strokes = nullptr;
    std::uint32_t strokeCount = 0;
    const GradientRule *rules = nullptr;

    GradientNode *nodes = nullptr;
    GradientBox *boxes = nullptr; ///< one for each stroke
    float *levels = nullptr;      ///< of each stroke: below it its style shows nothing
    GradientEntry *entries = nullptr;

    // What comes of the picture: the loss is Σ(picture − target)², or its derivatives are given, or there is none.
    const float *target = nullptr, *byRgb = nullptr; ///< R, G, B of each pixel, row by row
    float *picture = nullptr;                        ///< if not null, is written
    float *losses = nullptr;                         ///< one for each tile, with a target

    // A warp that draws tiles has a slot: what it keeps of each stroke that shows in its tile.
    float *kept = nullptr;
    std::uint32_t *shown = nullptr;  ///< the strokes' indices
    std::uint32_t warps = 0;         ///< that draw tiles
    std::uint32_t slotStrokes = 0;   ///< Where more strokes show, the results are not valid.
    std::uint32_t *status = nullptr; ///< see GradientStatus; the host clears it before each call

    GradientSums *sums = nullptr; ///< one for each segment
};

enum GradientStatus { nextGradientTile, mostStrokesShown, gradientStatusWords };

/// Floats of one stroke in a slot.
template <bool varies>
inline constexpr std::uint32_t keptFloats = std::uint32_t((varies ? keptPlanes + valuePlanes + 1 : keptPlanes) *
                                                          gradientSize);

} // namespace suffuse::cuda
