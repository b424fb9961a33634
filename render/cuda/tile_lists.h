// Which chunks meet a macro-tile, and in which of its tiles their strokes can be seen: programs of one warp.
#pragma once

#include "render/cuda/tile_nodes.h"

namespace suffuse::cuda {

/// Where a part of a macro job's chunks begins and ends: the first chunks from there on that begin a stroke.
struct ListedPart {
    std::uint32_t from, to;
};
template <class Warp>
SUFFUSE_PROGRAM ListedPart wholeStrokes(Warp &warp, const Frame &frame, const MacroJob &macro, ListedPart part)
{
    const auto begins = [&](std::uint32_t at) { // bit i: whether chunk at + i does
        return warp.ballot([&](int lane) {
            const std::uint32_t i = at + std::uint32_t(lane);
            return i <= macro.from || i >= macro.to || frame.chunks[i].stroke != frame.chunks[i - 1].stroke;
        });
    };
    for (;;) { // both at once, for their loads' sake
        const std::uint32_t first = begins(part.from), last = begins(part.to);
        part.from += first ? std::uint32_t(Warp::lowest(first)) : std::uint32_t(warpLanes);
        part.to += last ? std::uint32_t(Warp::lowest(last)) : std::uint32_t(warpLanes);
        if (first && last)
            return part;
    }
}

/// Writes one list: of a part of a macro job's chunks, whole strokes, those whose bounds meet it, in order. What does
/// not fit is left out, and the longest list's length is told in the status words.
template <class Warp>
SUFFUSE_PROGRAM void makeList(Warp &warp, const Frame &frame, std::uint32_t index)
{
    constexpr int group = 4; // of 32 chunks, so that several loads are under way
    const MacroJob macro = frame.macros[index / listParts];
    const std::uint32_t part = index % listParts, size = (macro.to - macro.from + listParts - 1) / listParts;
    const auto border = [&](std::uint32_t before) {
        const std::uint32_t at = macro.from + before * size;
        return at < macro.to ? at : macro.to;
    };
    const ListedPart chunks = wholeStrokes(warp, frame, macro, {border(part), border(part + 1)});
    const std::uint32_t begin = chunks.from, to = chunks.to;
    const std::int32_t left = macro.column * macroSide, top = macro.row * macroSide;
    std::uint32_t *list = frame.lists + std::size_t(index) * frame.listRoom;
    std::uint32_t length = 0;
    for (std::uint32_t base = begin; base < to; base += group * warpLanes) {
        std::uint32_t hits[group];
        SUFFUSE_UNROLL
        for (int g = 0; g < group; ++g)
            hits[g] = warp.ballot([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(g * warpLanes + lane);
                if (i >= to)
                    return false;
                const ChunkRecord &c = frame.chunks[i];
                return c.left < left + macroSide && left < c.right && c.top < top + macroSide && top < c.bottom;
            });
        SUFFUSE_UNROLL
        for (int g = 0; g < group; ++g) {
            warp.each([&](int lane) {
                const std::uint32_t at = length + std::uint32_t(Warp::rank(hits[g], lane));
                if ((hits[g] >> lane & 1) && at < frame.listRoom)
                    list[at] = base + std::uint32_t(g * warpLanes + lane);
            });
            length += std::uint32_t(Warp::count(hits[g]));
        }
    }
    warp.each([&](int lane) {
        if (lane == 0) {
            frame.listCounts[index] = length;
            Warp::raise(frame.status + longestList, length);
        }
    });
}

/// A node as culling sees it: centre from the corner of half a macro-tile and reach, px; least eigenvalue of the metric
/// times −log₂ e, weight, and weight times the root of the greatest eigenvalue (as render/cpu/node_boxes.h).
struct CullNode {
    Float4 place; ///< x, y, reachX, reachY
    Float4 decay; ///< slowest, weight, steepest, –

