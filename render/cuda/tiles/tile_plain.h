// One warp draws a plain stroke (records.h) at one tile here. Most strokes are plain. Sums and mixing stay in
// registers.
#pragma once

#include "render/cuda/tiles/tile_crisp.h"
#include "render/cuda/tiles/tile_paper.h"
#include "render/cuda/tiles/tile_shade.h"

namespace suffuse::cuda {

/// Hands φ′ = γφ and h² = (½γ|∇φ|)² of a simple stroke to its style, for samples that are `step` pixels wide. `eta` is
/// the paper, or null where it is 1.
template <class Warp>
SUFFUSE_PROGRAM void giveMeans(Warp &warp, const StrokeRecord &stroke,
                               const typename Warp::template Var<SampleSums> &sums, const float *eta, float step,
                               MeanScratch &means)
{
    const auto give = [&](int lane, auto gammaAt) {
        const SampleSums &s = sums[lane];
        SUFFUSE_UNROLL
        for (int k = 0; k < laneSamples; ++k) {
            const int at = sampleAt(lane, k);
            const float gamma = gammaAt(at), width = gamma * (slopeUnit * step);
            const float h2 = math::mulAdd_(s.slopeX[k], s.slopeX[k], s.slopeY[k] * s.slopeY[k]) * (width * width);
            means.density[at] = math::min_(s.density[k], 1e18f) * gamma;
            means.h2[at] = math::min_(h2, 1e36f);
        }
    };
    const float grain = stroke.shade.grain;
    warp.each([&](int lane) {
        if (eta)
            give(lane, [&](int at) { return math::mulAdd_(1 - grain, eta[at], grain); });
        else
            give(lane, [](int) { return 1.0f; });
    });
}

/// Says where samples of a simple stroke's fill lie on its line of colours: at from + step·place.
struct GradientLine {
    float from = 0, step = 0;
    FillPlace place;
};
/// The tile is counted in tiles.
SUFFUSE_PROGRAM GradientLine gradientLine(const Frame &frame, const StrokeRecord &stroke, int column, int row)
{
    GradientLine line;
    const int channel = stroke.shade.lineChannel;
    if (channel < 0)
        return line;
    const FillValues &values = frame.fills[stroke.fillValues];
    line.from = values.from[channel];
    if (stroke.fill & gradientFill) {
        line.step = values.step[channel];
        line.place = {values, (column + 0.5) * tileSide, (row + 0.5) * tileSide};
    }
    return line;
}

/// Makes sums of a fill of density 1, which is entered `base` times left of them, those of a simple stroke's fill,
/// before nodes are added.
template <class Warp>
SUFFUSE_PROGRAM void finishPlainFill(Warp &warp, const StrokeRecord &stroke, const GradientLine &line,
                                     const Block &block, int base, typename Warp::template Var<SampleSums> &sums,
                                     typename Warp::template Var<SampleValues> &values)
{
    const float full = stroke.fillDensity;
    warp.each([&](int lane) {
        SampleSums &s = sums[lane];
        SUFFUSE_UNROLL
        for (int k = 0; k < laneSamples; ++k) {
            const float inside = math::min_(math::max_(s.density[k] + float(base), 0.0f), 1.0f);
            if (line.step != 0)
                values[lane].v[k] = full * inside *
                                    math::mulAdd_(line.step,
                                                  line.place.at(sampleX(lane, k, block), sampleY(lane, k, block),
                                                                inside, s.slopeX[k], s.slopeY[k]),
                                                  line.from);
            else
                values[lane].v[k] = full * inside * line.from;
            s.density[k] = full * inside;
            s.slopeX[k] *= full, s.slopeY[k] *= full;
        }
    });
}

/// If `fills`, the stroke may have a fill.
template <class Warp, bool fills = false>
class PlainStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// The tile is counted in tiles.
    SUFFUSE_PROGRAM PlainStroke(Warp &warp, const Frame &frame, const StrokeRecord &stroke, SumScratch &scratch,
                                int column, int row)
        : m_warp(warp), m_frame(frame), m_stroke(stroke), m_s(scratch), m_column(column), m_row(row)
    {}

