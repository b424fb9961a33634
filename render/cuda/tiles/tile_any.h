// One warp evaluates a stroke of any kind here at a block of samples: granulated, of several styles or colours, with
// paint taken away, anisotropic, or too wide on screen for floats.
#pragma once

#include "render/cuda/tiles/tile_crisp.h"
#include "render/cuda/tiles/tile_paper.h"
#include "render/cuda/tiles/tile_plain.h"
#include "render/cuda/tiles/tile_stream.h"

namespace suffuse::cuda {

/// If `fills`, the stroke may have a fill.
template <class Warp, bool fills>
class AnyStroke {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM AnyStroke(Warp &warp, const Frame &frame, const ApartJob &job, const StrokeRecord &stroke,
                              PaintScratch &paint)
        : m_warp(warp), m_frame(frame), m_stroke(stroke), m_job(job), m_left(job.column * tileSide),
          m_top(job.row * tileSide), m_cover{paint.sums.means.density, paint.sums.means.h2}, m_paint(paint),
          m_sums(paint.sums)
    {}

    /// Finds w and colour at a block of samples, and leaves them in `paintedSamples`. `plane` is that of the block's η
    /// (`etaPlane`).
    SUFFUSE_PROGRAM void evaluate(const Block &block, int plane)
    {
        m_warp.each([&](int lane) {
            m_lane[lane].sums = {};
            for (std::uint32_t c = 0; c < m_stroke.channels; ++c)
                m_lane[lane].channel[c] = {};
        });
        NodeStream<Warp, fills> nodes(m_warp, m_frame, m_job, m_paint.fetched, m_sums);
        if constexpr (fills) {
            sumWithFill(nodes, block);
        } else {
            nodes.forEachListing(block, [&](const Listing &listing) { addNodes(listing, block); });
        }
        if (hasPaper())
            findEta(m_warp, m_frame, m_job.column, m_job.row, block, plane, m_paint.eta);
        if (m_stroke.deep || has(deepFill)) {
            const double x = double(m_left + tileSide / 2) + double(block.x);
            const double y = double(m_top + tileSide / 2) + double(block.y);
            sumDeep(m_warp, m_frame, m_stroke, x, y, m_paint.deep);
            if (has(deepFill))
                addDeepFill(m_warp, m_frame, m_stroke, x, y, m_paint.deep);
            shade<double>(block);
        } else {
            shade<float>(block);
        }
    }

private:
    /// Tells whether the stroke has a fill of this kind.
    SUFFUSE_PROGRAM bool has(FillFlag flag) const { return fills && (m_stroke.fill & flag) != 0; }
    SUFFUSE_PROGRAM const FillValues &fillValues() const { return m_frame.fills[m_stroke.fillValues]; }
    SUFFUSE_PROGRAM bool hasPaper() const { return m_stroke.granulated && m_frame.paper.kind != 0; }

    SUFFUSE_PROGRAM void addNodes(const Listing &listing, const Block &block)
    {
        addSeparable(listing, block);
        for (int n = wholeStrides(listing.separable); n < listing.count; ++n)
            addOblique(n, block);
    }

    SUFFUSE_PROGRAM void sumWithFill(NodeStream<Warp, fills> &nodes, const Block &block)
    {
        const bool crisp = has(crispFill);
        m_isFillOpen = has(haveFill) && !crisp && !has(deepFill), m_base = 0;
        if (crisp)
            clearCover(m_warp, m_cover);
        nodes.forEachListing(
            block,
            [&](const Listing &listing) {
                if (m_isFillOpen)
                    addFill(listing, block);
                addNodes(listing, block);
            },
            [&](const Fetched &chunk, int records, Listing &listing) {
                if (crisp)
                    m_base += addCover(m_warp, m_cover, chunk, records, fillValues(), m_job.column, m_job.row, block);
                else if (m_isFillOpen)
                    listFill(m_warp, chunk, records, fillValues(), m_job.column, m_job.row, block, m_sums, listing);
            });
        if (m_isFillOpen)
            finishFill(block);
    }

    SUFFUSE_PROGRAM const float *values() const { return m_frame.values + m_stroke.firstValue; }

    /// Adds the listed part of a fill of density 1, and ends it where nodes follow.
    SUFFUSE_PROGRAM void addFill(const Listing &listing, const Block &block)
    {
        m_base += listing.base;
        if (listing.fill > 0 && fillValues().b != 0) {
            addObliqueFill(m_warp, listing.fill, fillValues(), block, m_sums, m_lane);
        } else if (listing.fill > 0) {
            Var<SampleSums> sums;
            m_warp.each([&](int lane) { sums[lane] = m_lane[lane].sums; });
            addFillEntries(m_warp, listing, block, m_sums, sums);
            m_warp.each([&](int lane) { m_lane[lane].sums = sums[lane]; });
        }
        if (listing.count > wholeStrides(listing.fill))
            finishFill(block);
    }

