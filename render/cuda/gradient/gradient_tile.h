// The program that draws a tile of a picture, takes the loss there, and goes back through all strokes.
#pragma once

#include "render/cuda/gradient/gradient_node_sums.h"
#include "render/cuda/gradient/gradient_paint.h"

namespace suffuse::cuda {

template <class Warp, bool varies>
class GradientTile {
public:
    using Place = GradientPlace<Warp, varies>;
    using Scratch = typename Place::Scratch;

    /// `slot`: where this warp may keep what the way back needs.
    SUFFUSE_PROGRAM GradientTile(Warp &warp, const GradientWork &work, Scratch &scratch, std::uint32_t tile,
                                 std::uint32_t slot)
        : m_place(warp, work, scratch, int(tile) % work.columns, int(tile) / work.columns), m_warp(warp), m_work(work),
          m_scratch(scratch), m_tile(tile),
          m_kept(work.kept + std::size_t(slot) * work.slotStrokes * keptFloats<varies>),
          m_shown(work.shown + std::size_t(slot) * work.slotStrokes)
    {}

    SUFFUSE_PROGRAM void run()
    {
        m_warp.each([&](int lane) {
            for (int i = lane; i < 3 * gradientSize; i += warpLanes)
                m_scratch.colours[i / gradientSize][i % gradientSize] = m_work.background[i / gradientSize];
        });
        for (std::uint32_t from = 0; from < m_work.strokeCount; from += warpLanes) {
            std::uint32_t mask = m_warp.ballot([&](int lane) {
                const std::uint32_t i = from + std::uint32_t(lane);
                return i < m_work.strokeCount && m_place.meets(m_work.boxes[i]);
            });
            for (; mask; mask &= mask - 1)
                draw(from + std::uint32_t(Warp::lowest(mask)));
        }
        finishPicture();
        if (!goesBack())
            return;
        if (m_count > m_work.slotStrokes) { // The host will make room and call again.
            m_warp.each([&](int lane) {
                if (lane == 0)
                    Warp::raise(m_work.status + mostStrokesShown, m_count);
            });
            return;
        }
        for (std::uint32_t i = m_count; i-- > 0;)
            back(i);
    }

private:
    template <class T>
    using Var = typename Warp::template Var<T>;

    // Made where they are needed: members that refer to another member would keep all of them out of registers.
    SUFFUSE_PROGRAM GradientNodeSums<Warp, varies> nodes() { return GradientNodeSums<Warp, varies>(m_place); }
    SUFFUSE_PROGRAM GradientPaint<Warp, varies> paint() { return GradientPaint<Warp, varies>(m_place); }
    SUFFUSE_PROGRAM bool goesBack() const { return m_work.target || m_work.byRgb; }

