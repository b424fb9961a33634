// A plain stroke (records.h) at one tile, by one warp: what most strokes are, with sums and mixing in registers.
#pragma once

#include "render/cuda/tile_paper.h"
#include "render/cuda/tile_shade.h"

namespace suffuse::cuda {

template <class Warp>
class PlainStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM PlainStroke(Warp &warp, const Frame &frame, const StrokeRecord &stroke, SumScratch &scratch)
        : m_warp(warp), m_frame(frame), m_stroke(stroke), m_s(scratch)
    {}

    /// Finds F at the tile's pixels; false: the stroke shows nothing. `forEachListing(use)` calls use(listing) until
    /// all nodes that meet the tile were listed. `eta`: paper at the pixels, as `sampleAt` says; null for 1.
    template <class ForEachListing>
    SUFFUSE_PROGRAM bool evaluate(ForEachListing forEachListing, const float *eta)
    {
        const bool hasLine = m_stroke.shade.lineChannel >= 0, hasColours = m_stroke.shade.colourChannel >= 0;
        m_warp.each([&](int lane) { m_sums[lane] = {}, m_share[lane] = {}; });
        forEachListing([&](const Listing &listing) {
            forEachBatch(listing, [&](int from, int nodes) {
                addBatch(m_warp, nodes, m_s, m_sums);
                if (hasLine)
                    addChannel(from, nodes, m_stroke.shade.lineChannel, m_share);
            });
        });
        if (hasLine || hasColours)
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k) {
                    const float inverse = math::inverseDensity(m_sums[lane].density[k]);
                    m_share[lane].v[k] = hasLine ? math::min_(m_share[lane].v[k] * inverse, 1.0f) : inverse;
                }
            });
        modulate(eta);
        bool seen = false;
        withMadeStyle(m_stroke, 0, [&](const auto &style) { seen = meanOfStyle(m_warp, style, m_s.means); });
        if (hasColours)
            m_warp.each([&](int lane) {
                SUFFUSE_UNROLL
                for (int k = 0; k < laneSamples; ++k)
                    m_sums[lane].density[k] = meanAt(lane, k); // the tables will be needed again
            });
        return seen;
    }

    /// Calls use(lane, sample, w, red, yellow, blue) for a stroke of one colour or of a line of colours.
    template <class Use>
    SUFFUSE_PROGRAM void forEachSample(Use use)
    {
        const Colour from = m_stroke.shade.colour,
                     end = m_stroke.shade.lineChannel >= 0 ? m_stroke.shade.colourEnd : from;
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float t = m_share[lane].v[k];
                const auto mean = [&](float a, float b) { return math::mulAdd_(t, b - a, a); };
                use(lane, k, meanAt(lane, k) * mean(from.opacity, end.opacity), mean(from.red, end.red),
                    mean(from.yellow, end.yellow), mean(from.blue, end.blue));
            }
        });
    }

    SUFFUSE_PROGRAM bool hasColours() const { return m_stroke.shade.colourChannel >= 0; }

    /// Of a stroke whose colours vary otherwise, one component (0 red … 3 opacity) after the other: use(lane, sample,
    /// w, colour). What it gives for the opacity is what it hands on as w.
    template <class ForEachListing, class Use>
    SUFFUSE_PROGRAM void forEachSample(ForEachListing forEachListing, int component, Use use)
    {
        Var<SampleValues> sum;
        m_warp.each([&](int lane) { sum[lane] = {}; });
        forEachListing([&](const Listing &listing) {
            forEachBatch(listing, [&](int from, int nodes) {
                addChannel(from, nodes, m_stroke.shade.colourChannel + component, sum);
            });
        });
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const float mean = math::min_(sum[lane].v[k] * m_share[lane].v[k], 1.0f);
                float &w = m_sums[lane].density[k];
                if (component == 3)
                    w *= mean;
                use(lane, k, w, mean);
            }
        });
    }

private:
    template <class Use>
    SUFFUSE_PROGRAM void forEachBatch(const Listing &listing, Use use)
    {
        for (int from = 0; from < listing.separable; from += batch) {
            const int to = from + batch < listing.separable ? from + batch : listing.separable;
            fillTables(m_warp, from, to, Block{}, m_s);
            use(from, to - from);
        }
    }

    SUFFUSE_PROGRAM void addChannel(int from, int nodes, int channel, Var<SampleValues> &sum)
    {
        cuda::addChannel(m_warp, from, nodes, m_frame.values + m_stroke.firstValue, m_stroke.channels,
                         std::uint32_t(channel), m_s, sum);
    }

    /// Hands φ′ = γφ and h² = (½γ|∇φ|)² on to the style.
    SUFFUSE_PROGRAM void modulate(const float *eta)
    {
        const float grain = m_stroke.shade.grain;
        m_warp.each([&](int lane) {
            const SampleSums &s = m_sums[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                float phi = math::min_(s.density[k], 1e18f);
                float h2 = math::mulAdd_(s.slopeX[k], s.slopeX[k], s.slopeY[k] * s.slopeY[k]);
                const int at = sampleAt(lane, k);
                if (eta) {
                    const float gamma = math::mulAdd_(1 - grain, eta[at], grain);
                    phi *= gamma, h2 *= gamma * gamma;
                }
                m_s.means.density[at] = phi;
                m_s.means.h2[at] = math::min_(h2, 1e36f);
            }
        });
    }

    /// F.
    SUFFUSE_PROGRAM float meanAt(int lane, int k) const { return m_s.means.mean[sampleAt(lane, k)]; }

    Warp &m_warp;
    const Frame &m_frame;
    const StrokeRecord &m_stroke;
    SumScratch &m_s;
    Var<SampleSums> m_sums;    ///< at last, where colours vary, w in the density
    Var<SampleValues> m_share; ///< the place on the line of colours, or 1/φ
};

} // namespace suffuse::cuda
