// The nodes of one stroke come here in runs, as many as there are near a tile.
#pragma once

#include "render/cuda/tiles/tile_fill.h"

namespace suffuse::cuda {

/// A warp has this in shared memory while it paints strokes.
struct PaintScratch {
    SumScratch sums;
    union {                 // They are used one after the other.
        Fetched fetched[2]; ///< the present chunk and the next one
        double deep[1 + maxChannels][deepTerms];
    };
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
    float eta[tileSize]; ///< the paper at the tile's pixels, once it is needed
};

/// Says what listChunks has listed.
struct PartialListing {
    Listing listing;
    std::uint32_t chunk = 0; ///< the first chunk that is not listed
};
/// Lists nodes of the chunks [chunk, end) until the list is full, for a stroke with more nodes near a tile than can be
/// listed at once. Such strokes are rare, so this is called, not inlined.
template <bool fills, class Warp>
SUFFUSE_CALL PartialListing listChunks(Warp warp, const Frame &frame, const StrokeRecord &stroke, std::uint32_t chunk,
                                       std::uint32_t end, std::int32_t cellX, std::int32_t cellY, SumScratch &s)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(s);
    PartialListing part;
    for (part.chunk = chunk; part.chunk < end; part.chunk += warpLanes) {
        const std::uint32_t base = part.chunk;
        std::uint32_t hits = warp.ballot([&](int lane) {
            const std::uint32_t i = base + std::uint32_t(lane);
            return i < end && meetsTile(frame.chunks[i], cellX, cellY);
        });
        for (; hits; hits &= hits - 1) {
            const std::uint32_t at = base + std::uint32_t(Warp::lowest(hits));
            const ChunkRecord c = frame.chunks[at];
            if (fills && !(c.nodes & fillChunk))
                endFill(part.listing);
            if (!(fills && (c.nodes & fillChunk)) && part.listing.count + chunkNodes > nodeRoom) {
                part.chunk = at;
                return part;
            }
            fetchChunk(warp, frame, c, s.chosenAgain);
            warp.arrive(false);
            if (fills && (c.nodes & fillChunk)) {
                if (listFill(warp, s.chosenAgain, int(c.nodes & chunkCountBits), frame.fills[stroke.fillValues], cellX,
                             cellY, Block{}, s, part.listing)) {
                    warp.meet();
                    continue;
                }
                part.chunk = at;
                return part;
            }
            listNodes(warp, frame.cull != 0, s.chosenAgain, int(c.nodes), cellX, cellY, Block{}, s, part.listing);
        }
    }
    return part;
}

/// Lists those nodes of a job's stroke that meet a block of samples. While nodes are listed, the next chunk is on its
/// way to shared memory.
template <class Warp, bool fills = false>
class NodeStream {
public:
    /// `fetched` has two places.
    SUFFUSE_PROGRAM NodeStream(Warp &warp, const Frame &frame, const ApartJob &job, Fetched *fetched,
                               SumScratch &scratch)
        : m_warp(warp), m_frame(frame), m_job(job), m_fetched(fetched), m_s(scratch)
    {}

    SUFFUSE_PROGRAM const ApartJob &job() const { return m_job; }

    /// Calls use(listing) for runs of listed nodes, in order, until all that meet the block were listed.
    template <class Use>
    SUFFUSE_PROGRAM void forEachListing(const Block &block, Use use)
    {
        forEachListing(block, use, [](const Fetched &, int, Listing &) {});
    }
    /// Chunks of the stroke's fill are given to listFill(chunk, records, listing), which lists up to 64 entries of
    /// each.
    template <class Use, class ListFill>
    SUFFUSE_PROGRAM void forEachListing(const Block &block, Use use, ListFill listFill)
    {
        m_next = m_job.from, m_hits = 0;
        Listing listing;
        std::uint32_t nodes = fetchNext(0);
        for (int turn = 0;; turn ^= 1) { // Only one place uses a run, since its code is long.
            const std::uint32_t present = nodes;
            if (present)
                nodes = fetchNext(turn ^ 1);
            m_warp.arrive(present != 0);
            const bool ofFill = fills && (present & fillChunk) != 0;
            if (fills && !ofFill)
                endFill(listing);
            if (listing.count + (ofFill ? 2 : 1) * chunkNodes > nodeRoom ||
                (present == 0 && (listing.count > 0 || (fills && listing.base != 0)))) {
                use(listing);
                listing = {};
                m_warp.meet();
            }
            if (present == 0)
                return;
            if (ofFill) {
                listFill(m_fetched[turn], int(present & chunkCountBits), listing);
                m_warp.meet();
                continue;
            }
            listNodes(m_warp, m_frame.cull != 0, m_fetched[turn], int(present), m_job.column, m_job.row, block, m_s,
                      listing);
        }
    }

private:
    /// Starts the copy of the next chunk. Returns how many nodes it has, 0 after the last.
    SUFFUSE_PROGRAM std::uint32_t fetchNext(int turn)
    {
        while (m_hits == 0) {
            if (m_next >= m_job.to) {
                m_warp.fetch([](int, auto) {});
                return 0;
            }
            m_hits = m_warp.ballot([&](int lane) {
                const std::uint32_t i = m_next + std::uint32_t(lane);
                if (i >= m_job.to)
                    return false;
                const ChunkRecord c = m_frame.chunks[i];
                m_firstNode[lane] = c.firstNode, m_nodes[lane] = c.nodes;
                return c.nodes > 0 && meetsTile(c, m_job.column, m_job.row);
            });
            m_next += warpLanes;
        }
        const int from = Warp::lowest(m_hits);
        m_hits &= m_hits - 1;
        ChunkRecord chunk;
        chunk.firstNode = m_warp.read(m_firstNode, from), chunk.nodes = m_warp.read(m_nodes, from);
        fetchChunk(m_warp, m_frame, chunk, m_fetched[turn], false);
        return chunk.nodes;
    }

    Warp &m_warp;
    const Frame &m_frame;
    const ApartJob m_job;
    Fetched *m_fetched;
    SumScratch &m_s;
    typename Warp::template Var<std::uint32_t> m_firstNode, m_nodes; ///< of the chunks that were looked at last
    std::uint32_t m_next = 0, m_hits = 0;
};

} // namespace suffuse::cuda
