// These programs of a warp and of a block find which chunks meet a macro-tile, and in which tiles strokes can show.
#pragma once

#include "render/cuda/tile_order.h"

namespace suffuse::cuda {

/// Bounds a part of a macro job's chunks.
struct ListedPart {
    std::uint32_t from, to;
};
/// Moves both ends of a part on to the next chunk that begins a stroke, so that parts consist of whole strokes.
template <class Warp>
SUFFUSE_PROGRAM ListedPart wholeStrokes(Warp &warp, const Frame &frame, const MacroJob &macro, ListedPart part)
{
    const auto begins = [&](std::uint32_t at) { // Bit i says whether chunk at + i does.
        return warp.ballot([&](int lane) {
            const std::uint32_t i = at + std::uint32_t(lane);
            return i <= macro.from || i >= macro.to || frame.chunks[i].stroke != frame.chunks[i - 1].stroke;
        });
    };
    for (;;) { // Both ends are looked for at once, so that their loads overlap.
        const std::uint32_t first = begins(part.from), last = begins(part.to);
        part.from += first ? std::uint32_t(Warp::lowest(first)) : std::uint32_t(warpLanes);
        part.to += last ? std::uint32_t(Warp::lowest(last)) : std::uint32_t(warpLanes);
        if (first && last)
            return part;
    }
}

/// Holds a node as culling sees it: its centre, from the corner of half a macro-tile, and its reach, px; the least
/// eigenvalue of the metric times −log₂ e, the weight if it lays paint, and |weight| times the root of the greatest
/// eigenvalue (as in render/scene/node_boxes.h).
struct CullNode {
    Float4 place; ///< x, y, reachX, reachY
    Float4 decay; ///< slowest, weight, steepest, nothing

    /// Tells whether it meets any tile of the half. If it meets none, it adds nothing to them.
    SUFFUSE_PROGRAM bool meetsHalf() const
    {
        constexpr float half = tileSide / 2, width = macroSide, height = macroSide / 2;
        const auto beyond = [](float d, float side) { return math::max_(half - d, d - (side - half)); };
        return NodePlace::outside(math::max_(beyond(place.x, width), 0.0f)) <= place.z &&
               NodePlace::outside(math::max_(beyond(place.y, height), 0.0f)) <= place.w;
    }
};

/// A warp that culls has this in shared memory.
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
    const float laid = math::max_(n.weight, 0.0f), steepest = math::abs_(n.weight) * math::sqrt_(greatest);
    return {{x, y, n.reachX, n.reachY}, {slowest * -float(math::log2e), laid, steepest, 0}};
}

/// Finds in which tiles of half a macro-tile one stroke may show. Each lane looks at one tile.
template <class Warp>
class StrokeCull {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// The half's first tile lies in cell (cellX, cellY).
    SUFFUSE_PROGRAM StrokeCull(Warp &warp, const Frame &frame, std::uint32_t stroke, std::int32_t cellX,
                               std::int32_t cellY, CullScratch &scratch)
        : m_warp(warp), m_frame(frame), m_cellX(cellX), m_cellY(cellY), m_s(scratch)
    {
        m_warp.fetch([&](int lane, auto start) { fetchStroke(m_frame, stroke, lane, start, m_s.stroke); });
        m_warp.each([&](int lane) { m_density[lane] = m_slope[lane] = 0, m_met[lane] = 0; });
    }

    /// Adds a chunk of the stroke. Bit i of the result says whether nodes of the chunk meet tile i.
    SUFFUSE_PROGRAM std::uint32_t add(const ListEntry &chunk)
    {
        const std::uint32_t listed = nodesOf(chunk);
        if (listed == 0) // Deep nodes lie everywhere.
            return m_warp.ballot(
                [&](int lane) { return meetsTile(m_frame.chunks[chunk.chunk], cellX(lane), cellY(lane)); });
        Var<CullNode> node;
        const std::uint32_t near = m_warp.ballot([&](int lane) {
            if (std::uint32_t(lane) >= listed)
                return false;
            node[lane] = cullNodeOf(m_frame.nodes[chunk.firstNode + std::uint32_t(lane)], m_cellX, m_cellY);
            if (!m_frame.cull)
                node[lane].place.z = node[lane].place.w = 1e30f;
            return node[lane].meetsHalf();
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
            const std::uint32_t before = m_met[lane];
            SUFFUSE_UNROLL_BY_4
            for (int n = 0; n < nodes; ++n) {
                const Float4 place = m_s.nodes[n].place, decay = m_s.nodes[n].decay;
                const float outX = NodePlace::outside(place.x - centreX), outY = NodePlace::outside(place.y - centreY);
                const bool counts = outX <= place.z && outY <= place.w;
                // The nearest point of the tile is u spreads away. The density there is e^(−u²). Its slope 2u e^(−u²),
                // which is greatest at u² = ½, is at most (1 + u²) e^(−u²).
                const float ox = math::max_(outX, 0.0f), oy = math::max_(outY, 0.0f);
                const float log = counts ? math::mulAdd_(ox, ox, oy * oy) * decay.x : -1000.0f;
                const float e = math::exp2_(log);
                const float rise = math::min_(0.8578f, math::negMulAdd_(log * float(math::ln2), e, e));
                m_met[lane] += counts;
                m_density[lane] = math::mulAdd_(decay.y, e, m_density[lane]);
                m_slope[lane] = math::mulAdd_(decay.z, rise, m_slope[lane]);
            }
            return m_met[lane] != before;
        });
        m_warp.meet(); // The next chunk's nodes overwrite these.
        return hits;
    }

