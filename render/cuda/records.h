// What the device knows of a scene: plain records, written by the host (device_scene) and read by the kernels. C++17.
#pragma once

#include "render/math/shade_params.h"

#include <cstddef>
#include <cstdint>

namespace suffuse::cuda {

/// Pixels are evaluated in tiles of 16 × 16 whose corners lie on the picture's 16-pixel grid, one warp a tile.
inline constexpr int tileSide = 16;
inline constexpr int tileSize = tileSide * tileSide;
/// Lists of chunks are made for macro-tiles of 8 × 8 tiles.
inline constexpr int macroSide = 128;
inline constexpr int macroTiles = macroSide / tileSide;
/// A list is of half a macro-tile's 32 tiles: its upper four rows or the lower ones.
inline constexpr int listTiles = macroTiles * macroTiles / 2;
/// The chunks of half a macro job are listed in so many quarters, side by side: each is a list of its own.
inline constexpr int listQuarters = 4;
inline constexpr int listParts = 2 * listQuarters; ///< lists a macro job: those of the upper half, then the lower one's
/// Tiles are painted in the order of so many classes of weights.
inline constexpr int weightClasses = 128;
/// Nodes of one stroke that are chosen together, one a lane.
inline constexpr int chunkNodes = 32;

/// A node in pixels of the picture and the box where it is not zero. Its place is kept as a whole number of 16-pixel
/// cells and the rest in [0, 16), so that floats lose nothing.
struct alignas(16) NodeRecord {
    std::int32_t cellX = 0, cellY = 0;
    float x = 0, y = 0;
    float reachX = 0, reachY = 0; ///< half-sizes of the box, px
    float a = 0, b = 0, c = 0;    ///< metric, px⁻²; separable: b = 0
    float weight = 0;             ///< density at the centre
    float cut = 0;                ///< e^(−R²)
    std::uint32_t row = 0;        ///< of the stroke's channel values
};

/// As DeepNode (render/scene/scene.h): s > 4096 px.
struct DeepRecord {
    double x = 0, y = 0;
    double a = 0, b = 0, c = 0;
    double weight = 0;
    std::uint32_t row = 0;
    std::uint32_t padding = 0;
};

/// As SmallSegment (render/scene/scene.h): where pixels are supersampled 2^level × 2^level. Canvas units.
struct SmallRecord {
    double left = 0, top = 0, right = 0, bottom = 0;
    std::int32_t level = 0;
    std::int32_t padding = 0;
};

/// Up to 32 nodes of one stroke and the pixels that they can touch; all chunks of a scene lie in document order, those
/// of a stroke side by side. A stroke with deep nodes has a chunk of no nodes whose bounds are the stroke's, its first.
struct alignas(16) ChunkRecord {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0; ///< [left, right) × [top, bottom)
    std::uint32_t firstNode = 0;
    std::uint32_t nodes = 0;
    std::uint32_t stroke = 0; ///< index of the StrokeRecord
    std::uint32_t padding = 0;
};

/// A chunk in a list.
struct alignas(16) ListEntry {
    std::uint32_t chunk, firstNode;
    std::uint32_t strokeAndNodes; ///< stroke·64 + nodes
    std::uint32_t mask;           ///< bit 8·row + column: its stroke can be seen in that tile of the half
};

/// How one stroke shows.
struct alignas(16) StrokeRecord {
    ShadeParams shade;
    float style[3][12] =
        {}; ///< of each kind with constant ξ: math::Uniform, Feathering or Edge<float>, made by the host
    float level[3] = {0, 0, 0}; ///< as SceneStroke
    float lowest = -1;
    float keep = 1;
    std::uint32_t hasLevels = 0;
    std::uint32_t channels = 0;
    std::uint32_t granulated = 0;
    std::uint32_t plain =
        0; ///< one style, one granulation, only separable nodes, nothing small or deep, no φ⁺ of its own
    std::uint32_t firstChunk = 0, chunks = 0;
    std::uint32_t firstValue = 0; ///< of its channel values, `channels` a row
    std::uint32_t firstDeep = 0, deep = 0;
    std::uint32_t firstSmall = 0, small = 0;
};

/// One tile to evaluate, by one warp.
struct TileJob {
    std::uint16_t column = 0, row = 0; ///< in tiles
    std::uint16_t macro = 0;           ///< index in Frame::macros
    std::uint16_t flags = 0;           ///< TileFlag
    std::uint32_t layer = 0;           ///< slot in Frame::under and Frame::over
    std::uint32_t padding = 0;
};

/// How layers are used (docs/solver.md, "Layers").
enum TileFlag : std::uint16_t {
    haveUnder = 1, ///< begin from the stored colour below the first edited stroke
    storeUnder = 2,
    storeOver = 4, ///< strokes above the edited one as a map
    applyOver = 8, ///< instead of those strokes
    plainTile = 16 ///< all strokes near it are plain, the picture is not transparent, not storeOver; changes no bit
};

/// A list of the chunks that meet a macro-tile, in order.
struct MacroJob {
    std::int32_t column = 0, row = 0; ///< in macro-tiles
    std::uint32_t from = 0, to = 0;   ///< chunks looked at: [from, to)
    std::uint32_t firstTile = 0;      ///< its tile jobs are among the macroTiles² from there on
};

/// RYB and coverage of one pixel while strokes are mixed into it.
struct BackdropPixel {
    float red, yellow, blue, coverage;
};

/// B ← min(limit, keep·B + add) for each of RYB; coverage ← hold·coverage + gain.
inline constexpr int overPlanes = 9; ///< keep, add 3, limit 3, hold, gain

struct PaperParams {
    std::int32_t kind = 0;  ///< PaperKind
    std::int32_t grain = 0; ///< PaperGrain
    std::uint32_t seed = 0;
    double scale = 1;
    float strength = 0;
    std::int32_t width = 0, height = 0; ///< of the image
    const float *grey = nullptr;
};

/// Pixels to canvas units: x = x0 + xx·X + xy·Y, y = y0 + yx·X + yy·Y.
struct ToCanvas {
    double x0 = 0, y0 = 0, xx = 1, xy = 0, yx = 0, yy = 1;
    double px = 1;     ///< size of a pixel
    double margin = 0; ///< half a pixel's extent along the canvas' axes, canvas units
};

/// One call: everything that the kernels read and write. All pointers are the device's.
struct Frame {
    const NodeRecord *nodes = nullptr;
    const float *values = nullptr;
    const DeepRecord *deep = nullptr;
    const SmallRecord *small = nullptr;
    const ChunkRecord *chunks = nullptr;
    const StrokeRecord *strokes = nullptr;

