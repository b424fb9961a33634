// One warp sums up a fill at the samples of a block (docs/cuda.md, "Fills").
#pragma once

#include "render/cuda/tiles/fill_region.h"
#include "render/cuda/tiles/tile_sums.h"

namespace suffuse::cuda {

/// Lists the places of a fill's chunk that count at a block, and the events of its panels, in their order. The chunk
/// must have arrived. Returns false, with nothing listed, if there is no room. In the list columns are (dx, a, p, q),
/// rows (dy, c, p, q), for fillEntry.
template <class Warp>
SUFFUSE_PROGRAM bool listFill(Warp &warp, const Fetched &chunk, int records, const FillValues &fill, std::int32_t cellX,
                              std::int32_t cellY, const Block &block, SumScratch &s, Listing &listing)
{
    const FillRegion region = fillRegion(fill, cellX, cellY, block.x, block.y, block.step);
    typename Warp::template Var<std::uint32_t> use;
    const std::uint32_t hits = warp.ballot([&](int lane) {
        const FillRecord r = fillRecordOf(chunk, lane);
        use[lane] = lane < records ? useOf(endsOf(r), region) : 0;
        // A place beyond the region would add nothing. Left of it, it belongs to its panel.
        const std::int32_t cell = tileSide * fillUnits;
        const std::int32_t x = r.cellX * cell + std::int32_t(r.x * float(fillUnits));
        const std::int32_t y = r.cellY * cell + std::int32_t(r.y * float(fillUnits));
        if (x > region.right || y < region.top || y > region.bottom)
            use[lane] &= ~std::uint32_t(listedFill);
        return (use[lane] & listedFill) != 0;
    });
    const std::uint32_t events = warp.ballot([&](int lane) { return (use[lane] & fillEvent) != 0; });
    const int total = Warp::count(hits) + Warp::count(events);
    if (listing.count + total > nodeRoom)
        return false;
    listing.base += Warp::count(warp.ballot([&](int lane) { return (use[lane] & enteredFill) != 0; })) -
                    Warp::count(warp.ballot([&](int lane) { return (use[lane] & leftFill) != 0; }));
    if (total == 0)
        return true;
    warp.each([&](int lane) {
        if (use[lane] & (listedFill | fillEvent)) {
            const FillRecord r = fillRecordOf(chunk, lane);
            constexpr float half = tileSide / 2;
            const float dx = float((r.cellX - cellX) * tileSide) + (r.x - half);
            const float dy = float((r.cellY - cellY) * tileSide) + (r.y - half);
            int at = listing.count + Warp::rank(hits, lane) + Warp::rank(events, lane);
            if (use[lane] & listedFill)
                s.listed[at++] = {{dx, fill.along, 1, 0}, {dy, fill.down, 0, r.weight}};
            if (use[lane] & fillEvent)
                s.listed[at] = {
                    {0, 0, 0, 1},
                    {dy + (use[lane] & fillFalls ? r.down : r.up), fill.down, jumpOf(r.kind, use[lane]), 0}};
        }
        if (lane < stride - 1)
            s.listed[listing.count + total + lane] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    });
    listing.count += total;
    listing.separable = listing.fill = listing.count;
    return true;
}

/// Lets the nodes of a stroke begin behind its fill, where the sums take whole strides.
SUFFUSE_PROGRAM void endFill(Listing &listing)
{
    if (listing.count == listing.fill)
        listing.count = listing.separable = wholeStrides(listing.count);
}

/// Returns e^(−u²)·½erfc(|u|)/e^(−u²), with a relative error of 4e-7: a fit by powers of 1/(1 + 0.36 |u|).
SUFFUSE_PROGRAM float halfErfcTail(float u, float gaussian)
{
    const float t = math::reciprocal_(math::mulAdd_(0.36f, math::abs_(u), 1.0f));
    float p = -0.083145597f;
    p = math::mulAdd_(p, t, 0.28835637f);
    p = math::mulAdd_(p, t, -0.18964859f);
    p = math::mulAdd_(p, t, 0.22575925f);
    p = math::mulAdd_(p, t, 0.047871786f);
    p = math::mulAdd_(p, t, 0.10986609f);
    p = math::mulAdd_(p, t, 0.10094082f);
    return p * t * gaussian;
}

/// Returns p·½erfc(−u) + q·e^(−u²) and its slope as in the tables of nodes, with u = k·(offset − d) and (d, k, p, q)
/// the axis. So it gives columns and rows of places, of events (whose columns are 1), and of nothing.
SUFFUSE_PROGRAM Float2 fillEntry(float offset, const Float4 &axis)
{
    constexpr float halfInverseRootPi = 0.28209479f;
    const float u = axis.y * (offset - axis.x), e = math::exp2_(-float(math::log2e) * (u * u));
    const float tail = halfErfcTail(u, e), entered = u < 0 ? tail : 1 - tail;
    const float slope = axis.y * e * (1 / slopeUnit);
    return {math::mulAdd_(axis.z, entered, axis.w * e), slope * math::mulAdd_(axis.w, u, -halfInverseRootPi * axis.z)};
}

/// Fills the tables of entries [from, to) of a fill, as fillTables does with nodes.
template <class Warp>
SUFFUSE_PROGRAM void fillTablesOfFill(Warp &warp, int from, int to, const Block &block, SumScratch &s)
{
    warp.each([&](int lane) {
        const bool isRow = lane >= tileSide;
        const float offset = math::mulAdd_(float(lane % tileSide) - 7.5f, block.step, isRow ? block.y : block.x);
        const Float4 *axes = &s.listed[from].first + isRow;
        Float2 *entries = reinterpret_cast<Float2 *>(s.sums.tables[0]) + lane;
        SUFFUSE_ROLLED
        for (int first = from; first < to; first += stride) {
            Float2 entry[stride];
            SUFFUSE_UNROLL
            for (int k = 0; k < stride; ++k)
                entry[k] = fillEntry(offset, axes[2 * k]);
            SUFFUSE_UNROLL
            for (int k = 0; k < stride; ++k)
                entries[k * warpLanes] = entry[k];
            axes += 2 * stride;
            entries += stride * warpLanes;
        }
    });
}

/// Adds the listed part of a separable fill to the sums.
template <class Warp>
SUFFUSE_PROGRAM void addFillEntries(Warp &warp, const Listing &listing, const Block &block, SumScratch &s,
                                    typename Warp::template Var<SampleSums> &sums)
{
    SUFFUSE_ROLLED
    for (int from = 0; from < listing.fill; from += batch) {
        const int to = from + batch < listing.fill ? from + batch : listing.fill;
        fillTablesOfFill(warp, from, to, block, s);
        addBatch(warp, to - from, s, sums);
    }
}

/// The same for a fill whose Gaussian lies askew: u = a·dx + b·dy. Such fills are rare, so this is called, not inlined.
template <class Warp>
SUFFUSE_CALL void addObliqueFill(Warp warp, int entries, const FillValues &fill, const Block block, const SumScratch &s,
                                 typename Warp::template Var<AllSums> &sums)
{
    constexpr float halfInverseRootPi = 0.28209479f;
    const float a = fill.along, b = float(fill.b), c = fill.down;
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int k = 0; k < laneSamples; ++k) {
            const float x = sampleX(lane, k, block), y = sampleY(lane, k, block);
            SampleSums &own = sums[lane].sums;
            float density = own.density[k], slopeX = own.slopeX[k], slopeY = own.slopeY[k];
            SUFFUSE_ROLLED
            for (int n = 0; n < entries; ++n) {
                const ListedNode entry = s.listed[n];
                const float dx = x - entry.first.x, dy = y - entry.second.x;
                const float v = c * dy, row = math::exp2_(-float(math::log2e) * (v * v));
                const bool event = entry.first.z == 0;
                const float u = event ? v : math::mulAdd_(a, dx, b * dy);
                const float e = event ? row : math::exp2_(-float(math::log2e) * (u * u));
                const float weight = event ? entry.second.z : entry.second.w * row;
                const float tail = halfErfcTail(u, e), part = weight * (u < 0 ? tail : 1 - tail);
                const float steep = -halfInverseRootPi * weight * e; // −½ of the slope along u, or of an event along v
                density += part;
                slopeX += event ? 0.0f : a * steep * (1 / slopeUnit);
                slopeY += (event ? c * steep : math::mulAdd_(b, steep, c * (part * v))) * (1 / slopeUnit);
            }
            own.density[k] = density, own.slopeX[k] = slopeX, own.slopeY[k] = slopeY;
        }
    });
}

