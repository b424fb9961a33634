// What strokes do with their sums at a tile's pixels: mixing them, and the way back to the derivatives by the sums.
#pragma once

#include "render/cuda/gradient/gradient_near.h"

namespace suffuse::cuda {

/// Derivatives by what is the same at all pixels, summed over those of a lane.
struct LaneTotals {
    float xi[3], value[gradientValues];
};

template <class Warp, bool varies>
class GradientPaint {
public:
    using Place = GradientPlace<Warp, varies>;
    using Scratch = typename Place::Scratch;
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM explicit GradientPaint(Place &place) : m_place(place), m_warp(place.warp), m_scratch(place.scratch)
    {}

    /// Mixes a stroke, whose sums are in the scratch memory, into the colours. Returns false if it shows nowhere. What
    /// the way back needs is written to `kept`, if that is not null.
    SUFFUSE_PROGRAM bool mix(const GradientStroke &stroke, float *kept)
    {
        return withStyle(stroke, [&](const auto &style) {
            const bool shows = m_warp.any([&](int lane) {
                bool any = false;
                for (int i = 0; i < lanePixels; ++i) {
                    const int at = pairOf(lane, i / 2) + i % 2;
                    const Sample p = sampleAt(stroke, at, m_scratch.sums[0][at], m_scratch.sums[1][at],
                                              m_scratch.sums[2][at], planesAt(at), 1);
                    any = any || style.seen(p.phi, p.square);
                }
                return any;
            });
            if (!shows)
                return false;
            m_warp.each([&](int lane) {
                SUFFUSE_ROLLED
                for (int i = 0; i < lanePairs; ++i) {
                    const int at = pairOf(lane, i);
                    if (kept)
                        keep(stroke, at, kept);
                    SUFFUSE_UNROLL
                    for (int j = 0; j < 2; ++j)
                        mixPixel(stroke, style, at + j);
                }
            });
            return true;
        });
    }

    /// Replaces the derivatives by the colours above a stroke by those below it, and puts those by its sums in the
    /// place of the sums. Returns false if the latter are all 0.
    SUFFUSE_PROGRAM bool back(const GradientStroke &stroke, const float *kept, Var<LaneTotals> &totals)
    {
        return withStyle(stroke, [&](const auto &style) {
            Var<int> some;
            m_warp.each([&](int lane) {
                LaneTotals own = {};
                some[lane] = 0;
                SUFFUSE_ROLLED
                for (int i = 0; i < lanePairs; ++i)
                    some[lane] |= pairBack(stroke, style, pairOf(lane, i), kept, own);
                totals[lane] = own;
            });
            return m_warp.any([&](int lane) { return some[lane] != 0; });
        });
    }

private:
    using Sample = math::PaintSample<float>;
    using Slopes = math::PaintSlopes<float>;

    /// Where e^(−φ_f) is kept.
    static constexpr int keptLeft = (keptPlanes + valuePlanes) * gradientSize;

    template <class Use>
    SUFFUSE_PROGRAM bool withStyle(const GradientStroke &s, Use use)
    {
        switch (s.kind) {
        case StyleKind::Uniform:
            return use(math::UniformSlopes<float>(s.xi[0], s.xi[1], s.xi[2]));
        case StyleKind::Feathering:
            return use(math::FeatheringSlopes<float>(s.xi[0], s.xi[1], s.xi[2]));
        case StyleKind::Edge:
            break;
        }
        return use(math::EdgeSlopes<float>(s.xi[0], s.xi[1], s.xi[2]));
    }

    /// η at a pixel of the tile, 1 beyond the picture.
    SUFFUSE_PROGRAM float etaAt(int at) const
    {
        const GradientWork &work = m_place.work;
        const int x = m_place.column * gradientSide + at % gradientSide,
                  y = m_place.row * gradientSide + at / gradientSide;
        return x < work.width && y < work.height ? work.paper[std::size_t(y) * std::size_t(work.width) + std::size_t(x)]
                                                 : 1;
    }

    /// The first value's sum at a pixel, as `sampleAt` takes it.
    SUFFUSE_PROGRAM const float *planesAt(int at) const
    {
        if constexpr (varies)
            return m_scratch.planes[0] + at;
        else
            return nullptr;
    }

    /// e^(−φ_f) at a pixel, as `sampleAt` takes it.
    SUFFUSE_PROGRAM float leftAt(int at) const { return varies ? m_scratch.left[varies ? at : 0] : 1; }

    /// `planes`: the first value's sum at the pixel; those of the others follow in planes of a tile's size. `left`
    /// counts where the stroke fades.
    SUFFUSE_PROGRAM Sample sampleAt(const GradientStroke &stroke, int at, float phi, float gx, float gy,
                                    const float *planes, float left) const
    {
        Sample p(phi, gx, gy);
        for (int i = 0; i < gradientValues; ++i)
            p.value[i] = stroke.constant[i];
        if constexpr (varies)
            if (stroke.fades)
                p.left = left;
        if (varies && stroke.varies) {
            p.inverse = math::reciprocal_(math::max_(planes[gradientValues * gradientSize], 1e-30f));
            for (int i = 0; i < gradientValues; ++i)
                p.takeMean(i, planes[i * gradientSize]);
        }
        if (m_place.work.paper)
            p.takePaper(etaAt(at));
        return p;
    }

