// This program of one warp evaluates one tile: all strokes that meet it, from bottom to top.
#pragma once

#include "render/cuda/tile_general.h"
#include "render/cuda/tile_plain.h"

namespace suffuse::cuda {

/// A warp has this in shared memory while it paints strokes.
struct PaintScratch {
    SumScratch sums;
    Fetched fetched[2]; ///< the present chunk and the next one
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
    float eta[tileSize]; ///< the paper at the tile's pixels, once it is needed
};

/// A warp that paints tiles has this in shared memory.
template <bool general>
struct TileScratch {
    union { // They are used one after the other.
        PaintScratch paint;
        Float4 finished[tileSize]; ///< RYB and coverage
    };
};
template <>
struct TileScratch<true> : TileScratch<false> {
    GeneralScratch general;
};

/// If `general`, this paints anything, otherwise only what TileFlag::plainTile says. A plain stroke shows the same bits
/// either way.
template <bool general, class Warp>
class TilePainter {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM TilePainter(Warp &warp, const Frame &frame, const TileJob &job, TileScratch<general> &scratch)
        : m_warp(warp), m_frame(frame), m_job(job), m_s(scratch)
    {}

    SUFFUSE_PROGRAM void paint(std::uint32_t index)
    {
        begin();
        Found next = findChunk();
        for (int turn = 0;; turn ^= 1) { // Only one place ends strokes, since its code is long.
            const Found found = next;
            if (found.stroke != none)
                next = findChunk();
            m_warp.arrive(found.stroke != none);
            if (found.stroke != m_stroke || found.stroke == none) {
                endStroke();
                if (found.stroke == none)
                    break;
                startStroke(found, m_s.paint.fetched[turn]);
            }
            addChunk(m_s.paint.fetched[turn], int(found.nodes));
        }
        enter(none);
        if (m_job.flags & applyOver)
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k)
                    applySample(over(), pixelOf(lane, k), m_backdrop[lane], k);
            });
        finish(index);
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;

    static SUFFUSE_PROGRAM int pixelOf(int lane, int k)
    {
        return sampleRow(lane, k) * tileSide + sampleColumn(lane, k);
    }
    SUFFUSE_PROGRAM float *over() const { return m_frame.over + std::size_t(m_job.layer) * (overPlanes * tileSize); }
    SUFFUSE_PROGRAM BackdropPixel *under() const { return m_frame.under + std::size_t(m_job.layer) * tileSize; }

    struct Found {
        std::uint32_t chunk = none, stroke = none, nodes = 0;
    };

    /// Finds the next chunk of the half macro-tile's lists that meets the tile, and starts its copy to shared memory.
    SUFFUSE_PROGRAM Found findChunk()
    {
        while (m_hits == 0) {
            if (m_listed >= m_count) {
                m_warp.fetch([](int, auto) {});
                return {};
            }
            const int tile = m_job.row % (macroTiles / 2) * macroTiles + m_job.column % macroTiles;
            std::uint32_t begin[listQuarters] = {};
            SUFFUSE_UNROLL
            for (int quarter = 1; quarter < listQuarters; ++quarter)
                begin[quarter] = m_warp.read(m_ends, quarter - 1);
            m_hits = m_warp.ballot([&](int lane) {
                const std::uint32_t i = m_listed + std::uint32_t(lane);
                if (i >= m_count)
                    return false;
                std::uint32_t at = i;
                SUFFUSE_UNROLL
                for (int quarter = 1; quarter < listQuarters; ++quarter)
                    at = i >= begin[quarter] ? i - begin[quarter] + std::uint32_t(quarter) * m_frame.listRoom : at;
                const ListEntry entry = m_lists[at];
                m_chunk[lane] = entry.chunk, m_firstNode[lane] = entry.firstNode;
                m_strokeAndNodes[lane] = entry.strokeAndNodes;
                return (entry.mask >> tile & 1) != 0 && isWanted(entry.chunk);
            });
            m_listed += warpLanes;
        }
        const int from = Warp::lowest(m_hits);
        m_hits &= m_hits - 1;
        ListEntry entry;
        entry.chunk = m_warp.read(m_chunk, from), entry.firstNode = m_warp.read(m_firstNode, from);
        entry.strokeAndNodes = m_warp.read(m_strokeAndNodes, from);
        const Found found{entry.chunk, strokeIndexOf(entry), nodesOf(entry)};
        ChunkRecord chunk;
        chunk.firstNode = entry.firstNode, chunk.nodes = found.nodes, chunk.stroke = found.stroke;
        m_turn ^= 1;
        fetchChunk(m_warp, m_frame, chunk, m_s.paint.fetched[m_turn]);
        return found;
    }

    SUFFUSE_PROGRAM bool isWanted(std::uint32_t chunk) const
    {
        return !((m_job.flags & haveUnder) && chunk < m_frame.editedFrom) &&
               !((m_job.flags & applyOver) && chunk >= m_frame.editedTo);
    }

    SUFFUSE_PROGRAM void begin()
    {
        const std::size_t first = std::size_t(m_job.macro) * listParts +
                                  (m_job.row % macroTiles < macroTiles / 2 ? 0 : std::size_t(listQuarters));
        m_lists = m_frame.lists + first * m_frame.listRoom;
        m_warp.each([&](int lane) {
            std::uint32_t end = 0;
            SUFFUSE_UNROLL
            for (int quarter = 0; quarter < listQuarters; ++quarter)
                end += quarter <= lane ? m_frame.listCounts[first + std::size_t(quarter)] : 0;
            m_ends[lane] = end;
        });
        m_count = m_warp.read(m_ends, listQuarters - 1);
        m_warp.each([&](int lane) {
            LaneBackdrop &b = m_backdrop[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                if (m_job.flags & haveUnder) {
                    const BackdropPixel p = under()[pixelOf(lane, k)];
                    b.red[k] = p.red, b.yellow[k] = p.yellow, b.blue[k] = p.blue;
                    b.coverage[k] = general ? p.coverage : 0;
                } else {
                    b.red[k] = m_frame.background[0], b.yellow[k] = m_frame.background[1];
                    b.blue[k] = m_frame.background[2], b.coverage[k] = 0;
                }
            }
        });
        m_underStored = !(m_job.flags & storeUnder);
        m_overBegun = !general || !(m_job.flags & storeOver);
    }

    /// This is called before anything of `chunk` is painted, since layers end and begin where the edited stroke does.
    SUFFUSE_PROGRAM void enter(std::uint32_t chunk)
    {
        if (!m_underStored && chunk >= m_frame.editedFrom) {
            m_underStored = true;
            m_warp.each([&](int lane) {
                const LaneBackdrop &b = m_backdrop[lane];
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k)
                    under()[pixelOf(lane, k)] = {b.red[k], b.yellow[k], b.blue[k], general ? b.coverage[k] : 0};
            });
        }
        if (!m_overBegun && chunk >= m_frame.editedTo) {
            m_overBegun = true;
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k)
                    for (int p = 0; p < overPlanes; ++p)
                        over()[p * tileSize + pixelOf(lane, k)] = p == 0 || (p >= 4 && p <= 7) ? 1.0f : 0.0f;
            });
        }
    }
    SUFFUSE_PROGRAM bool composes() const { return general && (m_job.flags & storeOver) && m_overBegun; }

    SUFFUSE_PROGRAM void startStroke(const Found &found, const Fetched &fetched)
    {
        m_warp.meet(); // All lanes have finished with the last stroke's record.
        enter(found.chunk);
        m_stroke = found.stroke;
        m_listing = {};
        m_overflown = false;
        m_warp.each([&](int lane) {
            if (lane < int(sizeof(m_s.paint.stroke) / sizeof(Float4)))
                m_s.paint.stroke[lane] = fetched.stroke[lane];
        });
        if (strokeOf(m_s.paint.stroke).granulated && !m_haveEta)
            findEta(); // This is done while no sums are in registers.
    }
    SUFFUSE_PROGRAM void addChunk(const Fetched &fetched, int nodes)
    {
        if (m_listing.count + chunkNodes > nodeRoom)
            m_overflown = true; // There are too many to keep, so they are chosen again when they are summed.
        if (!m_overflown)
            listNodes(m_warp, m_frame.cull != 0, fetched, nodes, m_job.column, m_job.row, m_s.paint.sums, m_listing);
    }

    SUFFUSE_PROGRAM void endStroke()
    {
        if (m_stroke == none)
            return;
        const StrokeRecord &stroke = strokeOf(m_s.paint.stroke);
        if (stroke.plain)
            paintPlain(stroke);
        else if constexpr (general)
            paintGeneral(stroke);
    }

    /// Calls `use` for runs of listed nodes until all that meet the tile were listed.
    template <class Use>
    SUFFUSE_PROGRAM void forEachListing(const StrokeRecord &stroke, Use use)
    {
        PartialListing part{m_listing, stroke.firstChunk};
        const std::uint32_t end = m_overflown ? part.chunk + stroke.chunks : part.chunk;
        do {
            if (m_overflown)
                part = listChunks(m_warp, m_frame, part.chunk, end, m_job.column, m_job.row, m_s.paint.sums);
            use(part.listing);
        } while (part.chunk < end);
    }

    /// Finds the paper at the tile's pixels.
    SUFFUSE_PROGRAM void findEta()
    {
        m_haveEta = true;
        if (m_frame.paper.kind == 0)
            return;
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k)
                m_s.paint.eta[sampleAt(lane, k)] = etaAt(m_frame, m_job.column * tileSide + sampleColumn(lane, k) + 0.5,
                                                         m_job.row * tileSide + sampleRow(lane, k) + 0.5, 1);
        });
    }

    SUFFUSE_PROGRAM void paintPlain(const StrokeRecord &stroke)
    {
        PlainStroke<Warp> plain(m_warp, m_frame, stroke, m_s.paint.sums);
        const float keep = stroke.keep;
        for (int pass = 0; pass < plain.passes(); ++pass) {
            plain.sum([&](auto use) { forEachListing(stroke, use); }, m_overflown, pass);
            if (pass == 0 && !plain.style(stroke.granulated && m_frame.paper.kind != 0 ? m_s.paint.eta : nullptr))
                return;
            if (pass == 0 && plain.passes() == 1)
                plain.forEachSample([&](int lane, int k, float w, float red, float yellow, float blue) {
                    mixCoverage(lane, k, w, keep);
                    mixColour<0>(lane, k, w, red, keep);
                    mixColour<1>(lane, k, w, yellow, keep);
                    mixColour<2>(lane, k, w, blue, keep);
                });
            else if (pass > 0)
                mixComponent(plain, pass, keep);
        }
    }

    SUFFUSE_PROGRAM void mixComponent(PlainStroke<Warp> &plain, int pass, float keep)
    {
        switch (plain.componentOf(pass)) {
        case 0:
            return plain.forEachSample(
                pass, [&](int lane, int k, float w, float red) { mixColour<0>(lane, k, w, red, keep); });
        case 1:
            return plain.forEachSample(
                pass, [&](int lane, int k, float w, float yellow) { mixColour<1>(lane, k, w, yellow, keep); });
        case 2:
            return plain.forEachSample(
                pass, [&](int lane, int k, float w, float blue) { mixColour<2>(lane, k, w, blue, keep); });
        default:
            return plain.forEachSample(pass, [&](int lane, int k, float w, float) { mixCoverage(lane, k, w, keep); });
        }
    }

    /// Mixes one sample of a stroke into the backdrop and into the over map (22, 23).
    SUFFUSE_PROGRAM void mixCoverage(int lane, int k, float w, float keep)
    {
        if (general) { // Otherwise the picture is not transparent.
            float &coverage = m_backdrop[lane].coverage[k];
            coverage = math::mulAdd_(1 - w, coverage, w);
        }
        if (composes())
            composeCoverage(over(), pixelOf(lane, k), w, keep);
    }
    template <int component> // 0 red, 1 yellow, 2 blue
    SUFFUSE_PROGRAM void mixColour(int lane, int k, float w, float colour, float keep)
    {
        LaneBackdrop &b = m_backdrop[lane];
        float &backdrop = component == 0 ? b.red[k] : component == 1 ? b.yellow[k] : b.blue[k];
        backdrop = math::mixed(backdrop, colour, w, keep);
        if (composes())
            composeColour(over(), pixelOf(lane, k), component, w, colour, keep);
    }

    SUFFUSE_PROGRAM void paintGeneral(const StrokeRecord &stroke)
    {
        GeneralStroke<Warp> evaluator(m_warp, m_frame, m_job, stroke, m_s.paint.sums, m_s.general);
        evaluator.evaluateTile([&](auto use) { forEachListing(stroke, use); });
        const float keep = stroke.keep;
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float w = m_s.general.result[0][sampleAt(lane, k)];
                mixCoverage(lane, k, w, keep);
                mixColour<0>(lane, k, w, m_s.general.result[1][sampleAt(lane, k)], keep);
                mixColour<1>(lane, k, w, m_s.general.result[2][sampleAt(lane, k)], keep);
                mixColour<2>(lane, k, w, m_s.general.result[3][sampleAt(lane, k)], keep);
            }
        });
    }

    SUFFUSE_PROGRAM void finish(std::uint32_t index)
    {
        m_warp.each([&](int lane) {
            const LaneBackdrop &b = m_backdrop[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                m_s.finished[sampleAt(lane, k)] = {b.red[k], b.yellow[k], b.blue[k],
                                                   general && m_frame.transparent ? b.coverage[k] : 1.0f};
            }
        });
        m_warp.each([&](int lane) {
            SUFFUSE_ROLLED
            for (int k = 0; k < laneSamples; ++k)
                store(index, lane, k, finishSample(m_s.finished[sampleAt(lane, k)]));
        });
    }

    SUFFUSE_PROGRAM void store(std::uint32_t index, int lane, int k, const Float4 &rgba) const
    {
        const std::size_t at = std::size_t(index) * tileSize + std::size_t(pixelOf(lane, k));
        if (m_frame.tilesRgba)
            reinterpret_cast<Float4 *>(m_frame.tilesRgba)[at] = rgba;
        if (m_frame.tilesArgb)
            m_frame.tilesArgb[at] = argbOf(rgba);
        const int x = m_job.column * tileSide + sampleColumn(lane, k);
        const int y = m_job.row * tileSide + sampleRow(lane, k);
        if (m_frame.picture && x < m_frame.width && y < m_frame.height)
            m_frame.picture[std::size_t(y) * std::size_t(m_frame.width) + std::size_t(x)] = argbOf(rgba);
    }

    Warp &m_warp;
    const Frame &m_frame;
    const TileJob m_job;
    TileScratch<general> &m_s;
    Var<LaneBackdrop> m_backdrop;
    Var<std::uint32_t> m_chunk, m_firstNode, m_strokeAndNodes; ///< of the list entries that were looked at last
    const ListEntry *m_lists = nullptr;                        ///< those of the tile's half of the macro job
    /// These are the ends of the quarters of these lists, counted through, one in each lane.
    Var<std::uint32_t> m_ends;
    std::uint32_t m_count = 0;
    std::uint32_t m_listed = 0, m_hits = 0;
    std::uint32_t m_stroke = none;
    Listing m_listing;
    int m_turn = 1; ///< the place of `fetched` where the last chunk goes
    bool m_overflown = false;
    bool m_underStored = false, m_overBegun = false, m_haveEta = false;
};

/// Paints one tile job.
template <bool general, class Warp>
SUFFUSE_PROGRAM void paintTile(Warp &warp, const Frame &frame, std::uint32_t job, TileScratch<general> &scratch)
{
    TilePainter<general, Warp>(warp, frame, frame.tiles[job], scratch).paint(job);
}

} // namespace suffuse::cuda
