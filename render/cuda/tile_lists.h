// Which chunks meet a macro-tile, and in which of its tiles their strokes can be seen: programs of one warp.
#pragma once

#include "render/cuda/tile_nodes.h"

namespace suffuse::cuda {

/// Writes the list of one macro job: the chunks of [from, to) whose bounds meet it, in order. What does not fit is left
/// out, and the longest list's length is told in the status words.
template <class Warp>
SUFFUSE_PROGRAM void makeList(Warp &warp, const Frame &frame, std::uint32_t job)
{
    constexpr int group = 8; // of 32 chunks, so that several loads are under way
    const MacroJob macro = frame.macros[job];
    const std::int32_t left = macro.column * macroSide, top = macro.row * macroSide;
    std::uint32_t *list = frame.lists + std::size_t(job) * frame.listRoom;
    std::uint32_t length = 0;
    for (std::uint32_t base = macro.from; base < macro.to; base += group * warpLanes) {
        std::uint32_t hits[group];
        SUFFUSE_UNROLL
        for (int g = 0; g < group; ++g)
            hits[g] = warp.ballot([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(g * warpLanes + lane);
                if (i >= macro.to)
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
            frame.listCounts[job] = length;
            Warp::raise(frame.status + longestList, length);
        }
    });
}

/// Which tiles of half a macro-tile one stroke may show in, one tile a lane.
template <class Warp>
class StrokeCull {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `half`: 0, the upper four rows of tiles; 1, the lower ones.
    SUFFUSE_PROGRAM StrokeCull(Warp &warp, const Frame &frame, const MacroJob &macro, int half, Fetched &fetched)
        : m_warp(warp), m_frame(frame), m_cellX(macro.column * macroTiles),
          m_cellY(macro.row * macroTiles + half * (macroTiles / 2)), m_fetched(fetched)
    {
        m_warp.each([&](int lane) { m_bound[lane] = {}, m_weight[lane] = strokeWeight; });
    }

    /// Bit i: whether nodes of the chunk meet tile i.
    SUFFUSE_PROGRAM std::uint32_t add(const ChunkRecord &chunk)
    {
        fetchChunk(m_warp, m_frame, chunk, m_fetched);
        m_warp.arrive(false);
        return m_warp.ballot([&](int lane) {
            bool hit = chunk.nodes == 0 && meetsTile(chunk, cellX(lane), cellY(lane)); // deep nodes lie everywhere
            for (int n = 0; n < int(chunk.nodes); ++n) {
                const NodeRecord node = nodeOf(m_fetched, n);
                const NodePlace place(node, cellX(lane), cellY(lane));
                if (!place.meets && m_frame.cull)
                    continue;
                hit = true;
                ++m_weight[lane];
                place.addTo(node, m_bound[lane]);
            }
            return hit;
        });
    }

    /// Of the tiles that nodes met those where the stroke may show: F is exactly zero in the others.
    SUFFUSE_PROGRAM std::uint32_t seen()
    {
        const StrokeRecord &stroke = strokeOf(m_fetched.stroke);
        return m_warp.ballot([&](int lane) {
            const float phi = m_bound[lane].density * 1.001f, h = 0.5f * m_bound[lane].slope * 1.001f;
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
    Fetched &m_fetched;
    Var<LaneBound> m_bound;
    Var<std::uint32_t> m_weight;
};

/// Where the stroke of a list's entry can be seen in half a macro-tile: writes the masks of all its entries, which lie
/// side by side. Entries that are not their stroke's first are left to that one.
template <class Warp>
SUFFUSE_PROGRAM void cullEntry(Warp &warp, const Frame &frame, std::uint32_t job, std::uint32_t entry, int half,
                               Fetched &fetched)
{
    const std::uint32_t counted = frame.listCounts[job];
    const std::uint32_t count = counted < frame.listRoom ? counted : frame.listRoom;
    if (entry >= count)
        return;
    const std::uint32_t *list = frame.lists + std::size_t(job) * frame.listRoom;
    std::uint32_t *masks = frame.masks + std::size_t(job) * frame.listRoom * 2 + half;
    const std::uint32_t stroke = frame.chunks[list[entry]].stroke;
    if (entry > 0 && frame.chunks[list[entry - 1]].stroke == stroke)
        return;
    StrokeCull<Warp> cull(warp, frame, frame.macros[job], half, fetched);
    std::uint32_t end = entry, all = 0;
    for (; end < count; ++end) {
        const ChunkRecord chunk = frame.chunks[list[end]];
        if (chunk.stroke != stroke)
            break;
        const std::uint32_t mask = cull.add(chunk);
        all |= mask;
        warp.each([&](int lane) {
            if (lane == 0)
                masks[std::size_t(end) * 2] = mask;
        });
    }
    const std::uint32_t seen = cull.seen();
    for (std::uint32_t from = entry; from < end; from += warpLanes)
        warp.each([&](int lane) {
            if (from + std::uint32_t(lane) < end)
                masks[std::size_t(from + std::uint32_t(lane)) * 2] &= seen;
        });
    cull.addWeights(all & seen, frame.weights + std::size_t(job) * macroTiles * macroTiles + half * warpLanes);
}

} // namespace suffuse::cuda
