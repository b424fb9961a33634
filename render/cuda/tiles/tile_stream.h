// The nodes of one stroke come here in runs, as many as there are near a tile.
#pragma once

#include "render/cuda/tiles/tile_sums.h"

namespace suffuse::cuda {

/// Lists those nodes of a job's stroke that meet a block of samples. While nodes are listed, the next chunk is on its
/// way to shared memory.
template <class Warp>
class NodeStream {
public:
    /// `fetched` has two places.
    SUFFUSE_PROGRAM NodeStream(Warp &warp, const Frame &frame, const ApartJob &job, Fetched *fetched,
                               SumScratch &scratch)
        : m_warp(warp), m_frame(frame), m_job(job), m_fetched(fetched), m_s(scratch)
    {}

    /// Calls use(listing) for runs of listed nodes, in order, until all that meet the block were listed.
    template <class Use>
    SUFFUSE_PROGRAM void forEachListing(const Block &block, Use use)
    {
        m_next = m_job.from, m_hits = 0;
        Listing listing;
        std::uint32_t nodes = fetchNext(0);
        for (int turn = 0;; turn ^= 1) { // Only one place uses a run, since its code is long.
            const std::uint32_t present = nodes;
            if (present)
                nodes = fetchNext(turn ^ 1);
            m_warp.arrive(present != 0);
            if (listing.count + chunkNodes > nodeRoom || (present == 0 && listing.count > 0)) {
                use(listing);
                listing = {};
                m_warp.meet();
            }
            if (present == 0)
                return;
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
