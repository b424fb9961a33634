// This program of one warp evaluates one tile: all strokes that meet it, from bottom to top.
#pragma once

#include "render/cuda/tiles/tile_apart.h"
#include "render/cuda/tiles/tile_composition.h"

namespace suffuse::cuda {

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

/// If `general`, this paints anything, otherwise only what TileFlag::plainTile says. If `apart`, strokes may have been
/// evaluated apart, and if `fills`, plain strokes may have fills. If `layered`, strokes may lie in layers of the
/// painting. A plain stroke shows the same bits in any case.
template <bool general, bool apart, bool fills, bool layered, class Warp>
class TilePainter {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `index` is that of the job.
    SUFFUSE_PROGRAM TilePainter(Warp &warp, const Frame &frame, std::uint32_t index, TileScratch<general> &scratch)
        : m_warp(warp), m_frame(frame), m_job(frame.tiles[index]), m_s(scratch), m_composition(warp, frame, index)
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
                if (general && m_streams && m_stroke != none &&
                    !m_isApart) { // Its nodes have come to where these chunks were.
                    fetchAgain(found, turn);
                    fetchAgain(next, turn ^ 1);
                    m_warp.arrive(next.stroke != none);
                }
                startStroke(found, m_s.paint.fetched[turn]);
                if constexpr (apart)
                    if (m_isApart)
                        mixApart(found, strokeOf(m_s.paint.stroke));
            }
            addChunk(m_s.paint.fetched[turn], int(found.nodes));
        }
        enter(none);
        if constexpr (layered)
            m_composition.goToEnd(m_backdrop);
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
    static constexpr bool covers = general || layered; ///< whether coverage is followed

    static SUFFUSE_PROGRAM int pixelOf(int lane, int k)
    {
        return sampleRow(lane, k) * tileSide + sampleColumn(lane, k);
    }
    SUFFUSE_PROGRAM float *over() const { return m_frame.over + std::size_t(m_job.layer) * (overPlanes * tileSize); }
    SUFFUSE_PROGRAM BackdropPixel *under() const { return m_frame.under + std::size_t(m_job.layer) * tileSize; }

    struct Found {
        std::uint32_t chunk = none, stroke = none;
        std::uint32_t nodes = 0;     ///< or apartNodes, if the stroke is evaluated apart
        std::uint32_t firstNode = 0; ///< or the slot
    };
    static constexpr std::uint32_t apartNodes = 127; ///< No chunk has so many, with fillChunk or without.

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
                if (apart && m_anyApart) {
                    const ApartEntry slots = m_frame.apart[m_lists - m_frame.lists + std::ptrdiff_t(at)];
                    if (slots.mask >> tile & 1) {
                        m_firstNode[lane] = slots.slot + std::uint32_t(Warp::rank(slots.mask, tile));
                        m_strokeAndNodes[lane] |= apartNodes;
                    }
                }
                return (entry.mask >> tile & 1) != 0 && isWanted(entry.chunk);
            });
            m_listed += warpLanes;
        }
        const int from = Warp::lowest(m_hits);
        m_hits &= m_hits - 1;
        ListEntry entry;
        entry.chunk = m_warp.read(m_chunk, from), entry.firstNode = m_warp.read(m_firstNode, from);
        entry.strokeAndNodes = m_warp.read(m_strokeAndNodes, from);
        const Found found{entry.chunk, strokeIndexOf(entry), nodesOf(entry), entry.firstNode};
        if (apart && found.nodes == apartNodes) // One entry of the stroke is enough.
            m_hits &= ~m_warp.ballot([&](int lane) { return m_strokeAndNodes[lane] == entry.strokeAndNodes; });
        m_turn ^= 1;
        fetch(found, m_turn);
        return found;
    }

    /// Starts the copy of a chunk, or only of its stroke if that is evaluated apart.
    SUFFUSE_PROGRAM void fetch(const Found &found, int turn)
    {
        ChunkRecord chunk;
        chunk.firstNode = found.firstNode, chunk.stroke = found.stroke;
        chunk.nodes = apart && found.nodes == apartNodes ? 0 : found.nodes;
        fetchChunk(m_warp, m_frame, chunk, m_s.paint.fetched[turn]);
    }
    SUFFUSE_PROGRAM void fetchAgain(const Found &found, int turn)
    {
        if (found.stroke == none)
            m_warp.fetch([](int, auto) {});
        else
            fetch(found, turn);
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
                end += quarter <= lane ? m_frame.listCounts[first + std::size_t(quarter)] & ~anyApart : 0;
            m_ends[lane] = end;
        });
        m_anyApart = apart && m_warp.any([&](int lane) {
            return lane < listQuarters && (m_frame.listCounts[first + std::size_t(lane)] & anyApart) != 0;
        });
        m_count = m_warp.read(m_ends, listQuarters - 1);
        m_warp.each([&](int lane) {
            LaneBackdrop &b = m_backdrop[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                if (m_job.flags & haveUnder) {
                    const BackdropPixel p = under()[pixelOf(lane, k)];
                    b.red[k] = p.red, b.yellow[k] = p.yellow, b.blue[k] = p.blue;
                    b.coverage[k] = covers ? p.coverage : 0;
                } else {
                    b.red[k] = m_frame.background[0], b.yellow[k] = m_frame.background[1];
                    b.blue[k] = m_frame.background[2], b.coverage[k] = 0;
                }
            }
        });
        if constexpr (layered)
            m_composition.begin();
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
                    under()[pixelOf(lane, k)] = {b.red[k], b.yellow[k], b.blue[k], covers ? b.coverage[k] : 0};
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
        if constexpr (layered)
            m_composition.goTo(found.stroke, found.chunk, m_backdrop);
        m_stroke = found.stroke;
        m_isApart = apart && found.nodes == apartNodes;
        m_firstChunk = found.chunk;
        m_listing = {};
        m_overflown = false;
        m_warp.each([&](int lane) {
            if (lane < int(sizeof(m_s.paint.stroke) / sizeof(Float4)))
                m_s.paint.stroke[lane] = fetched.stroke[lane];
        });
        const StrokeRecord &stroke = strokeOf(m_s.paint.stroke);
        m_streams = general && !stroke.plain;
        if (fills && (stroke.fill & crispFill) && stroke.plain)
            clearCover(m_warp, plainCover(m_s.paint.sums));
        if (stroke.granulated && !m_haveEta && !(apart && m_isApart) && !(general && m_streams)) {
            m_haveEta = true; // This is done while no sums are in registers.
            if (m_frame.paper.kind != 0)
                findEta(m_warp, m_frame, m_job.column, m_job.row, Block{}, 0, m_s.paint.eta);
        }
    }
    SUFFUSE_PROGRAM void addChunk(const Fetched &fetched, int nodes)
    {
        if ((apart && m_isApart) || (general && m_streams))
            return; // Another warp lists the nodes, or this one does so when it evaluates the stroke.
        if constexpr (fills) {
            if (std::uint32_t(nodes) & fillChunk) {
                const StrokeRecord &stroke = strokeOf(m_s.paint.stroke);
                const FillValues &fill = m_frame.fills[stroke.fillValues];
                if (stroke.fill & crispFill) {
                    m_listing.base +=
                        addCover(m_warp, plainCover(m_s.paint.sums), fetched,
                                 int(std::uint32_t(nodes) & chunkCountBits), fill, m_job.column, m_job.row, Block{});
                    return;
                }
                if (!m_overflown && !listFill(m_warp, fetched, int(std::uint32_t(nodes) & chunkCountBits), fill,
                                              m_job.column, m_job.row, Block{}, m_s.paint.sums, m_listing))
                    m_overflown = true;
                return;
            }
            endFill(m_listing);
        }
        if (m_listing.count + chunkNodes > nodeRoom)
            m_overflown = true; // There are too many to keep, so they are chosen again when they are summed.
        if (!m_overflown)
            listNodes(m_warp, m_frame.cull != 0, fetched, nodes, m_job.column, m_job.row, Block{}, m_s.paint.sums,
                      m_listing);
    }

    SUFFUSE_PROGRAM void endStroke()
    {
        if (m_stroke == none || (apart && m_isApart))
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
                part = listChunks<fills>(m_warp, m_frame, stroke, part.chunk, end, m_job.column, m_job.row,
                                         m_s.paint.sums);
            use(part.listing);
        } while (part.chunk < end);
    }

    /// Mixes a stroke that another warp has evaluated, or is about to.
    SUFFUSE_PROGRAM void mixApart(const Found &found, const StrokeRecord &stroke)
    {
        const int parts = general && !stroke.plain && isSupersampled(stroke) ? generalParts : 1;
        const std::uint32_t done = 2 * m_frame.apartStamp;
        const bool shows = m_warp.any([&](int lane) {
            return lane < parts && Warp::await(apartDone(m_frame, found.firstNode, lane),
                                               [&](std::uint32_t word) { return word >> 1 == done >> 1; }) != done;
        });
        if (!shows)
            return;
        const Float4 *slot = apartSlot(m_frame, found.firstNode);
        mixSamples(stroke.keep, [&](int at) { return Warp::readPublished(slot + at); });
    }

    /// Mixes samples of w and colour. `read(at)` gives that at a place of `sampleAt`.
    template <class Read>
    SUFFUSE_PROGRAM void mixSamples(float keep, Read read)
    {
        m_warp.each([&](int lane) {
            Float4 samples[laneSamples]; // All loads are started at once.
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k)
                samples[k] = read(sampleAt(lane, k));
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k)
                mixSample(lane, k, samples[k], keep);
        });
        if (composes())
            composeSamples(keep, [&](int lane, int k) { return read(sampleAt(lane, k)); });
    }
    /// Puts samples of w and colour into the over map.
    template <class Read>
    SUFFUSE_PROGRAM void composeSamples(float keep, Read read)
    {
        m_warp.each([&](int lane) {
            SUFFUSE_ROLLED
            for (int k = 0; k < laneSamples; ++k)
                composeSample(over(), pixelOf(lane, k), read(lane, k), keep);
        });
    }

    SUFFUSE_PROGRAM void mixSample(int lane, int k, const Float4 &sample, float keep)
    {
        mixCoverage(lane, k, sample.x);
        mixColour<0>(lane, k, sample.x, sample.y, keep);
        mixColour<1>(lane, k, sample.x, sample.z, keep);
        mixColour<2>(lane, k, sample.x, sample.w, keep);
    }

    SUFFUSE_PROGRAM void paintPlain(const StrokeRecord &stroke)
    {
        const float *eta = stroke.granulated && m_frame.paper.kind != 0 ? m_s.paint.eta : nullptr;
        if (fills && (stroke.fill & crispFill)) {
            if (shadeCrisp(m_warp, m_frame, stroke, m_job.column, m_job.row, m_listing.base, eta, m_s.paint.sums))
                mixSamples(stroke.keep, [&](int at) { return paintedSamples(m_s.paint.sums)[at]; });
            return;
        }
        PlainStroke<Warp, fills> plain(m_warp, m_frame, stroke, m_s.paint.sums, m_job.column, m_job.row);
        const float keep = stroke.keep;
        for (int pass = 0; pass < plain.passes(); ++pass) {
            plain.sum([&](auto use) { forEachListing(stroke, use); }, m_overflown, pass);
            if (pass == 0 && !plain.style(eta))
                return;
            if (pass == 0 && plain.passes() == 1) {
                plain.forEachSample([&](int lane, int k, float w, float red, float yellow, float blue) {
                    mixSample(lane, k, {w, red, yellow, blue}, keep);
                });
                if (composes())
                    plain.forEachSample([&](int lane, int k, float w, float red, float yellow, float blue) {
                        composeSample(over(), pixelOf(lane, k), {w, red, yellow, blue}, keep);
                    });
            } else if (pass > 0) {
                mixComponent(plain, pass, keep);
                if (composes())
                    plain.forEachSample(pass, [&](int lane, int k, float w, float mean) {
                        composeComponent(over(), pixelOf(lane, k), plain.componentOf(pass), w, mean, keep);
                    });
            }
        }
    }

    SUFFUSE_PROGRAM void mixComponent(PlainStroke<Warp, fills> &plain, int pass, float keep)
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
            return plain.forEachSample(pass, [&](int lane, int k, float w, float) { mixCoverage(lane, k, w); });
        }
    }

    /// Mixes one sample of a stroke into the backdrop (22, 23).
    SUFFUSE_PROGRAM void mixCoverage(int lane, int k, float w)
    {
        if (covers) { // Otherwise the picture is not transparent.
            float &coverage = m_backdrop[lane].coverage[k];
            coverage = math::mulAdd_(1 - w, coverage, w);
            if (layered && m_frame.shapeOf)
                m_composition.addPart(lane, k, m_stroke, w);
        }
    }
    template <int component> // 0 red, 1 yellow, 2 blue
    SUFFUSE_PROGRAM void mixColour(int lane, int k, float w, float colour, float keep)
    {
        LaneBackdrop &b = m_backdrop[lane];
        float &backdrop = component == 0 ? b.red[k] : component == 1 ? b.yellow[k] : b.blue[k];
        backdrop = math::mixed(backdrop, colour, w, keep);
    }

    SUFFUSE_PROGRAM void paintGeneral(const StrokeRecord &stroke)
    {
        const ApartJob whole{m_job.column, m_job.row, m_stroke, m_firstChunk, stroke.firstChunk + stroke.chunks, 0};
        m_warp.arrive(false); // Nothing may still come to where its nodes will.
        m_haveEta = false;    // That of its samples will lie there.
        int parts = 1;
        SUFFUSE_ROLLED
        for (int part = 0; part < parts; ++part) {
            const bool some = evaluateGeneral<fills>(
                m_warp, m_frame, whole, part, part == 0 ? Levels::FindAll : Levels::Known, m_s.paint, m_s.general);
            if (part == 0 && some)
                parts = generalParts;
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    if (partOf(stroke, m_s.general.level[sampleAt(lane, k)], lane, k) != part)
                        continue;
                    mixSample(lane, k, partSample(m_s.paint, m_s.general, part, lane, k), stroke.keep);
                }
            });
            if (composes())
                composeSamples(stroke.keep, [&](int lane, int k) {
                    return partOf(stroke, m_s.general.level[sampleAt(lane, k)], lane, k) == part
                               ? partSample(m_s.paint, m_s.general, part, lane, k)
                               : Float4{0, 0, 0, 0};
                });
        }
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
    TileComposition<Warp> m_composition;
    Var<LaneBackdrop> m_backdrop;
    Var<std::uint32_t> m_chunk, m_firstNode, m_strokeAndNodes; ///< of the list entries that were looked at last
    const ListEntry *m_lists = nullptr;                        ///< those of the tile's half of the macro job
    /// These are the ends of the quarters of these lists, counted through, one in each lane.
    Var<std::uint32_t> m_ends;
    std::uint32_t m_count = 0;
    std::uint32_t m_listed = 0, m_hits = 0;
    std::uint32_t m_stroke = none;
    Listing m_listing;
    int m_turn = 1;                 ///< the place of `fetched` where the last chunk goes
    std::uint32_t m_firstChunk = 0; ///< the stroke's first chunk that meets the tile
    bool m_overflown = false;
    bool m_anyApart = false; ///< whether some strokes of the lists are evaluated apart from some tiles
    bool m_isApart = false;  ///< whether the present stroke is, from this one
    bool m_streams = false;  ///< whether its nodes are listed when it is evaluated
    bool m_underStored = false, m_overBegun = false, m_haveEta = false;
};

/// Paints one tile job.
template <bool general, bool apart, bool fills, bool layered, class Warp>
SUFFUSE_PROGRAM void paintTile(Warp &warp, const Frame &frame, std::uint32_t job, TileScratch<general> &scratch)
{
    TilePainter<general, apart, fills, layered, Warp>(warp, frame, job, scratch).paint(job);
}

} // namespace suffuse::cuda