/// Where a sample of a fill lies between the colours of a gradient, seen from a tile's centre.
struct FillPlace {
    float middle = 0, x = 0, y = 0; ///< at the tile's centre, and more per pixel
    float pullX = 0, pullY = 0;     ///< what the slopes of ln φ add

    FillPlace() = default;
    SUFFUSE_PROGRAM FillPlace(const FillValues &v, double centreX, double centreY)
        : middle(float(v.place + v.placeX * centreX + v.placeY * centreY)), x(float(v.placeX)), y(float(v.placeY)),
          pullX(float(-2 * double(slopeUnit) * (v.placeX * v.half[0] + v.placeY * v.half[1]))),
          pullY(float(-2 * double(slopeUnit) * (v.placeX * v.half[1] + v.placeY * v.half[2])))
    {}

    /// `slopeX` and `slopeY` are those of sums.
    SUFFUSE_PROGRAM float at(float dx, float dy, float density, float slopeX, float slopeY) const
    {
        if (!(density > 0))
            return 0;
        const float pull = math::mulAdd_(pullX, slopeX, pullY * slopeY);
        const float place = math::mulAdd_(x, dx, math::mulAdd_(y, dy, middle)) + pull / density;
        return math::min_(math::max_(place, 0.0f), 1.0f);
    }
};

} // namespace suffuse::cuda
