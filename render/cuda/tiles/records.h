// The device knows a scene as these plain records, which the host writes (device_scene) and the kernels read. The
// header is C++17, since .cu files include it.
#pragma once

#include "render/math/layer_put.h"
#include "render/math/picture_view.h"
#include "render/math/shade_params.h"

#include <cstddef>
#include <cstdint>

namespace suffuse::cuda {

/// Pixels are evaluated in tiles of 16 × 16 whose corners lie on the picture's 16-pixel grid. One warp evaluates a
/// tile.
inline constexpr int tileSide = 16;
inline constexpr int tileSize = tileSide * tileSide;
/// Lists of chunks are made for macro-tiles of 8 × 8 tiles.
inline constexpr int macroSide = 128;
inline constexpr int macroTiles = macroSide / tileSide;
/// A list is made for half a macro-tile, which has 32 tiles: its upper four rows or the lower ones.
inline constexpr int listTiles = macroTiles * macroTiles / 2;
/// The chunks of half a macro job are listed in this many quarters at the same time, and each is a list of its own.
inline constexpr int listQuarters = 4;
inline constexpr int listParts = 2 * listQuarters; ///< the lists of a macro job: those of the upper half come first
/// Tiles are put into this many classes by what they cost, and heavy classes are painted first (tile_order.h).
inline constexpr int weightClasses = 128;
/// A chunk has up to this many nodes of one stroke. They are chosen together, one by each lane of a warp.
inline constexpr int chunkNodes = 32;

/// Holds a node in pixels of the picture and the box where it is not zero. Its place is kept as a whole number of
/// 16-pixel cells and the rest in [0, 16), so that floats lose nothing.
struct alignas(16) NodeRecord {
    std::int32_t cellX = 0, cellY = 0;
    float x = 0, y = 0;
    float reachX = 0, reachY = 0; ///< half-sizes of the box, px
    float a = 0, b = 0, c = 0;    ///< metric, px⁻²; b = 0 if the node is separable
    float weight = 0;             ///< density at the centre
    float cut = 0;                ///< e^(−R²)
    std::uint32_t row = 0;        ///< the row of the stroke's channel values that it carries
};

/// Says what a FillRecord is; some of these flags together. A record without any is passed over.
enum FillKind : std::int32_t {
    fillNode = 1,  ///< a place on the boundary, with a weight
    fillTells = 2, ///< It tells where its panel ends. Each panel and flat has one record that does.
    fillFlat = 4,  ///< a flat
    fillShape = 8  ///< A panel's curve: the place is its upper end, and the rest is in the record that follows.
};

/// Ends of panels are whole numbers of this part of a pixel, so that neighbours agree on where they meet.
inline constexpr std::int32_t fillUnits = 1024;

/// Holds a place on the boundary of a fill (render/scene/scene_fill.h), and the ends of its panel. It is as large as a
/// NodeRecord, since both lie in the same chunks.
struct alignas(16) FillRecord {
    std::int32_t cellX = 0, cellY = 0;
    float x = 0, y = 0; ///< as in NodeRecord
    float weight = 0;
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< the panel's upper and lower end; of a flat the left and right one
    float up = 0, down = 0;                      ///< their heights, from the place's, px
    std::int32_t kind = 0; ///< 256 · what the panel enters, or the flat's jump, and flags of FillKind
};
static_assert(sizeof(FillRecord) == sizeof(NodeRecord));

/// Holds the other control points of a panel's curve, from its upper end, px.
struct alignas(16) FillCurveRecord {
    float x1 = 0, y1 = 0, x2 = 0, y2 = 0, x3 = 0, y3 = 0;
    std::int32_t padding[5] = {0, 0, 0, 0, 0};
    std::int32_t kind = 0; ///< as in FillRecord; there are no flags
};
static_assert(sizeof(FillCurveRecord) == sizeof(FillRecord));

/// Holds the numbers of a fill.
struct alignas(16) FillValues {
    std::int32_t reachX = 0, reachY = 0; ///< how far it counts, in 1/fillUnits px
    float along = 1, down = 1;           ///< a and c
    double a = 1, b = 0, c = 1;          ///< as in SceneFill
    double density = 0;
    double place = 0, placeX = 0, placeY = 0; ///< of the gradient: at pixel (0, 0), and more per pixel
    double half[3] = {0, 0, 0};
    float from[maxChannels] = {}, step[maxChannels] = {}; ///< values of the channels
    double nearby = 0;                                    ///< px
    // Squares of a deep fill: their heads lie in Frame::deep from the stroke's deep nodes on. A head has in x where its
    // entries begin, counted from the first head, in y how many these are, and in weight what is entered before them.
    // An entry of row 1 is an event, with its jump as the weight, others are nodes.
    std::int32_t deepColumn = 0, deepRow = 0, deepColumns = 0, deepRows = 0;
};
static_assert(sizeof(FillValues) == 256);

/// Holds a DeepNode (render/scene/scene.h), which has s > 4096 px.
struct DeepRecord {
    double x = 0, y = 0;
    double a = 0, b = 0, c = 0;
    double weight = 0;
    std::uint32_t row = 0;
    std::uint32_t padding = 0;
};

/// Holds a SmallSegment (render/scene/scene.h): where pixels are supersampled 2^level × 2^level, in canvas units.
struct SmallRecord {
    double left = 0, top = 0, right = 0, bottom = 0;
    std::int32_t level = 0;
    std::int32_t padding = 0;
};

/// Holds up to 32 nodes of one stroke and the pixels that they can touch. All chunks of a scene lie in document order,
/// and those of a stroke side by side. The first chunk of a stroke with deep nodes has no nodes, and the bounds of the
/// stroke.
struct alignas(16) ChunkRecord {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0; ///< [left, right) × [top, bottom)
    std::uint32_t firstNode = 0;
    std::uint32_t nodes = 0;  ///< how many, and fillChunk if they are FillRecords
    std::uint32_t stroke = 0; ///< index of the StrokeRecord
    std::uint32_t padding = 0;
};

/// This bit of a chunk's number of nodes says that it has FillRecords instead. A stroke's chunks of its fill come
/// before those of its nodes.
inline constexpr std::uint32_t fillChunk = 64;
/// The other bits of it.
inline constexpr std::uint32_t chunkCountBits = 63;

/// Names a chunk in a list.
struct alignas(16) ListEntry {
    std::uint32_t chunk, firstNode;
    std::uint32_t strokeAndNodes; ///< stroke·128 + nodes
    std::uint32_t mask;           ///< bit 8·row + column says whether its stroke can be seen in that tile of the half
};

/// Says what a stroke's fill needs, if it has one.
enum FillFlag : std::uint32_t {
    haveFill = 1,
    crispFill = 2,
    thinFill = 4, ///< s < 1 px, and not crisp: pixels near its boundary are supersampled
    deepFill = 8,
    gradientFill = 16,
    fillLevel = 256 ///< times the level of supersampling
};

/// Says how one stroke shows.
struct alignas(16) StrokeRecord {
    ShadeParams shade;
    /// For each kind with constant ξ this is math::Uniform, Feathering or Edge<float>, as the host has made it.
    float style[3][12] = {};
    float level[3] = {0, 0, 0}; ///< as in SceneStroke
    float lowest = -1;
    float keep = 1;
    std::uint8_t hasLevels = 0, granulated = 0;
    /// A plain stroke has one style, one granulation, only separable nodes, nothing small or deep, and no sum φ⁺ or
    /// φ_f. If it has a fill, that is separable and its colours lie on a line; a crisp one is all that the stroke has.
    /// It has no picture.
    std::uint8_t plain = 0;
    /// A simple stroke is plain, or would be if its pixels were not supersampled and it had no picture. Its fill is not
    /// crisp.
    std::uint8_t simple = 0;
    std::uint32_t channels = 0;
    std::uint32_t picture = 0; ///< 1 more than the index of its picture; 0: it has none
    std::uint32_t firstChunk = 0, chunks = 0;
    std::uint32_t firstValue = 0; ///< where its channel values begin, `channels` in a row
    std::uint32_t firstDeep = 0, deep = 0;
    std::uint32_t firstSmall = 0, small = 0;
    std::uint32_t fill = 0;                  ///< flags of FillFlag
    std::uint32_t fillValues = 0;            ///< index of its FillValues
    float fillDensity = 0, fillSteepest = 0; ///< ρ, and a bound of |∇φ|
};
static_assert(sizeof(StrokeRecord) == 352); // Tiles copy it for each chunk.

/// Names a tile to evaluate, by one warp.
struct TileJob {
    std::uint16_t column = 0, row = 0; ///< counted in tiles
    std::uint16_t macro = 0;           ///< index in Frame::macros
    std::uint16_t flags = 0;           ///< some of TileFlag
    std::uint32_t layer = 0;           ///< slot in Frame::under and Frame::over
    std::uint32_t padding = 0;
};

/// These flags say how layers are used (docs/solver.md, "Layers").
enum TileFlag : std::uint16_t {
    haveUnder = 1, ///< the tile begins from the stored colour below the first edited stroke
    storeUnder = 2,
    storeOver = 4, ///< the strokes above the edited one are stored as a map
    applyOver = 8, ///< that map is applied instead of those strokes
    /// The lean kernel paints the tile: all strokes near it are plain, the picture is not transparent, and storeOver is
    /// not set. The general kernel would give the same bits.
    plainTile = 16
};

/// Asks for lists of the chunks that meet a macro-tile, in order.
struct MacroJob {
    std::int32_t column = 0, row = 0; ///< counted in macro-tiles
    std::uint32_t from = 0, to = 0;   ///< chunks [from, to) are looked at
    std::uint32_t firstTile = 0;      ///< its tile jobs are among the macroTiles² from there on
    /// Bit 8·row + column of the upper and of the lower half says whether that tile is painted, and whether by the
    /// general kernel.
    std::uint32_t painted[2] = {0, 0}, general[2] = {0, 0};
};

/// Asks for one stroke at one tile, which a warp evaluates apart from the tile's other strokes (tile_apart.h).
struct ApartJob {
    std::uint16_t column = 0, row = 0; ///< the tile, counted in tiles
    std::uint32_t stroke = 0;          ///< index of the StrokeRecord
    std::uint32_t from = 0, to = 0;    ///< Of its chunks, only those in [from, to) can meet the tile.
    std::uint32_t slot = 0;            ///< where its samples go, in Frame::apartSamples
};

/// This bit of a list's count says that some of its entries have bits in their ApartEntry.
inline constexpr std::uint32_t anyApart = 1u << 31;

/// Says for an entry of a list at which tiles of the half its stroke is evaluated apart: a bit for each, as in
/// ListEntry. The slots of these tiles are `slot` and those behind it, in the order of the bits.
struct ApartEntry {
    std::uint32_t mask, slot;
};

/// Jobs of strokes evaluated apart are put into these classes; costly ones are taken first.
enum ApartClass { costlyPlain, otherPlain, costlyGeneral, otherGeneral, apartClasses };
/// A job of a general stroke has so many parts, which several warps take: the pixels with one sample, and the
/// supersampled ones of each quadrant of the tile.
inline constexpr int generalParts = 5;
inline constexpr int apartParts = 8; ///< the distance of the slots' words in Frame::apartDone

/// Says how a layer of the painting (render/composition) is put on what lies below it, as LayerPut does.
struct LayerRecord {
    std::int32_t mode = 0; ///< BlendMode
    float opacity = 1;
    std::uint32_t opaque = 0;
    float bare[3] = {1, 1, 1};
    std::int32_t parent = -1;    ///< index of the layer around it; −1: none
    std::int32_t depth = 1;      ///< how many layers it is, with those around it
    std::int32_t clippedTo = -1; ///< the base whose coverage multiplies its own; −1: none
    std::int32_t shape = -1;     ///< the base of which its coverage is a part; −1: none
    std::int32_t masks = 0;      ///< how many masks are directly within it
    std::uint32_t isMask = 0;    ///< whether its coverage multiplies that of the layer around it
    std::int32_t shapeMode = 0;  ///< BlendMode, by which it becomes a part
};

/// Names a layer that changes what lies below also where it has no stroke.
struct EverywhereRecord {
    std::int32_t layer = 0;
    std::uint32_t firstChunk = 0; ///< of its first stroke
};

/// Holds RYB and coverage of one pixel while strokes are mixed into it.
struct alignas(16) BackdropPixel {
    float red, yellow, blue, coverage;
};

/// Holds what bounds the layers that are put on a pixel of a backdrop, and that backdrop itself.
struct alignas(16) BoundPixel {
    float shape, mask;        ///< the coverage of a base, and that of masks
    std::int32_t base, masks; ///< which base it is, and how many masks
};

/// An over map (docs/solver.md, "Layers") makes B ← min(limit, keep·B + add) for each of RYB, and coverage ←
/// hold·coverage + gain. It has this many planes of numbers.
inline constexpr int overPlanes = 9; ///< keep, three of add, three of limit, hold, gain

/// Says from which cost on a stroke is evaluated apart from its tile. Pixels do not depend on it.
struct ApartLimits {
    std::uint32_t from = 400;    ///< the cost of a stroke
    std::uint32_t inGeneral = 0; ///< the same at a tile of the general kernel, where plain strokes cost more
    std::uint32_t ofFill = 400;  ///< the same for a stroke with a fill, at any tile
    std::uint32_t above = 20000; ///< what the strokes of a list may cost before all others are evaluated apart
};

struct PaperParams {
    std::int32_t kind = 0;  ///< PaperKind
    std::int32_t grain = 0; ///< PaperGrain
    std::uint32_t seed = 0;
    double scale = 1;
    float strength = 0;
    std::int32_t width = 0, height = 0; ///< the size of the image
    const float *grey = nullptr;
};

/// Converts pixels to canvas units: x = x0 + xx·X + xy·Y, y = y0 + yx·X + yy·Y.
struct ToCanvas {
    double x0 = 0, y0 = 0, xx = 1, xy = 0, yx = 0, yy = 1;
    double px = 1;     ///< the size of a pixel in canvas units
    double margin = 0; ///< half a pixel's extent along the canvas' axes, canvas units
};

/// Holds everything that the kernels of one call read and write. All pointers are the device's.
struct Frame {
    const NodeRecord *nodes = nullptr;
    const float *values = nullptr;
    const DeepRecord *deep = nullptr;
    const SmallRecord *small = nullptr;
    const FillValues *fills = nullptr; ///< null if no stroke has a fill
    const PictureView *pictures = nullptr;
    const ChunkRecord *chunks = nullptr;
    const StrokeRecord *strokes = nullptr;