    /// Returns how often the stroke's nodes are summed. Density and slopes are summed first, and then, if colours vary
    /// and do not lie on a line, one component after the other.
    SUFFUSE_PROGRAM int passes() const { return m_stroke.shade.colourChannel < 0 ? 1 : 5; }
    /// Returns the component of a pass: 0 red, 1 yellow, 2 blue, 3 opacity, which is summed first.
    static SUFFUSE_PROGRAM int componentOf(int pass) { return (pass + 2) % 4; }

    /// Adds up a pass. `forEachListing(use)` calls use(listing) until all nodes that meet the tile have been listed.
    /// `chosenAgain` says that it lists them anew each time.
    template <class ForEachListing>
    SUFFUSE_PROGRAM void sum(ForEachListing forEachListing, bool chosenAgain, int pass)
    {
        m_warp.each([&](int lane) {
            m_values[lane] = {};
            if (pass == 0)
                m_sums[lane] = {};
        });
        const int channel = pass == 0 ? m_stroke.shade.lineChannel : m_stroke.shade.colourChannel + componentOf(pass);
        if constexpr (fills)
            m_isFillOpen = pass == 0 && m_stroke.fill != 0, m_base = 0;
        forEachListing([&](const Listing &listing) {
            int first = 0;
            if constexpr (fills) {
                first = wholeStrides(listing.fill);
                if (m_isFillOpen) {
                    addFillEntries(m_warp, listing, Block{}, m_s, m_sums);
                    m_base += listing.base;
                    if (listing.separable > first)
                        finishFill();
                }
            }
            SUFFUSE_ROLLED
            for (int from = first; from < listing.separable; from += batch) {
                const int to = from + batch < listing.separable ? from + batch : listing.separable;
                if (pass == 0 || chosenAgain || listing.separable > batch) // Otherwise the tables are still valid.
                    fillTables(m_warp, from, to, Block{}, m_s);
                if (pass == 0)
                    addBatch(m_warp, to - from, m_s, m_sums);
                if (channel >= 0)
                    addChannel(m_warp, from, to - from, m_frame.values + m_stroke.firstValue, m_stroke.channels,
                               std::uint32_t(channel), m_s, m_values);
            }
        });
        if constexpr (fills)
            finishFill();
    }