    const MacroJob *macros = nullptr;
    const TileJob *tiles = nullptr;
    std::uint32_t macroCount = 0, tileCount = 0;
    ListEntry *lists = nullptr;          ///< `listRoom` entries a list, listParts lists a macro job
    std::uint32_t *listCounts = nullptr; ///< one a list
    std::uint32_t listRoom = 0;          ///< what does not fit is cut off, and told in the status words
    std::uint32_t editedFrom = 0xffffffff,
                  editedTo = 0xffffffff; ///< chunks of the first edited stroke, where layers are used

    std::int32_t width = 0, height = 0; ///< of the picture
    float background[3] = {0, 0, 0};    ///< RYB on white; all 0 where transparent
    std::uint32_t transparent = 0;
    PaperParams paper;
    ToCanvas toCanvas;
    std::uint32_t cull = 1;

    BackdropPixel *under = nullptr; ///< tileSize a slot
    float *over = nullptr;          ///< overPlanes × tileSize a slot

    // Where finished pixels go; null: not there.
    std::uint32_t *picture = nullptr;   ///< 0xAARRGGBB, `width` a row
    std::uint32_t *tilesArgb = nullptr; ///< the same, tileSize a tile job
    float *tilesRgba = nullptr;         ///< straight RGBA, 4·tileSize a tile job

    // Cleared by the host before each call.
    std::uint32_t *status = nullptr;      ///< status words
    std::uint32_t *classCounts = nullptr; ///< weightClasses: how many tile jobs `order` has of each
    std::uint32_t *weights =
        nullptr; ///< macroTiles² a macro job: what its tiles cost, roughly, and how many lists told

    std::uint16_t *order = nullptr; ///< tile jobs, tileCount a class of weights, heavy ones first (tile_order.h)
    std::uint32_t ordered = 0;      ///< whether they are painted so
};

/// Words of Frame::status.
enum StatusWord { nextPlainTile, nextGeneralTile, longestList, statusWords };

} // namespace suffuse::cuda
