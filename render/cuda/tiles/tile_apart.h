// Some strokes cost so much at a tile that its warp would be late, as where washes of hundreds of nodes lie over each
// other. The lists' kernel gives each of them a job of its own (tile_lists.h), and a warp evaluates it here, apart from
// the tile's other strokes, into a slot of memory. The warp that paints the tile then mixes what the slot holds, as if
// it had evaluated the stroke itself: sums run over the same nodes in the same order, so no bit depends on who did.
#pragma once

#include "render/cuda/tiles/tile_general.h"
#include "render/cuda/tiles/tile_plain.h"

namespace suffuse::cuda {

/// A warp has this in shared memory while it paints strokes.
struct PaintScratch {
    SumScratch sums;
    Fetched fetched[2]; ///< the present chunk and the next one
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
    float eta[tileSize]; ///< the paper at the tile's pixels, once it is needed
};

SUFFUSE_PROGRAM Float4 *apartSlot(const Frame &frame, std::uint32_t slot)
{
    return reinterpret_cast<Float4 *>(frame.apartSamples) + std::size_t(slot) * tileSize;
}
SUFFUSE_PROGRAM std::uint32_t *apartDone(const Frame &frame, std::uint32_t slot, int part)
{
    return frame.apartDone + std::size_t(slot) * apartParts + part;
}

/// One warp evaluates a plain stroke without a fill, with all that varies along it in one pass, since no picture is in
/// its registers.
template <class Warp>
class ApartPlain {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM ApartPlain(Warp &warp, const Frame &frame, const ApartJob &job, PaintScratch &scratch)
        : m_warp(warp), m_frame(frame), m_job(job), m_s(scratch)
    {}

    /// The stroke's record has been fetched, or is on its way.
    SUFFUSE_PROGRAM void paint()
    {
        sum();
        const StrokeRecord &stroke = strokeOf(m_s.stroke);
        const bool paper = stroke.granulated && m_frame.paper.kind != 0;
        if (paper)
            findEta(m_warp, m_frame, m_job.column, m_job.row, Block{}, 0, m_s.eta);
        giveMeans(m_warp, stroke, m_sums, paper ? m_s.eta : nullptr, m_s.sums.means);
        const bool shows = meanOfStyle(m_warp, stroke, m_s.sums.means);
        if (shows)
            store(stroke);
        m_warp.publish(apartDone(m_frame, m_job.slot, 0), 2 * m_frame.apartStamp + shows);
    }

private:
    SUFFUSE_PROGRAM void sum()
    {
        m_warp.each([&](int lane) {
            m_sums[lane] = {};
            SUFFUSE_UNROLL
            for (int c = 0; c < 4; ++c)
                m_values[c][lane] = {};
        });
        NodeStream<Warp> nodes(m_warp, m_frame, m_job, m_s.fetched, m_s.sums);
        nodes.forEachListing(Block{}, [&](const Listing &listing) {
            const StrokeRecord &stroke = strokeOf(m_s.stroke); // It has arrived with the first nodes.
            const int colour = stroke.shade.colourChannel, line = stroke.shade.lineChannel;
            const float *values = m_frame.values + stroke.firstValue;
            SUFFUSE_ROLLED
            for (int from = 0; from < listing.separable; from += batch) {
                const int to = from + batch < listing.separable ? from + batch : listing.separable;
                fillTables(m_warp, from, to, Block{}, m_s.sums);
                if (colour >= 0) {
                    addColours(from, to - from, values + colour, stroke.channels);
                    continue;
                }
                addBatch(m_warp, to - from, m_s.sums, m_sums);
                if (line >= 0)
                    addChannel(m_warp, from, to - from, values, stroke.channels, std::uint32_t(line), m_s.sums,
                               m_values[0]);
            }
        });
    }