    const MacroJob *macros = nullptr;
    const TileJob *tiles = nullptr;
    std::uint32_t macroCount = 0, tileCount = 0;
    ListEntry *lists = nullptr; ///< with `listRoom` entries for each list and listParts lists for each macro job
    std::uint32_t *listCounts = nullptr; ///< how many entries each list has
    std::uint32_t listRoom = 0;          ///< what does not fit is cut off, and the word longestList says so
    std::uint32_t editedFrom = 0xffffffff,
                  editedTo = 0xffffffff; ///< chunks of the first edited stroke, where layers are used

    std::int32_t width = 0, height = 0; ///< the size of the picture
    float background[3] = {0, 0, 0};    ///< RYB on white; all 0 if the picture is transparent
    std::uint32_t transparent = 0;
    PaperParams paper;
    ToCanvas toCanvas;
    std::uint32_t cull = 1;

    BackdropPixel *under = nullptr; ///< with tileSize pixels for each slot
    float *over = nullptr;          ///< with overPlanes × tileSize numbers for each slot

    const LayerRecord *layers = nullptr;          ///< null if the painting has none
    const std::int32_t *layerOf = nullptr;        ///< the innermost layer of each StrokeRecord; −1: none
    const EverywhereRecord *everywhere = nullptr; ///< in order
    std::uint32_t everywhereCount = 0;
    std::uint32_t layerPlanes = 0;         ///< 1 more than the depth of the deepest layer
    BackdropPixel *layerPixels = nullptr;  ///< with layerPlanes × tileSize pixels for each tile job
    const std::int32_t *shapeOf = nullptr; ///< the base of which each StrokeRecord is a part, if anything is clipped
    BoundPixel *boundPixels = nullptr;     ///< as layerPixels, if anything is clipped or masked