    /// Finds the tiles where the stroke may show. In the others F is exactly zero.
    SUFFUSE_PROGRAM std::uint32_t seen()
    {
        m_warp.arrive(false);
        const StrokeRecord &stroke = strokeOf(m_s.stroke);
        return m_warp.ballot([&](int lane) {
            const float phi = m_density[lane] * 1.001f, h = 0.5f * m_slope[lane] * 1.001f;
            if (!m_frame.cull || !stroke.hasLevels || phi > stroke.lowest)
                return true;
            for (int k = 0; k < stroke.shade.kinds; ++k)
                if (!vanishes(stroke.shade, k, stroke.level[k], phi, h))
                    return true;
            return false;
        });
    }

    /// Adds what the stroke costs to the weights of the tiles in the mask.
    SUFFUSE_PROGRAM void addWeights(std::uint32_t mask, std::uint32_t *weights)
    {
        // What a node costs was measured; it depends on how often the nodes are summed.
        const ShadeParams &shade = strokeOf(m_s.stroke).shade;
        const std::uint32_t nodeWeight = shade.colourChannel >= 0 ? 17 : shade.lineChannel >= 0 ? 7 : 4;
        m_warp.each([&](int lane) {
            if (mask >> lane & 1)
                Warp::add(weights + lane, strokeWeight + nodeWeight * m_met[lane]);
        });
    }

private:
    static constexpr std::uint32_t strokeWeight = 96; ///< the cost of shading and mixing at a tile

    SUFFUSE_PROGRAM std::int32_t cellX(int lane) const { return m_cellX + lane % macroTiles; }
    SUFFUSE_PROGRAM std::int32_t cellY(int lane) const { return m_cellY + lane / macroTiles; }

    Warp &m_warp;
    const Frame &m_frame;
    std::int32_t m_cellX, m_cellY;
    CullScratch &m_s;
    Var<float> m_density, m_slope; ///< bounds of φ and |∇φ| (per pixel) in the lane's tile
    Var<std::uint32_t> m_met;      ///< nodes that meet the tile
};

inline constexpr int listWarps = 8;

/// A block that makes a list has this in shared memory.
struct ListScratch {
    static constexpr int groups = 2; ///< A warp looks at so many groups of 32 chunks at once, so that loads overlap.
    std::uint32_t hits[listWarps * groups];
    std::uint32_t weights[listTiles];
    std::uint32_t next; ///< the entry that is culled next
    union {             // They are used one after the other.
        CullScratch cull[listWarps];
        ListEntry kept[listWarps * warpLanes];
    };
};

/// Makes one list, in order: the chunks that can be seen in half of a macro-tile, of a quarter of the macro job's
/// chunks (rounded to whole strokes).
template <class Block>
class ListMaker {
public:
    using Warp = typename Block::Warp;

    SUFFUSE_PROGRAM ListMaker(Block &block, const Frame &frame, std::uint32_t index, ListScratch &scratch)
        : m_block(block), m_frame(frame), m_index(index), m_half(index / listQuarters % 2),
          m_macro(frame.macros[index / listParts]), m_list(frame.lists + std::size_t(index) * frame.listRoom),
          m_s(scratch)
    {}

    SUFFUSE_PROGRAM void make()
    {
        gather();
        m_block.each([&](Warp &warp, int own) { cull(warp, m_s.cull[own]); });
        if (m_frame.ordered)
            m_block.one([&](Warp &warp) { tellWeights(warp); });
        compact();
    }

private:
    static constexpr int groups = ListScratch::groups;

