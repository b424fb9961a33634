// A warp finds here which nodes meet a tile, and sums them at the samples of a block: density, slopes and channels
// (docs/solver.md, "Separable blocks").
#pragma once

#include "render/cuda/tiles/tile_deep.h"
#include "render/cuda/tiles/tile_nodes.h"

namespace suffuse::cuda {

/// A block of samples has 16 × 16 of them. Sample (i, j) lies at (x + (i − 7½)·step, y + (j − 7½)·step) from the tile's
/// centre, px.
struct Block {
    float x = 0, y = 0, step = 1;
};

/// Each lane has this many samples: two columns and four rows. Sample k is in column 2·(lane mod 8) + k mod 2 and row
/// 4·(lane div 8) + k div 2.
inline constexpr int laneSamples = tileSize / warpLanes;

SUFFUSE_PROGRAM int sampleColumn(int lane, int k)
{
    return lane % 8 * 2 + k % 2;
}
SUFFUSE_PROGRAM int sampleRow(int lane, int k)
{
    return lane / 8 * 4 + k / 2;
}
/// Returns where a sample of a block lies, from the tile's centre, px.
SUFFUSE_PROGRAM float sampleX(int lane, int k, const Block &block)
{
    return math::mulAdd_(float(sampleColumn(lane, k)) - 7.5f, block.step, block.x);
}
SUFFUSE_PROGRAM float sampleY(int lane, int k, const Block &block)
{
    return math::mulAdd_(float(sampleRow(lane, k)) - 7.5f, block.step, block.y);
}

/// Returns the place of a lane's sample in shared memory. It is arranged so that no two lanes need the same bank at
/// once (warp.h).
SUFFUSE_PROGRAM int sampleAt(int lane, int k)
{
    return k * warpLanes + lane;
}
SUFFUSE_PROGRAM int sampleAtPixel(int column, int row)
{
    return sampleAt(row / 4 * 8 + column / 2, row % 4 * 2 + column % 2);
}

inline constexpr int nodeRoom = 96; ///< nodes of a stroke that are listed at once
inline constexpr int stride = 4;    ///< nodes are summed by fours, and empty ones fill up the last
inline constexpr int batch = 16;    ///< nodes whose tables are in shared memory at once

/// Tables have exponents to base 2, so slopes come out times −log₂ e. This factor corrects them.
inline constexpr float slopeUnit = -float(math::ln2);

/// Holds a node near the tile. A separable one is (dx, −a log₂ e, cut, 1) and (dy, −c log₂ e, cut·weight, weight), an
/// oblique one (dx, dy, a, b) and (c, cut, weight, 0). d is from the tile's centre.
struct ListedNode {
    Float4 first, second;
};
static_assert(sizeof(ListedNode) == 2 * sizeof(Float4));

/// A warp has this in shared memory while it sums a batch.
struct BatchScratch {
    /// A table has (e^(−a dx²) − cut, a dx e^(−a dx²)/slopeUnit) by column, then the same by row times the weight.
    Float4 tables[batch][warpLanes / 2];
    Float4 channel[batch][tileSide / 4]; ///< a row's value times a channel's
};

/// Holds φ′ and h² at the tile's pixels, in the order of `sampleAt`, and later the pixel mean of F in place of φ′.
struct MeanScratch {
    float density[tileSize], h2[tileSize];
    /// These are the samples that need the long form, wherever they lie, so that lanes share the work.
    std::uint8_t longOnes[tileSize];
};

/// A warp that sums nodes has this in shared memory.
struct SumScratch {
    ListedNode listed[nodeRoom + 2 * stride - 1]; ///< The places at the end are only read ahead.
    std::uint32_t rows[nodeRoom + stride - 1];    ///< the rows of channel values, counted from the stroke's first
    union {                                       // They are used one after the other.
        BatchScratch sums;
        Fetched chosenAgain;
    };
    MeanScratch means;
};

struct SampleSums {
    float density[laneSamples], slopeX[laneSamples], slopeY[laneSamples]; ///< slopes: −½ ∂φ/slopeUnit, per pixel
};
struct SampleValues {
    float v[laneSamples];
};

/// Holds the sums of a stroke that is not simple, with all its channels. These are too many for registers, so they lie
/// in memory of the lane's own.
struct AllSums {
    SampleSums sums;
    SampleValues channel[maxChannels];
};

/// Counts the nodes that are chosen so far. The counts are the same in all lanes.
struct Listing {
    int count = 0;     ///< how many are listed
    int separable = 0; ///< how many of them are separable; these come first
    int fill = 0;      ///< how many belong to a fill (tile_fill.h); these come before all others
    int base = 0;      ///< how often the fill's area was entered left of what is listed, at the upper border
};

/// Returns how many places so many separable nodes take, with the empty ones after them.
SUFFUSE_PROGRAM int wholeStrides(int nodes)
{
    return (nodes + stride - 1) / stride * stride;
}

/// Lists those nodes of a chunk that meet a block of the tile's samples. The chunk must have arrived, and there must be
/// room for 32.
template <class Warp>
SUFFUSE_PROGRAM void listNodes(Warp &warp, bool cull, const Fetched &chunk, int nodes, std::int32_t cellX,
                               std::int32_t cellY, const Block &block, SumScratch &s, Listing &listing)
{
    typename Warp::template Var<ListedNode> node;
    typename Warp::template Var<std::uint32_t> row;
    typename Warp::template Var<bool> oblique;
    const std::uint32_t hits = warp.ballot([&](int lane) {
        oblique[lane] = false;
        if (lane >= nodes)
            return false;
        const NodeRecord n = nodeOf(chunk, lane);
        const NodePlace place(n, cellX, cellY);
        if (cull && !place.meets(block.x, block.y, block.step, n.reachX, n.reachY))
            return false;
        oblique[lane] = n.b != 0;
        constexpr float base2 = -float(math::log2e);
        node[lane] = n.b == 0 ? ListedNode{{place.dx, base2 * n.a, n.cut, 1},
                                           {place.dy, base2 * n.c, n.cut * n.weight, n.weight}}
                              : ListedNode{{place.dx, place.dy, n.a, n.b}, {n.c, n.cut, n.weight, 0}};
        row[lane] = n.row;
        return true;
    });
    if (hits == 0)
        return;
    const bool askew = warp.any([&](int lane) { return oblique[lane]; });
    if (askew && listing.count == listing.separable)
        listing.count = wholeStrides(listing.count); // The empty ones stay.
    warp.each([&](int lane) {
        if (hits >> lane & 1) {
            const int at = listing.count + Warp::rank(hits, lane);
            s.listed[at] = node[lane];
            s.rows[at] = row[lane];
        }
        if (lane < stride - 1) {
            const int at = listing.count + Warp::count(hits) + lane;
            s.listed[at] = {{0, 0, 2, 1}, {0, 0, 2, 1}}; // e⁰ lies below its cut.
            s.rows[at] = 0;
        }
    });
    listing.count += Warp::count(hits);
    if (!askew)
        listing.separable = listing.count; // A chunk has one kind, and the separable ones come first.
}

/// Fills the tables of nodes [from, to) of the list. Each lane makes one entry: its column or its row.
template <class Warp>
SUFFUSE_PROGRAM void fillTables(Warp &warp, int from, int to, const Block &block, SumScratch &s)
{
    warp.each([&](int lane) {
        const bool isRow = lane >= tileSide;
        const float offset = math::mulAdd_(float(lane % tileSide) - 7.5f, block.step, isRow ? block.y : block.x);
        const Float4 *axes = &s.listed[from].first + isRow;
        Float2 *entries = reinterpret_cast<Float2 *>(s.sums.tables[0]) + lane;
        Float4 axis[stride]; // those of the next nodes, which are on their way meanwhile
        SUFFUSE_UNROLL
        for (int k = 0; k < stride; ++k)
            axis[k] = axes[2 * k];
        SUFFUSE_ROLLED
        for (int first = from; first < to; first += stride) {
            Float2 entry[stride];
            SUFFUSE_UNROLL
            for (int k = 0; k < stride; ++k) {
                const float d = offset - axis[k].x, rise = axis[k].y * d;
                const float e = math::exp2_(rise * d) * axis[k].w;
                const bool there = math::abs_(axis[k].z) < math::abs_(e); // Weights may be negative.
                entry[k] = {there ? e - axis[k].z : 0.0f, there ? rise * e : 0.0f};
            }
            axes += 2 * stride;
            SUFFUSE_UNROLL
            for (int k = 0; k < stride; ++k) {
                axis[k] = axes[2 * k];
                entries[k * warpLanes] = entry[k];
            }
            entries += stride * warpLanes;
        }
    });
}

/// Adds up a batch of separable nodes whose tables are filled.
template <class Warp>
SUFFUSE_PROGRAM void addBatch(Warp &warp, int nodes, const SumScratch &s, typename Warp::template Var<SampleSums> &sums)
{
    warp.each([&](int lane) {
        SampleSums &sum = sums[lane];
        SUFFUSE_ROLLED
        for (int first = 0; first < nodes; first += stride) {
            SUFFUSE_UNROLL
            for (int n = first; n < first + stride; ++n) {
                const Float4 columns = s.sums.tables[n][lane % 8];
                const Float4 *rows = &s.sums.tables[n][8 + lane / 8 * 2];
                const Float4 low = rows[0], high = rows[1];
                const float value[4] = {low.x, low.z, high.x, high.z}, slope[4] = {low.y, low.w, high.y, high.w};
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    const float x = k % 2 ? columns.z : columns.x, xSlope = k % 2 ? columns.w : columns.y;
                    sum.density[k] = math::mulAdd_(x, value[k / 2], sum.density[k]);
                    sum.slopeX[k] = math::mulAdd_(xSlope, value[k / 2], sum.slopeX[k]);
                    sum.slopeY[k] = math::mulAdd_(x, slope[k / 2], sum.slopeY[k]);
                }
            }
        }
    });
}