    /// Whether it meets any tile of the half; what meets none adds nothing to them.
    SUFFUSE_PROGRAM bool meetsHalf() const
    {
        constexpr float half = tileSide / 2, width = macroSide, height = macroSide / 2;
        const auto beyond = [](float d, float side) { return math::max_(half - d, d - (side - half)); };
        return NodePlace::outside(math::max_(beyond(place.x, width), 0.0f)) <= place.z &&
               NodePlace::outside(math::max_(beyond(place.y, height), 0.0f)) <= place.w;
    }
};

/// Shared memory of a warp that culls.
struct CullScratch {
    CullNode nodes[chunkNodes];
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
};

SUFFUSE_PROGRAM CullNode cullNodeOf(const NodeRecord &n, std::int32_t cellX, std::int32_t cellY)
{
    const float middle = 0.5f * (n.a + n.c), half = 0.5f * (n.a - n.c);
    const float spread = n.b == 0 ? math::abs_(half) : math::sqrt_(math::mulAdd_(half, half, n.b * n.b));
    const float slowest = math::max_(0.9999f * (middle - spread), 0.0f), greatest = 1.0001f * (middle + spread);
    const float x = float((n.cellX - cellX) * tileSide) + n.x, y = float((n.cellY - cellY) * tileSide) + n.y;
    return {{x, y, n.reachX, n.reachY}, {slowest * -float(math::log2e), n.weight, n.weight * math::sqrt_(greatest), 0}};
}

/// Which tiles of half a macro-tile one stroke may show in, one tile a lane.
template <class Warp>
class StrokeCull {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `half`: 0, the upper four rows of tiles; 1, the lower ones.
    SUFFUSE_PROGRAM StrokeCull(Warp &warp, const Frame &frame, std::uint32_t stroke, const MacroJob &macro, int half,
                               CullScratch &scratch)
        : m_warp(warp), m_frame(frame), m_cellX(macro.column * macroTiles),
          m_cellY(macro.row * macroTiles + half * (macroTiles / 2)), m_s(scratch)
    {
        m_warp.fetch([&](int lane, auto start) { fetchStroke(m_frame, stroke, lane, start, m_s.stroke); });
        m_warp.each([&](int lane) { m_density[lane] = m_slope[lane] = 0, m_weight[lane] = strokeWeight; });
    }

    /// Bit i: whether nodes of the chunk meet tile i.
    SUFFUSE_PROGRAM std::uint32_t add(const ChunkRecord &chunk)
    {
        if (chunk.nodes == 0) // deep nodes lie everywhere
            return m_warp.ballot([&](int lane) { return meetsTile(chunk, cellX(lane), cellY(lane)); });
        Var<CullNode> node;
        const std::uint32_t near = m_warp.ballot([&](int lane) {
            if (std::uint32_t(lane) >= chunk.nodes)
                return false;
            node[lane] = cullNodeOf(m_frame.nodes[chunk.firstNode + std::uint32_t(lane)], m_cellX, m_cellY);
            return !m_frame.cull || node[lane].meetsHalf();
        });
        m_warp.each([&](int lane) {
            if (near >> lane & 1)
                m_s.nodes[Warp::rank(near, lane)] = node[lane];
        });
        const int nodes = Warp::count(near);
        const std::uint32_t hits = m_warp.ballot([&](int lane) {
            constexpr float half = tileSide / 2;
            const float centreX = float(lane % macroTiles * tileSide) + half;
            const float centreY = float(lane / macroTiles * tileSide) + half;
            const std::uint32_t before = m_weight[lane];
            SUFFUSE_UNROLL_BY_4
            for (int n = 0; n < nodes; ++n) {
                const Float4 place = m_s.nodes[n].place, decay = m_s.nodes[n].decay;
                const float outX = NodePlace::outside(place.x - centreX), outY = NodePlace::outside(place.y - centreY);
                const bool counts = (outX <= place.z && outY <= place.w) || !m_frame.cull;
                // Distance u in spreads to the nearest point: e^(−u²), and 2u e^(−u²), which is greatest at u² = ½ and
                // then at most (1 + u²) e^(−u²).
                const float ox = math::max_(outX, 0.0f), oy = math::max_(outY, 0.0f);
                const float log = math::mulAdd_(ox, ox, oy * oy) * decay.x, e = math::exp2_(log);
                const float rise =
                    log > -0.5f * float(math::log2e) ? 0.8578f : math::negMulAdd_(log * float(math::ln2), e, e);
                m_weight[lane] += counts;
                m_density[lane] = math::mulAdd_(decay.y, counts ? e : 0.0f, m_density[lane]);
                m_slope[lane] = math::mulAdd_(decay.z, counts ? rise : 0.0f, m_slope[lane]);
            }
            return m_weight[lane] != before;
        });
        m_warp.meet(); // before the next chunk's nodes
        return hits;
    }