    // Finished pixels go to those of these arrays that are not null.
    std::uint32_t *picture = nullptr;   ///< 0xAARRGGBB, with `width` pixels in a row
    std::uint32_t *tilesArgb = nullptr; ///< the same, with tileSize pixels for each tile job
    float *tilesRgba = nullptr;         ///< straight RGBA, with 4·tileSize numbers for each tile job

    // The host clears these before each call.
    std::uint32_t *status = nullptr;      ///< see StatusWord
    std::uint32_t *classCounts = nullptr; ///< how many tile jobs `order` has of each of the weightClasses
    /// For each of the macroTiles² tiles of a macro job this is what it costs, roughly, and how many lists said so.
    std::uint32_t *weights = nullptr;

    // Strokes that are evaluated apart. `apart` has an entry beside each of `lists`, `apartJobs` has room for apartRoom
    // jobs of each class, `apartSamples` has tileSize samples (w, red, yellow, blue) for each of the apartRoom slots,
    // and `apartDone` has apartParts words for each: 2·apartStamp, and 1 more where the stroke shows something.
    ApartEntry *apart = nullptr;
    ApartJob *apartJobs = nullptr;
    float *apartSamples = nullptr;
    std::uint32_t *apartDone = nullptr;
    std::uint32_t apartRoom = 0;  ///< What finds no room is evaluated with the tile.
    std::uint32_t apartStamp = 0; ///< the number of the call
    ApartLimits apartLimits;

    // The paper at tiles of the picture, row by row, in etaPlanes planes of tileSize numbers for each tile: at the
    // pixels, and then, if there are more, at the 2 × 2 samples a pixel of each quadrant. `etaKnown` has a word for
    // each plane, which is etaStamp once the plane is there.
    float *eta = nullptr;
    std::uint32_t *etaKnown = nullptr;
    std::uint32_t etaPlanes = 0, etaStamp = 0;

    std::uint16_t *order = nullptr; ///< tile jobs by classes of weights, each with room for tileCount (tile_order.h)
    std::uint32_t ordered = 0;      ///< whether tiles are painted in that order
};

/// Names the words of Frame::status.
enum StatusWord {
    nextPlainTile,
    nextGeneralTile,
    longestList,
    slotsTaken, ///< This may be more than apartRoom.
    nextPlainApart,
    nextGeneralApart,
    firstApartCount, ///< how many jobs each ApartClass has
    statusWords = firstApartCount + apartClasses
};

} // namespace suffuse::cuda