    /// Does so for a stroke that has a crisp fill and nothing else. What it covers has been summed up (`plainCover`),
    /// but for how often it is entered left of all panels.
    SUFFUSE_PROGRAM void cover(int base)
    {
        const GradientLine line = gradientLine(m_frame, m_stroke, m_column, m_row);
        float *covered = plainCover(m_s).covered;
        const float full = m_stroke.fillDensity;
        m_warp.each([&](int lane) {
            m_sums[lane] = {};
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float x = float(sampleColumn(lane, k)) - 7.5f, y = float(sampleRow(lane, k)) - 7.5f;
                float &share = covered[sampleAt(lane, k)];
                share = coveredShare(share + float(base));
                m_sums[lane].density[k] = share > 0 ? full : 0.0f;
                m_values[lane].v[k] =
                    full *
                    (line.step != 0 ? math::mulAdd_(line.step, line.place.at(x, y, 1, 0, 0), line.from) : line.from);
            }
        });
    }

    /// Finds F at the tile's pixels after the first pass. Returns false if the stroke shows nothing. `eta` is the paper
    /// at the pixels, in the order of `sampleAt`, or null if it is 1 everywhere.
    SUFFUSE_PROGRAM bool style(const float *eta)
    {
        if (m_stroke.channels > 0)
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    m_inverse[lane].v[k] = math::inverseDensity(m_sums[lane].density[k]);
                    m_values[lane].v[k] = math::min_(m_values[lane].v[k] * m_inverse[lane].v[k], 1.0f);
                }
            });
        giveMeans(m_warp, m_stroke, m_sums, eta, 1, m_s.means);
        return meanOfStyle(m_warp, m_stroke, m_s.means);
    }

    /// Calls use(lane, sample, w, red, yellow, blue) for a stroke of one colour or of a line of colours.
    template <class Use>
    SUFFUSE_PROGRAM void forEachSample(Use use)
    {
        const Colour from = m_stroke.shade.colour, end = m_stroke.shade.colourEnd;
        const auto forEach = [&](int lane, auto mean) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float t = m_values[lane].v[k];
                use(lane, k, meanAt(lane, k) * mean(t, from.opacity, end.opacity), mean(t, from.red, end.red),
                    mean(t, from.yellow, end.yellow), mean(t, from.blue, end.blue));
            }
        };
        m_warp.each([&](int lane) {
            if (m_stroke.shade.lineChannel >= 0)
                forEach(lane, [](float t, float a, float b) { return math::mulAdd_(t, b - a, a); });
            else
                forEach(lane, [](float, float a, float) { return a; });
        });
    }

    /// Calls use(lane, sample, w, mean of its component) after a later pass.
    template <class Use>
    SUFFUSE_PROGRAM void forEachSample(int pass, Use use)
    {
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float mean = math::min_(m_values[lane].v[k] * m_inverse[lane].v[k], 1.0f);
                if (pass == 1)
                    m_sums[lane].density[k] = meanAt(lane, k) * mean;
                use(lane, k, m_sums[lane].density[k], mean);
            }
        });
    }

private:
    SUFFUSE_PROGRAM void finishFill()
    {
        if (m_isFillOpen)
            finishPlainFill(m_warp, m_stroke, gradientLine(m_frame, m_stroke, m_column, m_row), Block{}, m_base, m_sums,
                            m_values);
        m_isFillOpen = false;
    }

    /// Returns F at a sample, after `style`.
    SUFFUSE_PROGRAM float meanAt(int lane, int k) const { return m_s.means.density[sampleAt(lane, k)]; }

    Warp &m_warp;
    const Frame &m_frame;
    const StrokeRecord &m_stroke;
    SumScratch &m_s;
    Var<SampleSums> m_sums;      ///< if colours vary, the density becomes w in the end
    Var<SampleValues> m_values;  ///< the pass's channel, which is the place on the line of colours if there is one
    Var<SampleValues> m_inverse; ///< 1/φ
    int m_column, m_row;
    int m_base = 0;            ///< how often the fill is entered left of what is summed
    bool m_isFillOpen = false; ///< whether the sums are those of the fill so far
};

/// Returns where w and colour of samples may lie while nodes are not summed, in the order of `sampleAt`.
SUFFUSE_PROGRAM Float4 *paintedSamples(SumScratch &s)
{
    static_assert(sizeof s.sums.tables >= tileSize * sizeof(Float4));
    return s.sums.tables[0];
}

/// Shades a plain stroke that has a crisp fill, of which `plainCover` has the sum. Returns false if it shows nothing.
/// `eta` is as for PlainStroke::style. It is called, not inlined, since plain strokes without such fills need all
/// registers.
template <class Warp>
SUFFUSE_CALL bool shadeCrisp(Warp warp, const Frame &frame, const StrokeRecord &stroke, int column, int row, int base,
                             const float *eta, SumScratch &s)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(stroke);
    SUFFUSE_IN_SHARED(s);
    PlainStroke<Warp, true> plain(warp, frame, stroke, s, column, row);
    plain.cover(base);
    if (!plain.style(eta))
        return false;
    const float *covered = plainCover(s).covered;
    plain.forEachSample([&](int lane, int k, float w, float red, float yellow, float blue) {
        const int at = sampleAt(lane, k);
        paintedSamples(s)[at] = {w * covered[at], red, yellow, blue};
    });
    return true;
}

} // namespace suffuse::cuda