    SUFFUSE_PROGRAM FillPlace fillPlace() const
    {
        if (!has(gradientFill))
            return {};
        return {fillValues(), double(m_left + tileSide / 2), double(m_top + tileSide / 2)};
    }

    /// Makes sums of a fill of density 1 those of the stroke's fill, with its channels.
    SUFFUSE_PROGRAM void finishFill(const Block &block)
    {
        m_isFillOpen = false;
        const FillValues &values = fillValues();
        const FillPlace place = fillPlace();
        const float full = m_stroke.fillDensity, base = float(m_base);
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                SampleSums &own = m_lane[lane].sums;
                const float inside = math::min_(math::max_(own.density[k] + base, 0.0f), 1.0f);
                float t = 0;
                if (has(gradientFill))
                    t = place.at(sampleX(lane, k, block), sampleY(lane, k, block), inside, own.slopeX[k],
                                 own.slopeY[k]);
                own.density[k] = full * inside;
                own.slopeX[k] *= full, own.slopeY[k] *= full;
                for (int c = 0; c < int(m_stroke.channels); ++c)
                    m_lane[lane].channel[c].v[k] = full * inside * math::mulAdd_(t, values.step[c], values.from[c]);
            }
        });
    }

    SUFFUSE_PROGRAM float coveredAt(int at) const { return coveredShare(m_cover.covered[at] + float(m_base)); }

    SUFFUSE_PROGRAM void addSeparable(const Listing &listing, const Block &block)
    {
        for (int from = wholeStrides(listing.fill); from < listing.separable; from += batch) {
            const int to = from + batch < listing.separable ? from + batch : listing.separable;
            fillTables(m_warp, from, to, block, m_sums);
            Var<SampleSums> sums;
            m_warp.each([&](int lane) { sums[lane] = m_lane[lane].sums; });
            addBatch(m_warp, to - from, m_sums, sums);
            m_warp.each([&](int lane) { m_lane[lane].sums = sums[lane]; });
            for (std::uint32_t c = 0; c < m_stroke.channels; ++c) {
                Var<SampleValues> sum;
                m_warp.each([&](int lane) { sum[lane] = m_lane[lane].channel[c]; });
                addChannel(m_warp, from, to - from, values(), m_stroke.channels, c, m_sums, sum);
                m_warp.each([&](int lane) { m_lane[lane].channel[c] = sum[lane]; });
            }
        }
    }

    /// Adds a node whose axes lie askew, so that it is no product of two tables.
    SUFFUSE_PROGRAM void addOblique(int n, const Block &block)
    {
        const ListedNode node = m_sums.listed[n];
        const float a = node.first.z, b = node.first.w, c = node.second.x, cut = node.second.y, weight = node.second.z;
        const float *value = values() + std::size_t(m_sums.rows[n]) * m_stroke.channels;
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                const float x = sampleX(lane, k, block) - node.first.x;
                const float y = sampleY(lane, k, block) - node.first.y;
                const float ax = a * x + b * y, cy = b * x + c * y;
                const float e = math::exp2_(-float(math::log2e) * (x * ax + y * cy));
                if (!(cut < e))
                    continue;
                SampleSums &own = m_lane[lane].sums;
                const float density = (e - cut) * weight, slope = weight * e * (1 / slopeUnit);
                own.density[k] += density;
                own.slopeX[k] += slope * ax;
                own.slopeY[k] += slope * cy;
                for (std::uint32_t i = 0; i < m_stroke.channels; ++i)
                    m_lane[lane].channel[i].v[k] += density * value[i];
            }
        });
    }

    /// Turns sums into opacity and colour, in double if the stroke is so wide that floats would lose its edge.
    template <class V>
    SUFFUSE_PROGRAM void shade(const Block &block)
    {
        const ShadeParams &params = m_stroke.shade;
        const bool crisp = has(crispFill);
        const FillValues *values = crisp ? &fillValues() : nullptr;
        const FillPlace place = crisp ? fillPlace() : FillPlace();
        m_warp.each([&](int lane) {
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k), column = sampleColumn(lane, k), row = sampleRow(lane, k);
                const double x = (double(column) - 7.5) * double(block.step),
                             y = (double(row) - 7.5) * double(block.step);
                DeepSample deep;
                if (sizeof(V) == sizeof(double))
                    deep = deepSample(m_paint.deep[0], x, y);
                V eta(1);
                if (hasPaper())
                    eta = V(m_paint.eta[at]);
                const SampleSums &own = m_lane[lane].sums;
                const V slopeX = V(own.slopeX[k]) * V(slopeUnit) + V(deep.slopeX);
                const V slopeY = V(own.slopeY[k]) * V(slopeUnit) + V(deep.slopeY);
                // A crisp fill adds `more` where it covers the sample.
                const auto shaded = [&](float more, float t) {
                    const auto channel = [&](int c) {
                        V sum = V(m_lane[lane].channel[c].v[k]);
                        if (sizeof(V) == sizeof(double))
                            sum += V(deepValue(m_paint.deep[1 + c], x, y));
                        if (fills && more > 0)
                            sum += V(more * math::mulAdd_(t, values->step[c], values->from[c]));
                        return sum;
                    };
                    const auto m = math::modulate(params, V(own.density[k]) + V(deep.density) + V(more), slopeX, slopeY,
                                                  channel, eta, V(block.step));
                    const V f = meanAt(params, channel, m);
                    const auto paint = math::paintOf(params, m.inverse, channel, f);
                    return Float4{float(paint.w), float(paint.red), float(paint.yellow), float(paint.blue)};
                };
                Float4 mixed = {0, 0, 0, 0};
                if constexpr (fills) {
                    // What it covers and what it leaves are shaded each by itself, but for a sample that is wholly
                    // covered, or not at all. Only one place shades, since its code is long.
                    const float covered = crisp ? coveredAt(at) : 0.0f;
                    SUFFUSE_ROLLED
                    for (int inside = covered < 1 ? 0 : 1; inside <= (covered > 0 ? 1 : 0); ++inside) {
                        float t = 0;
                        if (inside && has(gradientFill))
                            t = place.at(sampleX(lane, k, block), sampleY(lane, k, block), 1, 0, 0);
                        const Float4 shown = shaded(inside ? m_stroke.fillDensity : 0.0f, t);
                        mixed = inside && covered < 1 ? shared(mixed, shown, covered) : shown;
                    }
                } else {
                    mixed = shaded(0, 0);
                }
                paintedSamples(m_sums)[at] = mixed;
            }
        });
    }

    /// Returns what a sample shows of which a share is covered, from w and colour where it is not and where it is.
    static SUFFUSE_PROGRAM Float4 shared(const Float4 &out, const Float4 &in, float covered)
    {
        const float inside = covered * in.x, left = (1 - covered) * out.x, w = inside + left;
        const float inverse = w > 0 ? 1 / w : 0.0f;
        return {w, (inside * in.y + left * out.y) * inverse, (inside * in.z + left * out.z) * inverse,
                (inside * in.w + left * out.w) * inverse};
    }

    template <class Channel>
    SUFFUSE_PROGRAM double meanAt(const ShadeParams &params, Channel channel, const math::Modulated<double> &m)
    {
        return math::mixedStyles<double>(params, channel, m);
    }
    template <class Channel>
    SUFFUSE_PROGRAM float meanAt(const ShadeParams &params, Channel channel, const math::Modulated<float> &m)
    {
        if (!math::hasOneStyle(params))
            return math::mixedStyles<float>(params, channel, m);
        float f = 0;
        withMadeStyle(m_stroke, 0, [&](const auto &style) { f = math::meanWhere(style, m.phi, m.h2, m.lifted); });
        return f;
    }

    Warp &m_warp;
    const Frame &m_frame;
    const StrokeRecord &m_stroke;
    const ApartJob &m_job;
    const int m_left, m_top;
    const FillCover m_cover;   ///< where simple strokes alone have something else
    int m_base = 0;            ///< how often the fill is entered left of what is summed
    bool m_isFillOpen = false; ///< whether the sums are those of the fill so far
    Var<AllSums> m_lane;
    PaintScratch &m_paint;
    SumScratch &m_sums;
};

/// It is called, not inlined, since its code is long.
template <bool fills, class Warp>
SUFFUSE_CALL void evaluateAny(Warp warp, const Frame &frame, const ApartJob job, const Block block, int plane,
                              PaintScratch &paint)
{
    SUFFUSE_IS_LAUNCHED(frame);
    SUFFUSE_IN_SHARED(paint);
    AnyStroke<Warp, fills>(warp, frame, job, strokeOf(paint.stroke), paint).evaluate(block, plane);
}

} // namespace suffuse::cuda