    SUFFUSE_PROGRAM std::int32_t cellX() const { return m_macro.column * macroTiles; }
    SUFFUSE_PROGRAM std::int32_t cellY() const
    {
        return m_macro.row * macroTiles + std::int32_t(m_half) * (macroTiles / 2);
    }

    /// Lists the chunks whose bounds meet the half.
    SUFFUSE_PROGRAM void gather()
    {
        const std::uint32_t part = m_index % listQuarters;
        const std::uint32_t size = (m_macro.to - m_macro.from + listQuarters - 1) / listQuarters;
        const auto border = [&](std::uint32_t before) {
            const std::uint32_t at = m_macro.from + before * size;
            return at < m_macro.to ? at : m_macro.to;
        };
        const ListedPart chunks = wholeStrokes(m_block.warp(), m_frame, m_macro, {border(part), border(part + 1)});
        const std::int32_t left = cellX() * tileSide, top = cellY() * tileSide;
        for (std::uint32_t base = chunks.from; base < chunks.to; base += listWarps * groups * warpLanes) {
            const auto chunkOf = [&](int group, int lane) { return base + std::uint32_t(group * warpLanes + lane); };
            m_block.each([&](Warp &warp, int own) {
                typename Warp::template Var<ChunkRecord> chunk[groups]; // All loads are started at once.
                SUFFUSE_UNROLL
                for (int g = 0; g < groups; ++g)
                    warp.each([&](int lane) {
                        const std::uint32_t i = chunkOf(own * groups + g, lane);
                        chunk[g][lane] = m_frame.chunks[i < chunks.to ? i : chunks.to - 1];
                    });
                std::uint32_t hits[groups];
                SUFFUSE_UNROLL
                for (int g = 0; g < groups; ++g)
                    hits[g] = warp.ballot([&](int lane) {
                        const ChunkRecord &c = chunk[g][lane];
                        return chunkOf(own * groups + g, lane) < chunks.to && c.left < left + macroSide &&
                               left < c.right && c.top < top + macroSide / 2 && top < c.bottom;
                    });
                tellHits(warp, own, hits);
            });
            m_block.each([&](Warp &warp, int own) {
                forEachHit<groups>(warp, own, m_count, [&](int group, int lane, std::uint32_t at) {
                    const std::uint32_t i = chunkOf(group, lane);
                    if (at >= m_frame.listRoom)
                        return;
                    const ChunkRecord &c = m_frame.chunks[i];
                    m_list[at] = {i, c.firstNode, c.stroke * 64 + c.nodes, 0};
                });
            });
            m_count = m_after;
        }
        m_block.each([&](Warp &warp, int own) {
            warp.each([&](int lane) {
                if (own == 0 && lane == 0)
                    Warp::raise(m_frame.status + longestList, m_count);
                if (own == 0)
                    m_s.weights[lane] = 0, m_s.next = 0;
            });
        });
        m_count = m_count < m_frame.listRoom ? m_count : m_frame.listRoom;
    }

    /// Tells the other warps which chunks this one found in its groups of 32.
    template <int count>
    SUFFUSE_PROGRAM void tellHits(Warp &warp, int own, const std::uint32_t (&hits)[count])
    {
        warp.each([&](int lane) {
            if (lane == 0)
                for (int g = 0; g < count; ++g)
                    m_s.hits[own * count + g] = hits[g];
        });
    }

    /// Calls use(group, lane, place) for each chunk that this warp found. Places go on from `before`, over all warps.
    template <int count, class Use>
    SUFFUSE_PROGRAM void forEachHit(Warp &warp, int own, std::uint32_t before, Use use)
    {
        std::uint32_t at = before;
        SUFFUSE_UNROLL
        for (int g = 0; g < listWarps * count; ++g) {
            const std::uint32_t mask = m_s.hits[g];
            if (g / count == own)
                warp.each([&](int lane) {
                    if (mask >> lane & 1)
                        use(g, lane, at + std::uint32_t(Warp::rank(mask, lane)));
                });
            at += std::uint32_t(Warp::count(mask));
        }
        m_after = at;
    }

    /// Takes strokes and finds where they can be seen, until none is left.
    SUFFUSE_PROGRAM void cull(Warp &warp, CullScratch &scratch)
    {
        for (std::uint32_t entry; (entry = warp.take(&m_s.next)) < m_count;) {
            const ListEntry chunk = m_list[entry];
            if (entry == 0 || strokeIndexOf(m_list[entry - 1]) != strokeIndexOf(chunk))
                cullStroke(warp, entry, chunk, scratch);
        }
    }