    SUFFUSE_PROGRAM void draw(std::uint32_t index)
    {
        const GradientStroke stroke = m_work.strokes[index]; // a copy, which no store can change
        if (!m_place.mayShow(stroke, m_work.levels[index]))
            return;
        Var<LaneSums> sums;
        m_warp.each([&](int lane) { sums[lane] = {}; });
        if (varies && stroke.varies) {
            Var<LanePlanes> planes;
            m_warp.each([&](int lane) { planes[lane] = {}; });
            nodes().template add<varies>(stroke.firstNode, stroke.endNode, Place::paintOf(stroke), sums, &planes);
            m_warp.each([&](int lane) {
                for (int i = 0; i < valuePlanes; ++i)
                    writePlane(lane, m_scratch.planes[i], planes[lane].v[i]);
            });
        } else
            addPlain(stroke.firstNode, stroke.endNode, Place::paintOf(stroke), sums);
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int i = 0; i < 3; ++i)
                writePlane(lane, m_scratch.sums[i], sums[lane].v[i]);
        });
        if constexpr (varies)
            if (stroke.fades)
                fade(stroke);
        const bool keeps = goesBack() && m_count < m_work.slotStrokes;
        if (!paint().mix(stroke, keeps ? m_kept + std::size_t(m_count) * keptFloats<varies> : nullptr))
            return;
        if (keeps)
            m_warp.each([&](int lane) {
                if (lane == 0)
                    m_shown[m_count] = index;
            });
        ++m_count;
    }

    SUFFUSE_PROGRAM void addPlain(std::uint32_t first, std::uint32_t end, NearKind kind, Var<LaneSums> &sums)
    {
        nodes().template add<false>(first, end, kind, sums, static_cast<Var<LanePlanes> *>(nullptr));
    }

    /// Writes e^(−φ_f) of a stroke.
    SUFFUSE_PROGRAM void fade(const GradientStroke &stroke)
    {
        Var<LaneSums> sums;
        m_warp.each([&](int lane) { sums[lane] = {}; });
        addPlain(stroke.firstNode, stroke.endNode, NearKind::Fading, sums);
        m_warp.each([&](int lane) {
            for (float &value : sums[lane].v[0])
                value = math::exp2_(float(-math::log2e) * value);
            writePlane(lane, m_scratch.left, sums[lane].v[0]);
        });
    }

    static SUFFUSE_PROGRAM void writePlane(int lane, float *plane, const float (&values)[lanePixels])
    {
        SUFFUSE_UNROLL
        for (int i = 0; i < lanePairs; ++i)
            Warp::writeTwo(plane + pairOf(lane, i), {values[2 * i], values[2 * i + 1]});
    }

    /// Writes R, G, B, and puts the derivatives of the loss by R, Y, B in the place of the colours.
    SUFFUSE_PROGRAM void finishPicture()
    {
        Var<float> loss;
        m_warp.each([&](int lane) {
            loss[lane] = 0;
            SUFFUSE_ROLLED
            for (int at = lane; at < gradientSize; at += warpLanes)
                finishPixel(at, loss[lane]);
        });
        if (!m_work.target)
            return;
        const float sum = m_warp.sum(loss);
        m_warp.each([&](int lane) {
            if (lane == 0)
                m_work.losses[m_tile] = sum;
        });
    }

    SUFFUSE_PROGRAM void finishPixel(int at, float &loss)
    {
        const int x = m_place.column * gradientSide + at % gradientSide,
                  y = m_place.row * gradientSide + at / gradientSide;
        const bool isInside = x < m_work.width && y < m_work.height;
        const std::size_t pixel = isInside ? 3 * (std::size_t(y) * std::size_t(m_work.width) + std::size_t(x)) : 0;
        float ryb[3];
        for (int c = 0; c < 3; ++c)
            ryb[c] = m_scratch.colours[c][at];
        const math::Triple<float> colour = math::rgbFromRyb(ryb[0], ryb[1], ryb[2]);
        const float rgb[3] = {colour.x, colour.y, colour.z};
        float by[3] = {0, 0, 0};
        for (int c = 0; c < 3 && isInside; ++c) {
            if (m_work.picture)
                m_work.picture[pixel + std::size_t(c)] = rgb[c];
            if (m_work.target) {
                const float difference = rgb[c] - m_work.target[pixel + std::size_t(c)];
                by[c] = 2 * difference;
                loss = math::mulAdd_(difference, difference, loss);
            } else if (m_work.byRgb)
                by[c] = m_work.byRgb[pixel + std::size_t(c)];
        }
        const math::Triple<float> slopes = math::rybSlopes(ryb[0], ryb[1], ryb[2], {by[0], by[1], by[2]});
        m_scratch.colours[0][at] = slopes.x, m_scratch.colours[1][at] = slopes.y, m_scratch.colours[2][at] = slopes.z;
    }

    SUFFUSE_PROGRAM void back(std::uint32_t i)
    {
        const GradientStroke stroke = m_work.strokes[m_shown[i]]; // a copy, which no store can change
        Var<LaneTotals> lanes;
        const bool any = paint().back(stroke, m_kept + std::size_t(i) * keptFloats<varies>, lanes);
        LaneTotals totals = {};
        if (m_work.byXi)
            for (int j = 0; j < 3; ++j)
                totals.xi[j] = total(lanes, [j](const LaneTotals &t) { return t.xi[j]; });
        if (varies && stroke.varies) {
            backVarying(stroke, totals);
        } else {
            sumValues(lanes, totals);
            backTo(stroke.firstNode, stroke.endNode, Place::paintOf(stroke), any, m_scratch.sums[0], totals);
        }
        if constexpr (varies)
            if (stroke.fades)
                backFading(stroke);
    }

    /// The slopes of φ_f count nowhere.
    SUFFUSE_PROGRAM void backFading(const GradientStroke &stroke)
    {
        m_warp.each([&](int lane) {
            for (int at = lane; at < gradientSize; at += warpLanes)
                m_scratch.sums[1][at] = m_scratch.sums[2][at] = 0;
        });
        LaneTotals none = {};
        backTo(stroke.firstNode, stroke.endNode, NearKind::Fading, true, m_scratch.left, none);
    }

    template <class Get>
    SUFFUSE_PROGRAM float total(const Var<LaneTotals> &lanes, Get get)
    {
        Var<float> one;
        m_warp.each([&](int lane) { one[lane] = get(lanes[lane]); });
        return m_warp.sum(one);
    }
    SUFFUSE_PROGRAM void sumValues(const Var<LaneTotals> &lanes, LaneTotals &totals)
    {
        SUFFUSE_UNROLL
        for (int j = 0; j < gradientValues; ++j)
            totals.value[j] = total(lanes, [j](const LaneTotals &t) { return t.value[j]; });
    }

    /// Goes back to nodes of a kind. `totals` stand with the first of them that reaches the tile, and are 0 then.
    SUFFUSE_PROGRAM void backTo(std::uint32_t first, std::uint32_t end, NearKind kind, bool any, const float *g,
                                LaneTotals &totals)
    {
        bool written = false;
        for (std::uint32_t from = first; from < end; from += warpLanes) {
            const int count = m_place.gather(from, end, kind);
            if (count == 0)
                continue;
            if (!written)
                writeTotals(totals);
            written = true;
            if (!any)
                return;
            SUFFUSE_ROLLED
            for (int at = 0; at < count; at += Scratch::batch)
                nodes().back(at, count - at < Scratch::batch ? count - at : Scratch::batch, g);
        }
    }

    SUFFUSE_PROGRAM void writeTotals(LaneTotals &totals)
    {
        m_warp.each([&](int lane) {
            if (lane > 0)
                return;
            float *to = m_work.entries[m_scratch.nodes[0].entry].v + GradientEntry::ofNode;
            Warp::writeFour(to, {totals.xi[0], totals.xi[1], totals.xi[2], totals.value[0]});
            Warp::writeFour(to + 4, {totals.value[1], totals.value[2], totals.value[3], totals.value[4]});
        });
        totals = {};
    }

    /// Segments of a stroke whose values vary: each has derivatives by its own values.
    SUFFUSE_PROGRAM void backVarying(const GradientStroke &stroke, LaneTotals &totals)
    {
        for (std::uint32_t k = stroke.first; k < stroke.end; ++k) {
            const GradientSegment &segment = m_work.segments[k];
            if (segment.fade)
                continue;
            if (segment.lift) {
                backTo(segment.firstNode, segment.endNode, NearKind::All, true, m_scratch.sums[0], totals);
                continue;
            }
            Var<LaneSums> sums;
            m_warp.each([&](int lane) { sums[lane] = {}; });
            addPlain(segment.firstNode, segment.endNode, NearKind::All, sums);
            Var<LaneTotals> lanes;
            m_warp.each([&](int lane) {
                lanes[lane] = {};
                SUFFUSE_UNROLL
                for (int i = 0; i < lanePixels; ++i)
                    addOwn(segment, pairOf(lane, i / 2) + i % 2, sums[lane].v[0][i], lanes[lane]);
            });
            sumValues(lanes, totals);
            backTo(segment.firstNode, segment.endNode, NearKind::All, true, m_scratch.own, totals);
        }
    }

    /// A segment's density has a part in its stroke's density, in φ⁺ and in the sums of values.
    SUFFUSE_PROGRAM void addOwn(const GradientSegment &segment, int at, float density, LaneTotals &totals)
    {
        const float *planes = m_scratch.planes[0] + at;
        float sum = m_scratch.sums[0][at] + planes[gradientValues * gradientSize];
        for (int j = 0; j < gradientValues; ++j) {
            const float slope = planes[j * gradientSize];
            totals.value[j] = math::mulAdd_(density, slope, totals.value[j]);
            sum = math::mulAdd_(slope, segment.value[j], sum);
        }
        m_scratch.own[at] = sum;
    }

    Place m_place;
    Warp &m_warp;
    const GradientWork &m_work;
    Scratch &m_scratch;
    std::uint32_t m_tile;
    float *m_kept;
    std::uint32_t *m_shown;
    std::uint32_t m_count = 0; ///< strokes that show
};

} // namespace suffuse::cuda