    /// Adds up a batch of nodes with the four sums of their colours, as addBatch and addChannel do.
    SUFFUSE_PROGRAM void addColours(int from, int nodes, const float *values, std::uint32_t channels)
    {
        Float4 *colours = m_s.sums.sums.channel[0]; // one for each node
        m_warp.each([&](int lane) {
            if (lane >= wholeStrides(nodes))
                return;
            const float *v = values + std::size_t(m_s.sums.rows[from + lane]) * channels;
            colours[lane] = {v[0], v[1], v[2], v[3]};
        });
        m_warp.each([&](int lane) {
            SampleSums &sum = m_sums[lane];
            SUFFUSE_ROLLED
            for (int first = 0; first < nodes; first += stride) {
                SUFFUSE_UNROLL_BY_2
                for (int n = first; n < first + stride; ++n) {
                    const Float4 columns = m_s.sums.sums.tables[n][lane % 8], colour = colours[n];
                    const Float4 *rows = &m_s.sums.sums.tables[n][8 + lane / 8 * 2];
                    const Float4 low = rows[0], high = rows[1];
                    const float value[4] = {low.x, low.z, high.x, high.z}, slope[4] = {low.y, low.w, high.y, high.w};
                    const float part[4] = {colour.x, colour.y, colour.z, colour.w};
                    SUFFUSE_UNROLL
                    for (int k = 0; k < laneSamples; ++k) {
                        const float x = k % 2 ? columns.z : columns.x, xSlope = k % 2 ? columns.w : columns.y;
                        sum.density[k] = math::mulAdd_(x, value[k / 2], sum.density[k]);
                        sum.slopeX[k] = math::mulAdd_(xSlope, value[k / 2], sum.slopeX[k]);
                        sum.slopeY[k] = math::mulAdd_(x, slope[k / 2], sum.slopeY[k]);
                        SUFFUSE_UNROLL
                        for (int c = 0; c < 4; ++c)
                            m_values[c][lane].v[k] = math::mulAdd_(x, value[k / 2] * part[c], m_values[c][lane].v[k]);
                    }
                }
            }
        });
    }

    /// Stores w and colour of all samples.
    SUFFUSE_PROGRAM void store(const StrokeRecord &stroke)
    {
        const Colour from = stroke.shade.colour, end = stroke.shade.colourEnd;
        const bool varies = stroke.shade.colourChannel >= 0, line = stroke.shade.lineChannel >= 0;
        Float4 *slot = apartSlot(m_frame, m_job.slot);
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k);
                const float inverse = stroke.channels > 0 ? math::inverseDensity(m_sums[lane].density[k]) : 0.0f;
                const auto channel = [&](int c) { return math::min_(m_values[c][lane].v[k] * inverse, 1.0f); };
                const float t = channel(0);
                const auto mean = [&](int c, float a, float b) {
                    return varies ? channel(c) : line ? math::mulAdd_(t, b - a, a) : a;
                };
                slot[at] = {m_s.sums.means.density[at] * mean(3, from.opacity, end.opacity), mean(0, from.red, end.red),
                            mean(1, from.yellow, end.yellow), mean(2, from.blue, end.blue)};
            }
        });
    }

    Warp &m_warp;
    const Frame &m_frame;
    const ApartJob m_job;
    PaintScratch &m_s;
    Var<SampleSums> m_sums;
    Var<SampleValues> m_values[4];
};

/// Evaluates a stroke of any kind at a tile, or a part of it, and leaves it in the scratch's `result`. Its code is
/// long, so it is called, not inlined.
template <bool fills, class Warp>
SUFFUSE_CALL void evaluateGeneral(Warp warp, const Frame &frame, const ApartJob job, int part, PaintScratch &paint,
                                  const StrokeRecord &stroke, GeneralScratch &general)
{
    GeneralStroke<Warp, fills>(warp, frame, job, stroke, paint.fetched, paint.sums, general).evaluateTile(part);
}

/// Does a part of a job of a general stroke.
template <bool fills, class Warp>
SUFFUSE_PROGRAM void paintApartPart(Warp &warp, const Frame &frame, const ApartJob &job, int part, PaintScratch &paint,
                                    GeneralScratch &general)
{
    warp.meet();
    warp.fetch([&](int lane, auto start) { fetchStroke(frame, job.stroke, lane, start, paint.stroke); });
    warp.arrive(false);
    const StrokeRecord &stroke = strokeOf(paint.stroke);
    if (part > 0 && !isSupersampled(stroke))
        return;
    evaluateGeneral<fills>(warp, frame, job, part, paint, stroke, general);
    Float4 *slot = apartSlot(frame, job.slot);
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int k = 0; k < laneSamples; ++k) {
            const int at = sampleAt(lane, k);
            if (partOf(stroke, general.level[at], lane, k) == part)
                slot[at] = {general.result[0][at], general.result[1][at], general.result[2][at], general.result[3][at]};
        }
    });
    warp.publish(apartDone(frame, job.slot, part), 2 * frame.apartStamp + 1);
}

