// These programs of a warp and of a block find which chunks meet a macro-tile, and in which tiles strokes can show.
#pragma once

#include "render/cuda/tiles/tile_cull.h"
#include "render/cuda/tiles/tile_order.h"

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

inline constexpr int listWarps = 8;

/// Holds an entry of a list while what is seen nowhere is left out.
struct KeptEntry {
    ListEntry entry;
    ApartEntry apart;
};

/// A block that makes a list has this in shared memory.
template <bool fills>
struct ListScratch {
    /// A stroke of more than longEntries entries is long: all warps cull it together, so that none is late. Rounds of
    /// longTogether long strokes are culled at once. There is room for mostLong; a warp culls others alone.
    static constexpr std::uint32_t longEntries = 12, mostLong = 64;
    static constexpr int longTogether = 4;
    static constexpr int groups = 2; ///< A warp looks at so many groups of 32 chunks at once, so that loads overlap.
    std::uint32_t hits[listWarps * groups];
    std::uint32_t weights[listTiles];
    std::uint32_t next;            ///< the entry that is culled next
    std::uint32_t apart;           ///< whether a stroke is evaluated apart
    std::uint32_t longOnes;        ///< how many of these there are
    std::uint32_t first[mostLong]; ///< the first entries of long strokes
    CullPart<fills> parts[longTogether][listWarps];
    union { // They are used one after the other.
        CullScratch cull[listWarps];
        KeptEntry kept[listWarps * warpLanes];
    };
};

/// Makes one list, in order: the chunks that can be seen in half of a macro-tile, of a quarter of the macro job's
/// chunks (rounded to whole strokes). If `fills`, strokes may have fills.
template <class Block, bool fills>
class ListMaker {
public:
    using Warp = typename Block::Warp;

    SUFFUSE_PROGRAM ListMaker(Block &block, const Frame &frame, std::uint32_t index, ListScratch<fills> &scratch)
        : m_block(block), m_frame(frame), m_index(index), m_half(index / listQuarters % 2),
          m_macro(frame.macros[index / listParts]), m_list(frame.lists + std::size_t(index) * frame.listRoom),
          m_apart(frame.apart ? frame.apart + std::size_t(index) * frame.listRoom : nullptr), m_s(scratch)
    {}