    SUFFUSE_PROGRAM void cullStroke(Warp &warp, std::uint32_t entry, ListEntry chunk, CullScratch &scratch)
    {
        const std::uint32_t stroke = strokeIndexOf(chunk), begin = entry;
        StrokeCull<Warp> cull(warp, m_frame, stroke, cellX(), cellY(), scratch);
        std::uint32_t all = 0, last = 0;
        for (;;) {
            const std::uint32_t next = entry + 1;
            const ListEntry after = m_list[next < m_count ? next : entry];
            last = cull.add(chunk);
            all |= last;
            if (next == m_count || strokeIndexOf(after) != stroke)
                break;
            warp.each([&](int lane) {
                if (lane == 0)
                    m_list[entry].mask = last;
            });
            chunk = after, entry = next;
        }
        const std::uint32_t seen = cull.seen();
        warp.each([&](int lane) {
            for (std::uint32_t i = begin + std::uint32_t(lane); i < entry; i += warpLanes)
                m_list[i].mask &= seen;
            if (lane == 0)
                m_list[entry].mask = last & seen;
        });
        cull.addWeights(all & seen, m_s.weights);
    }

    /// Leaves out what can be seen nowhere, and writes down the list's length.
    SUFFUSE_PROGRAM void compact()
    {
        std::uint32_t count = 0;
        for (std::uint32_t from = 0; from < m_count; from += listWarps * warpLanes) {
            m_block.each([&](Warp &warp, int own) {
                const std::uint32_t hits[1] = {warp.ballot([&](int lane) {
                    const std::uint32_t i = from + std::uint32_t(own * warpLanes + lane);
                    if (i >= m_count)
                        return false;
                    const ListEntry entry = m_list[i];
                    m_s.kept[own * warpLanes + lane] = entry;
                    return entry.mask != 0;
                })};
                tellHits(warp, own, hits);
            });
            m_block.each([&](Warp &warp, int own) {
                forEachHit<1>(warp, own, count, [&](int group, int lane, std::uint32_t at) {
                    m_list[at] = m_s.kept[group * warpLanes + lane];
                });
            });
            count = m_after;
        }
        m_block.each([&](Warp &warp, int own) {
            warp.each([&](int lane) {
                if (own == 0 && lane == 0)
                    m_frame.listCounts[m_index] = count;
            });
        });
    }

    /// Adds up what the half's tiles cost. The last of a tile's lists to do so puts the tile in order.
    SUFFUSE_PROGRAM void tellWeights(Warp &warp)
    {
        constexpr std::uint32_t told = 1u << 28; // The bits from here on count the lists that have added theirs.
        constexpr int groups = macroTiles * macroTiles / warpLanes;
        typename Warp::template Var<TileJob> tile[groups];
        warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int g = 0; g < groups; ++g) {
                const std::uint32_t job = jobOf(g, lane), last = m_frame.tileCount - 1;
                tile[g][lane] = m_frame.tiles[job < last ? job : last];
            }
            std::uint32_t *weight = m_frame.weights + std::size_t(m_index / listQuarters) * listTiles + lane;
            const std::uint32_t own = m_s.weights[lane] + told;
            m_s.weights[lane] = Warp::add(weight, own) + own;
        });
        warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int g = 0; g < groups; ++g) {
                const TileJob &job = tile[g][lane];
                const std::uint32_t row = job.row % macroTiles, half = row / (macroTiles / 2);
                const std::uint32_t weight = m_s.weights[row % (macroTiles / 2) * macroTiles + job.column % macroTiles];
                if (jobOf(g, lane) < m_frame.tileCount && job.macro == m_index / listParts && half == m_half &&
                    weight / told == listQuarters)
                    putInOrder<Warp>(m_frame, jobOf(g, lane), weight % told);
            }
        });
    }
    SUFFUSE_PROGRAM std::uint32_t jobOf(int group, int lane) const
    {
        return m_macro.firstTile + std::uint32_t(group * warpLanes + lane);
    }

    Block &m_block;
    const Frame &m_frame;
    const std::uint32_t m_index, m_half;
    const MacroJob m_macro;
    ListEntry *m_list;
    ListScratch &m_s;
    std::uint32_t m_count = 0, m_after = 0;
};

} // namespace suffuse::cuda