    template <class Style>
    SUFFUSE_PROGRAM void mixPixel(const GradientStroke &stroke, const Style &style, int at)
    {
        const Sample p = sampleAt(stroke, at, m_scratch.sums[0][at], m_scratch.sums[1][at], m_scratch.sums[2][at],
                                  planesAt(at), leftAt(at));
        if (!style.seen(p.phi, p.square))
            return;
        float mean = 1;
        if (!style.full(p.phi, p.square))
            mean = math::clamp01(style.template slopes<false>(p.phi, p.square).mean);
        for (int c = 0; c < 3; ++c)
            m_scratch.colours[c][at] =
                math::mixed(m_scratch.colours[c][at], p.value[c], mean * p.value[3] * p.left, stroke.keep);
    }

    SUFFUSE_PROGRAM void keep(const GradientStroke &stroke, int at, float *kept) const
    {
        SUFFUSE_UNROLL
        for (int i = 0; i < 3; ++i) {
            Warp::writeTwo(kept + i * gradientSize + at, Warp::readTwo(m_scratch.sums[i] + at));
            Warp::writeTwo(kept + (3 + i) * gradientSize + at, Warp::readTwo(m_scratch.colours[i] + at));
        }
        if (varies && stroke.varies)
            for (int i = 0; i < valuePlanes; ++i)
                Warp::writeTwo(kept + (keptPlanes + i) * gradientSize + at, Warp::readTwo(m_scratch.planes[i] + at));
        if constexpr (varies)
            if (stroke.fades)
                Warp::writeTwo(kept + keptLeft + at, Warp::readTwo(m_scratch.left + at));
    }

    /// Returns 1 if any derivative by sums is not 0 for sure.
    template <class Style>
    SUFFUSE_PROGRAM int pairBack(const GradientStroke &stroke, const Style &style, int at, const float *kept,
                                 LaneTotals &totals)
    {
        int some = 0;
        float was[keptPlanes][2];
        SUFFUSE_UNROLL
        for (int i = 0; i < keptPlanes; ++i) {
            const Two two = Warp::readTwo(kept + i * gradientSize + at);
            was[i][0] = two.x, was[i][1] = two.y;
        }
        SUFFUSE_UNROLL
        for (int j = 0; j < 2; ++j) {
            const float sums[3] = {was[0][j], was[1][j], was[2][j]}, below[3] = {was[3][j], was[4][j], was[5][j]};
            const float left = varies && stroke.fades ? kept[keptLeft + at + j] : 1;
            some |=
                pixelBack(stroke, style, at + j, sums, below, kept + keptPlanes * gradientSize + at + j, left, totals);
        }
        return some;
    }

    template <class Style>
    SUFFUSE_PROGRAM int pixelBack(const GradientStroke &stroke, const Style &style, int at, const float (&sums)[3],
                                  const float (&below)[3], const float *planes, float left, LaneTotals &totals)
    {
        const Sample p = sampleAt(stroke, at, sums[0], sums[1], sums[2], planes, left);
        const bool isFull = style.full(p.phi, p.square);
        if (!style.seen(p.phi, p.square)) {
            for (auto &plane : m_scratch.sums)
                plane[at] = 0;
            if (varies && stroke.varies)
                for (int i = 0; i < valuePlanes; ++i)
                    m_scratch.planes[i][at] = 0;
            if constexpr (varies)
                if (stroke.fades)
                    m_scratch.left[at] = 0;
            return 0;
        }
        math::MeanSlopes<float> m{1, 0, 0, {0, 0, 0}};
        if (!isFull)
            m = m_place.work.byXi ? style.template slopes<true>(p.phi, p.square)
                                  : style.template slopes<false>(p.phi, p.square);
        m.mean = math::clamp01(m.mean);
        float by[3];
        for (int c = 0; c < 3; ++c)
            by[c] = m_scratch.colours[c][at];
        const Slopes slopes = m_place.work.paper
                                  ? math::paintBack<true>(p, m, stroke.keep, below, sums[0], etaAt(at), by)
                                  : math::paintBack<false>(p, m, stroke.keep, below, sums[0], 1.0f, by);
        for (int c = 0; c < 3; ++c)
            m_scratch.colours[c][at] = by[c];
        if (!isFull && m_place.work.byXi)
            for (int i = 0; i < 3; ++i)
                totals.xi[i] += slopes.byMean * m.byXi[i];
        m_scratch.sums[0][at] = slopes.byPhi;
        m_scratch.sums[1][at] = 2 * slopes.bySquare * sums[1];
        m_scratch.sums[2][at] = 2 * slopes.bySquare * sums[2];
        if constexpr (varies) {
            if (stroke.fades)
                m_scratch.left[at] = slopes.byFading;
            if (stroke.varies) {
                valuesBack(p, slopes, at);
                return 1;
            }
        }
        for (int i = 0; i < gradientValues; ++i)
            totals.value[i] += slopes.value[i];
        return !isFull || stroke.fades;
    }

    /// Puts the derivatives by sums of values, and by φ⁺, in the place of these sums.
    SUFFUSE_PROGRAM void valuesBack(const Sample &p, const Slopes &slopes, int at)
    {
        float byLaid = 0;
        for (int i = 0; i < gradientValues; ++i) {
            const float slope = slopes.value[i] * p.inverse;
            m_scratch.planes[i][at] = slope;
            byLaid = math::negMulAdd_(slope, p.value[i], byLaid);
        }
        m_scratch.planes[gradientValues][at] = byLaid;
    }

    Place &m_place;
    Warp &m_warp;
    Scratch &m_scratch;
};

} // namespace suffuse::cuda