    SUFFUSE_PROGRAM void make()
    {
        gather();
        m_block.each([&](Warp &warp, int own) { cull(warp, m_s.cull[own]); });
        cullLong();
        if (m_frame.ordered)
            m_block.one([&](Warp &warp) { tellWeights(warp); });
        compact();
    }

private:
    static constexpr int groups = ListScratch<fills>::groups;

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
                    m_list[at] = {i, c.firstNode, c.stroke * 128 + c.nodes, 0};
                    if (m_frame.apartRoom)
                        m_apart[at] = {0, 0};
                });
            });
            m_count = m_after;
        }
        m_block.each([&](Warp &warp, int own) {
            warp.each([&](int lane) {
                if (own == 0 && lane == 0)
                    Warp::raise(m_frame.status + longestList, m_count);
                if (own == 0)
                    m_s.weights[lane] = 0, m_s.next = 0, m_s.apart = 0, m_s.longOnes = 0;
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
                if (!isLong(warp, entry, strokeIndexOf(chunk)))
                    cullStroke(warp, entry, chunk, scratch);
        }
    }

    /// Tells whether the stroke that begins with an entry is long, and then remembers it.
    SUFFUSE_PROGRAM bool isLong(Warp &warp, std::uint32_t entry, std::uint32_t stroke)
    {
        constexpr std::uint32_t longEntries = ListScratch<fills>::longEntries, most = ListScratch<fills>::mostLong;
        if (entry + longEntries >= m_count || strokeIndexOf(m_list[entry + longEntries]) != stroke ||
            nodesOf(m_list[entry]) == 0) // Where deep nodes lie is not counted.
            return false;
        const std::uint32_t place = warp.take(&m_s.longOnes);
        if (place >= most)
            return false;
        warp.each([&](int lane) {
            if (lane == 0)
                m_s.first[place] = entry;
        });
        return true;
    }

    /// Culls long strokes: each warp takes some entries of each, and then one warp for each stroke adds the parts.
    SUFFUSE_PROGRAM void cullLong()
    {
        constexpr std::uint32_t together = ListScratch<fills>::longTogether, most = ListScratch<fills>::mostLong;
        const std::uint32_t count = m_s.longOnes < most ? m_s.longOnes : most;
        for (std::uint32_t from = 0; from < count; from += together) {
            const std::uint32_t to = from + together < count ? from + together : count;
            m_block.each([&](Warp &warp, int own) {
                for (std::uint32_t i = from; i < to; ++i)
                    cullPart(warp, m_s.first[i], own, m_s.parts[i - from][own]);
            });
            m_block.each([&](Warp &warp, int own) {
                if (std::uint32_t(own) < together && from + std::uint32_t(own) < to)
                    finishLong(warp, m_s.first[from + std::uint32_t(own)], m_s.cull[own], m_s.parts[own]);
            });
        }
    }

    SUFFUSE_PROGRAM void cullPart(Warp &warp, std::uint32_t begin, int own, CullPart<fills> &part)
    {
        const std::uint32_t stroke = strokeIndexOf(m_list[begin]);
        StrokeCull<Warp, fills> cull(warp, m_frame, stroke, cellX(), cellY(), m_s.cull[own]);
        for (std::uint32_t i = begin + std::uint32_t(own); i < m_count; i += listWarps) {
            const ListEntry entry = m_list[i];
            if (strokeIndexOf(entry) != stroke)
                break;
            const std::uint32_t hits = cull.add(entry);
            warp.each([&](int lane) {
                if (lane == 0)
                    m_list[i].mask = hits;
            });
        }
        warp.arrive(false);
        cull.give(part);
    }

    SUFFUSE_PROGRAM void finishLong(Warp &warp, std::uint32_t begin, CullScratch &scratch,
                                    const CullPart<fills> (&parts)[listWarps])
    {
        const ListEntry first = m_list[begin];
        const std::uint32_t stroke = strokeIndexOf(first);
        StrokeCull<Warp, fills> cull(warp, m_frame, stroke, cellX(), cellY(), scratch);
        for (const CullPart<fills> &part : parts)
            cull.take(part);
        std::uint32_t all = 0, entry = begin, lastChunk = first.chunk;
        for (std::uint32_t base = begin; base < m_count; base += warpLanes) { // Finds the stroke's last entry.
            typename Warp::template Var<std::uint32_t> chunk;
            const std::uint32_t own = warp.ballot([&](int lane) {
                const std::uint32_t i = base + std::uint32_t(lane);
                const ListEntry e = m_list[i < m_count ? i : m_count - 1];
                chunk[lane] = e.chunk;
                return i < m_count && strokeIndexOf(e) == stroke;
            });
            if (own == 0)
                break;
            const int count = Warp::count(own); // They lie side by side.
            entry = base + std::uint32_t(count) - 1;
            lastChunk = warp.read(chunk, count - 1);
            if (count < warpLanes)
                break;
        }
        all = cull.metTiles();
        const std::uint32_t seen = cull.seen();
        warp.each([&](int lane) {
            for (std::uint32_t i = begin + std::uint32_t(lane); i <= entry; i += warpLanes)
                m_list[i].mask &= seen;
        });
        finishStroke(warp, cull, all & seen, begin, entry, first.chunk, lastChunk);
    }

    SUFFUSE_PROGRAM void cullStroke(Warp &warp, std::uint32_t entry, ListEntry chunk, CullScratch &scratch)
    {
        const std::uint32_t stroke = strokeIndexOf(chunk), begin = entry, firstChunk = chunk.chunk;
        StrokeCull<Warp, fills> cull(warp, m_frame, stroke, cellX(), cellY(), scratch);
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
        finishStroke(warp, cull, all & seen, begin, entry, firstChunk, chunk.chunk);
    }

    /// Decides where a stroke with the entries [begin, end] is evaluated, and adds what it costs to the tiles.
    SUFFUSE_PROGRAM void finishStroke(Warp &warp, StrokeCull<Warp, fills> &cull, std::uint32_t visible,
                                      std::uint32_t begin, std::uint32_t end, std::uint32_t firstChunk,
                                      std::uint32_t lastChunk)
    {
        const std::uint32_t shown = visible & m_frame.macros[m_index / listParts].painted[m_half];
        ApartEntry apart{0, 0};
        apart.mask = cull.apart(shown, m_frame.macros[m_index / listParts].general[m_half], m_s.weights);
        if (apart.mask && findSlots(warp, apart)) {
            ApartJob job;
            job.stroke = strokeIndexOf(m_list[begin]), job.from = firstChunk, job.to = lastChunk + 1;
            const std::uint32_t costly = cull.costly(apart.mask);
            const bool plain = cull.stroke().plain != 0;
            giveJobs(warp, job, apart, costly, plain ? costlyPlain : costlyGeneral);
            giveJobs(warp, job, apart, apart.mask & ~costly, plain ? otherPlain : otherGeneral);
            warp.each([&](int lane) {
                for (std::uint32_t i = begin + std::uint32_t(lane); i <= end; i += warpLanes)
                    m_apart[i] = apart;
                if (lane == 0)
                    m_s.apart = 1;
            });
        }
        cull.addWeights(shown, apart.mask, m_s.weights);
    }

    /// Finds slots for a stroke at the tiles of `apart`. If there is no room, it is evaluated with the tiles.
    SUFFUSE_PROGRAM bool findSlots(Warp &warp, ApartEntry &apart)
    {
        const auto count = std::uint32_t(Warp::count(apart.mask));
        apart.slot = warp.take(m_frame.status + slotsTaken, count);
        if (apart.slot + count > m_frame.apartRoom)
            apart = {0, 0};
        return apart.mask != 0;
    }

    /// Gives jobs of a class for those tiles of the stroke that are in the mask.
    SUFFUSE_PROGRAM void giveJobs(Warp &warp, const ApartJob &stroke, const ApartEntry &apart, std::uint32_t mask,
                                  ApartClass kind)
    {
        if (mask == 0)
            return;
        const std::uint32_t first =
            warp.take(m_frame.status + firstApartCount + kind, std::uint32_t(Warp::count(mask)));
        warp.each([&](int lane) {
            if (!(mask >> lane & 1))
                return;
            ApartJob job = stroke;
            job.column = std::uint16_t(cellX() + lane % macroTiles);
            job.row = std::uint16_t(cellY() + lane / macroTiles);
            job.slot = apart.slot + std::uint32_t(Warp::rank(apart.mask, lane));
            m_frame.apartJobs[std::size_t(kind) * m_frame.apartRoom + first + std::uint32_t(Warp::rank(mask, lane))] =
                job;
        });
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
                    m_s.kept[own * warpLanes + lane].entry = entry;
                    if (m_s.apart)
                        m_s.kept[own * warpLanes + lane].apart = m_apart[i];
                    return entry.mask != 0;
                })};
                tellHits(warp, own, hits);
            });
            m_block.each([&](Warp &warp, int own) {
                forEachHit<1>(warp, own, count, [&](int group, int lane, std::uint32_t at) {
                    m_list[at] = m_s.kept[group * warpLanes + lane].entry;
                    if (m_s.apart)
                        m_apart[at] = m_s.kept[group * warpLanes + lane].apart;
                });
            });
            count = m_after;
        }
        m_block.each([&](Warp &warp, int own) {
            warp.each([&](int lane) {
                if (own == 0 && lane == 0)
                    m_frame.listCounts[m_index] = count | (m_s.apart ? anyApart : 0);
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
    ApartEntry *m_apart; ///< beside the list
    ListScratch<fills> &m_s;
    std::uint32_t m_count = 0, m_after = 0;
};

} // namespace suffuse::cuda