/// Does the same for one channel: Σ φ·value. `values` of the stroke has rows of `channels`.
template <class Warp>
SUFFUSE_PROGRAM void addChannel(Warp &warp, int from, int nodes, const float *values, std::uint32_t channels,
                                std::uint32_t channel, SumScratch &s, typename Warp::template Var<SampleValues> &sums)
{
    warp.each([&](int lane) { // A lane takes one node's 16 rows by halves.
        const int n = lane % batch, part = lane / batch * 2;
        if (n < wholeStrides(nodes)) {
            const float value = values[std::size_t(s.rows[from + n]) * channels + channel];
            for (int q = part; q < part + 2; ++q) {
                const Float4 low = s.sums.tables[n][8 + q * 2], high = s.sums.tables[n][9 + q * 2];
                s.sums.channel[n][q] = {low.x * value, low.z * value, high.x * value, high.z * value};
            }
        }
    });
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int first = 0; first < nodes; first += stride) {
            SUFFUSE_UNROLL
            for (int n = first; n < first + stride; ++n) {
                const Float4 columns = s.sums.tables[n][lane % 8], rows = s.sums.channel[n][lane / 8];
                const float value[4] = {rows.x, rows.y, rows.z, rows.w};
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k)
                    sums[lane].v[k] = math::mulAdd_(k % 2 ? columns.z : columns.x, value[k / 2], sums[lane].v[k]);
            }
        }
    });
}

} // namespace suffuse::cuda