/// Evaluates a plain stroke that has a fill. Its colours lie on a line, so that it is summed once.
template <class Warp>
SUFFUSE_PROGRAM void paintApartFill(Warp &warp, const Frame &frame, const ApartJob &job, PaintScratch &scratch)
{
    const StrokeRecord &stroke = strokeOf(scratch.stroke);
    const FillValues &fill = frame.fills[stroke.fillValues];
    const float *eta = nullptr;
    if (stroke.granulated && frame.paper.kind != 0) { // This is done while no sums are in registers.
        findEta(warp, frame, job.column, job.row, Block{}, 0, scratch.eta);
        eta = scratch.eta;
    }
    NodeStream<Warp, true> nodes(warp, frame, job, scratch.fetched, scratch.sums);
    Float4 *slot = apartSlot(frame, job.slot);
    bool shows = false;
    if (stroke.fill & crispFill) {
        int base = 0;
        clearCover(warp, plainCover(scratch.sums));
        nodes.forEachListing(
            Block{}, [](const Listing &) {},
            [&](const Fetched &chunk, int records, Listing &) {
                base += addCover(warp, plainCover(scratch.sums), chunk, records, fill, job.column, job.row, Block{});
            });
        shows = shadeCrisp(warp, frame, stroke, job.column, job.row, base, eta, scratch.sums);
        if (shows)
            warp.each([&](int lane) {
                for (int k = 0; k < laneSamples; ++k)
                    slot[sampleAt(lane, k)] = crispSamples(scratch.sums)[sampleAt(lane, k)];
            });
    } else {
        PlainStroke<Warp, true> plain(warp, frame, stroke, scratch.sums, job.column, job.row);
        const auto list = [&](const Fetched &chunk, int records, Listing &listing) {
            listFill(warp, chunk, records, fill, job.column, job.row, Block{}, scratch.sums, listing);
        };
        plain.sum([&](auto use) { nodes.forEachListing(Block{}, use, list); }, true, 0);
        shows = plain.style(eta);
        if (shows)
            plain.forEachSample([&](int lane, int k, float w, float red, float yellow, float blue) {
                slot[sampleAt(lane, k)] = {w, red, yellow, blue};
            });
    }
    warp.publish(apartDone(frame, job.slot, 0), 2 * frame.apartStamp + shows);
}

/// Does a plain job. It is called, not inlined, since painting tiles needs all registers.
template <bool fills, class Warp>
SUFFUSE_CALL void paintApartPlain(Warp warp, const Frame &frame, const ApartJob job, PaintScratch &scratch)
{
    warp.meet();
    warp.fetch([&](int lane, auto start) { fetchStroke(frame, job.stroke, lane, start, scratch.stroke); });
    if constexpr (fills) {
        warp.arrive(false);
        if (strokeOf(scratch.stroke).fill)
            return paintApartFill(warp, frame, job, scratch);
    }
    ApartPlain<Warp>(warp, frame, job, scratch).paint();
}

/// Takes jobs and does them, until none is left. All jobs have been taken when a warp goes on to tiles, so that no warp
/// waits for one that waits itself.
template <bool general, bool fills, class Warp, class Scratch>
SUFFUSE_PROGRAM void paintApart(Warp &warp, const Frame &frame, Scratch &scratch)
{
    const std::uint32_t *counts = frame.status + firstApartCount + (general ? costlyGeneral : costlyPlain);
    const std::uint32_t costly = counts[0], jobs = costly + counts[1];
    if (jobs == 0)
        return;
    const std::uint32_t parts = general ? generalParts : 1;
    std::uint32_t *next = frame.status + (general ? nextGeneralApart : nextPlainApart);
    for (std::uint32_t place; (place = warp.take(next)) < jobs * parts;) {
        const std::uint32_t i = place / parts, kind = (general ? costlyGeneral : costlyPlain) + (i >= costly);
        const ApartJob job = frame.apartJobs[std::size_t(kind) * frame.apartRoom + (i >= costly ? i - costly : i)];
        if constexpr (general)
            paintApartPart<fills>(warp, frame, job, int(place % parts), scratch.paint, scratch.general);
        else
            paintApartPlain<fills>(warp, frame, job, scratch.paint);
    }
}

} // namespace suffuse::cuda
