// One warp evaluates a simple stroke here (records.h) at a block of samples: a stroke that is plain, or would be if its
// pixels were not supersampled. No picture is in its registers, so all that varies along it is summed in one pass.
#pragma once

#include "render/cuda/tiles/tile_plain.h"
#include "render/cuda/tiles/tile_stream.h"

namespace suffuse::cuda {

/// If `fills`, the stroke may have a fill.
template <class Warp, bool fills = false>
class BlockStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `stroke` may be on its way yet; it arrives with the first nodes. `fetched` has two places.
    SUFFUSE_PROGRAM BlockStroke(Warp &warp, const Frame &frame, const ApartJob &job, const StrokeRecord &stroke,
                                Fetched *fetched, SumScratch &sums)
        : m_warp(warp), m_frame(frame), m_job(job), m_stroke(stroke), m_fetched(fetched), m_s(sums)
    {}

    /// Finds w and colour at a block of samples. Returns false if the stroke shows nothing there. `plane` is that of
    /// the block's η (`etaPlane`), for which `eta` has room.
    SUFFUSE_PROGRAM bool evaluate(const Block &block, int plane, float *eta)
    {
        sum(block);
        const bool paper = m_stroke.granulated && m_frame.paper.kind != 0;
        if (paper)
            findEta(m_warp, m_frame, m_job.column, m_job.row, block, plane, eta);
        giveMeans(m_warp, m_stroke, m_sums, paper ? eta : nullptr, block.step, m_s.means);
        return meanOfStyle(m_warp, m_stroke, m_s.means);
    }

    /// Stores w and colour of all samples, in the order of `sampleAt`, after `evaluate`.
    SUFFUSE_PROGRAM void store(Float4 *to)
    {
        const Colour from = m_stroke.shade.colour, end = m_stroke.shade.colourEnd;
        const bool varies = m_stroke.shade.colourChannel >= 0, line = m_stroke.shade.lineChannel >= 0;
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k);
                const float inverse = m_stroke.channels > 0 ? math::inverseDensity(m_sums[lane].density[k]) : 0.0f;
                const auto channel = [&](int c) { return math::min_(m_values[c][lane].v[k] * inverse, 1.0f); };
                const float t = channel(0);
                const auto mean = [&](int c, float a, float b) {
                    return varies ? channel(c) : line ? math::mulAdd_(t, b - a, a) : a;
                };
                to[at] = {m_s.means.density[at] * mean(3, from.opacity, end.opacity), mean(0, from.red, end.red),
                          mean(1, from.yellow, end.yellow), mean(2, from.blue, end.blue)};
            }
        });
    }

private:
    SUFFUSE_PROGRAM void sum(const Block &block)
    {
        m_warp.each([&](int lane) {
            m_sums[lane] = {};
            SUFFUSE_UNROLL
            for (int c = 0; c < 4; ++c)
                m_values[c][lane] = {};
        });
        m_base = 0, m_isFillOpen = false;
        NodeStream<Warp, fills> nodes(m_warp, m_frame, m_job, m_fetched, m_s);
        if constexpr (fills) {
            m_isFillOpen = m_stroke.fill != 0;
            nodes.forEachListing(
                block, [&](const Listing &listing) { addListing(listing, block); },
                [&](const Fetched &chunk, int records, Listing &listing) {
                    listFill(m_warp, chunk, records, m_frame.fills[m_stroke.fillValues], m_job.column, m_job.row, block,
                             m_s, listing);
                });
            finishFill(block);
        } else {
            nodes.forEachListing(block, [&](const Listing &listing) { addListing(listing, block); });
        }
    }

    SUFFUSE_PROGRAM void addListing(const Listing &listing, const Block &block)
    {
        const int colour = m_stroke.shade.colourChannel, line = m_stroke.shade.lineChannel;
        const float *values = m_frame.values + m_stroke.firstValue;
        int first = 0;
        if constexpr (fills) {
            first = wholeStrides(listing.fill);
            if (m_isFillOpen) {
                addFillEntries(m_warp, listing, block, m_s, m_sums);
                m_base += listing.base;
                if (listing.separable > first)
                    finishFill(block);
            }
        }
        SUFFUSE_ROLLED
        for (int from = first; from < listing.separable; from += batch) {
            const int to = from + batch < listing.separable ? from + batch : listing.separable;
            fillTables(m_warp, from, to, block, m_s);
            if (colour >= 0) {
                addColours(from, to - from, values + colour, m_stroke.channels);
                continue;
            }
            addBatch(m_warp, to - from, m_s, m_sums);
            if (line >= 0)
                addChannel(m_warp, from, to - from, values, m_stroke.channels, std::uint32_t(line), m_s, m_values[0]);
        }
    }

    SUFFUSE_PROGRAM void finishFill(const Block &block)
    {
        if (m_isFillOpen)
            finishPlainFill(m_warp, m_stroke, gradientLine(m_frame, m_stroke, m_job.column, m_job.row), block, m_base,
                            m_sums, m_values[0]);
        m_isFillOpen = false;
    }

    /// Adds up a batch of nodes with the four sums of their colours, as addBatch and addChannel do.
    SUFFUSE_PROGRAM void addColours(int from, int nodes, const float *values, std::uint32_t channels)
    {
        Float4 *colours = m_s.sums.channel[0]; // one for each node
        m_warp.each([&](int lane) {
            if (lane >= wholeStrides(nodes))
                return;
            const float *v = values + std::size_t(m_s.rows[from + lane]) * channels;
            colours[lane] = {v[0], v[1], v[2], v[3]};
        });
        m_warp.each([&](int lane) {
            SampleSums &sum = m_sums[lane];
            SUFFUSE_ROLLED
            for (int first = 0; first < nodes; first += stride) {
                SUFFUSE_UNROLL_BY_2
                for (int n = first; n < first + stride; ++n) {
                    const Float4 columns = m_s.sums.tables[n][lane % 8], colour = colours[n];
                    const Float4 *rows = &m_s.sums.tables[n][8 + lane / 8 * 2];
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

    Warp &m_warp;
    const Frame &m_frame;
    const ApartJob &m_job;
    const StrokeRecord &m_stroke;
    Fetched *m_fetched;
    SumScratch &m_s;
    Var<SampleSums> m_sums;
    Var<SampleValues> m_values[4]; ///< the four colours, or in the first the place on the line of colours
    int m_base = 0;                ///< how often the fill is entered left of what is summed
    bool m_isFillOpen = false;     ///< whether the sums are those of the fill so far
};

/// Leaves w and colour of a simple stroke at a block of samples in `paintedSamples`. It is called, not inlined, since
/// its code is long.
template <bool fills, class Warp>
SUFFUSE_CALL void evaluateSimple(Warp warp, const Frame &frame, const ApartJob job, const Block block, int plane,
                                 PaintScratch &paint)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(paint);
    BlockStroke<Warp, fills> stroke(warp, frame, job, strokeOf(paint.stroke), paint.fetched, paint.sums);
    Float4 *samples = paintedSamples(paint.sums);
    if (stroke.evaluate(block, plane, paint.eta))
        return stroke.store(samples);
    warp.each([&](int lane) {
        SUFFUSE_UNROLL
        for (int k = 0; k < laneSamples; ++k)
            samples[sampleAt(lane, k)] = {0, 0, 0, 0};
    });
}

} // namespace suffuse::cuda