    /// Of the tiles that nodes met those where the stroke may show: F is exactly zero in the others.
    SUFFUSE_PROGRAM std::uint32_t seen()
    {
        m_warp.arrive(false);
        const StrokeRecord &stroke = strokeOf(m_s.stroke);
        return m_warp.ballot([&](int lane) {
            const float phi = m_density[lane] * 1.001f, h = 0.5f * m_slope[lane] * 1.001f;
            if (!m_frame.cull || !stroke.hasLevels || phi > stroke.lowest)
                return true;
            for (int k = 0; k < stroke.shade.kinds; ++k)
                if (!vanishes(stroke.shade.kind[k].kind, stroke.level[k], phi, h))
                    return true;
            return false;
        });
    }

    /// Tells what the stroke costs in the tiles of the mask.
    SUFFUSE_PROGRAM void addWeights(std::uint32_t mask, std::uint32_t *weights)
    {
        m_warp.each([&](int lane) {
            if (mask >> lane & 1)
                Warp::add(weights + lane, m_weight[lane]);
        });
    }

private:
    static constexpr std::uint32_t strokeWeight = 24; ///< of shading and mixing a tile, in nodes

    SUFFUSE_PROGRAM std::int32_t cellX(int lane) const { return m_cellX + lane % macroTiles; }
    SUFFUSE_PROGRAM std::int32_t cellY(int lane) const { return m_cellY + lane / macroTiles; }

    Warp &m_warp;
    const Frame &m_frame;
    std::int32_t m_cellX, m_cellY;
    CullScratch &m_s;
    Var<float> m_density, m_slope; ///< bounds of φ and |∇φ| (per pixel) in the lane's tile
    Var<std::uint32_t> m_weight;
};

/// Where the stroke of a list's entry can be seen in half a macro-tile: writes the masks of all its entries, which lie
/// side by side. Entries that are not their stroke's first are left to that one.
template <class Warp>
SUFFUSE_PROGRAM void cullEntry(Warp &warp, const Frame &frame, std::uint32_t index, std::uint32_t entry, int half,
                               CullScratch &scratch)
{
    const std::uint32_t *list = frame.lists + std::size_t(index) * frame.listRoom;
    std::uint32_t *masks = frame.masks + std::size_t(index) * frame.listRoom * 2 + half;
    const std::uint32_t job = index / listParts;
    // All loads at once; what lies beyond the list is not used.
    const auto within = [&](std::uint32_t i) { return i < frame.listRoom ? i : frame.listRoom - 1; };
    const std::uint32_t counted = frame.listCounts[index], own = list[entry], before = list[entry > 0 ? entry - 1 : 0],
                        after = list[within(entry + 1)];
    const std::uint32_t count = counted < frame.listRoom ? counted : frame.listRoom;
    if (entry >= count)
        return;
    ChunkRecord chunk = frame.chunks[own], next = frame.chunks[entry + 1 < count ? after : own];
    const std::uint32_t stroke = chunk.stroke;
    if (entry > 0 && frame.chunks[before].stroke == stroke)
        return;
    StrokeCull<Warp> cull(warp, frame, stroke, frame.macros[job], half, scratch);
    std::uint32_t end = entry, all = 0, last = 0;
    for (;;) {
        last = cull.add(chunk);
        all |= last;
        if (++end == count || next.stroke != stroke)
            break;
        warp.each([&](int lane) {
            if (lane == 0)
                masks[std::size_t(end - 1) * 2] = last;
        });
        chunk = next;
        next = frame.chunks[list[end + 1 < count ? end + 1 : end]];
    }
    const std::uint32_t seen = cull.seen();
    for (std::uint32_t from = entry; from + 1 < end; from += warpLanes)
        warp.each([&](int lane) {
            if (from + std::uint32_t(lane) + 1 < end)
                masks[std::size_t(from + std::uint32_t(lane)) * 2] &= seen;
        });
    warp.each([&](int lane) {
        if (lane == 0)
            masks[std::size_t(end - 1) * 2] = last & seen;
    });
    cull.addWeights(all & seen, frame.weights + std::size_t(job) * macroTiles * macroTiles + half * warpLanes);
}

} // namespace suffuse::cuda
