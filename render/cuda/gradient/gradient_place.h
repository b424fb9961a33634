// The program that places the nodes of one stroke, and clears what tiles will say of them.
#pragma once

#include "render/cuda/gradient/gradient_curve.h"
#include "render/math/scalar.h"
#include "render/math/style_slopes.h"

namespace suffuse::cuda {

template <class Warp>
class GradientPlacer {
public:
    SUFFUSE_PROGRAM GradientPlacer(Warp &warp, const GradientWork &work, std::uint32_t stroke)
        : m_warp(warp), m_work(work), m_stroke(stroke)
    {}

    SUFFUSE_PROGRAM void run()
    {
        const GradientStroke &stroke = m_work.strokes[m_stroke];
        m_warp.each([&](int lane) { m_left[lane] = m_top[lane] = m_right[lane] = m_bottom[lane] = 1e30f; });
        for (std::uint32_t k = stroke.first; k < stroke.end; ++k) {
            clear(m_work.segments[k]);
            place(k);
        }
        const float left = m_warp.least(m_left), top = m_warp.least(m_top);
        const float right = -m_warp.least(m_right), bottom = -m_warp.least(m_bottom);
        m_warp.each([&](int lane) {
            if (lane > 0)
                return;
            m_work.boxes[m_stroke] = {left, top, right, bottom};
            m_work.levels[m_stroke] = levelOf(stroke);
        });
    }

private:
    template <class T>
    using Var = typename Warp::template Var<T>;

    static SUFFUSE_PROGRAM float levelOf(const GradientStroke &s)
    {
        if (s.kind == StyleKind::Uniform)
            return math::UniformSlopes<float>(s.xi[0], s.xi[1], s.xi[2]).cut;
        if (s.kind == StyleKind::Feathering)
            return math::FeatheringSlopes<float>(s.xi[0], s.xi[1], s.xi[2]).cut;
        return math::EdgeSlopes<float>(s.xi[0], s.xi[1], s.xi[2]).phiE;
    }

    SUFFUSE_PROGRAM void clear(const GradientSegment &s)
    {
        const std::uint32_t count = (s.endNode - s.firstNode) * s.mostX * s.mostY;
        m_warp.each([&](int lane) {
            for (std::uint32_t i = std::uint32_t(lane); i < count; i += warpLanes)
                m_work.entries[s.firstEntry + i] = {};
        });
    }

    SUFFUSE_PROGRAM void place(std::uint32_t k)
    {
        const GradientSegment &s = m_work.segments[k];
        const GradientCurve curve(s, m_work.view);
        const double spread = s.spread * m_work.view.scale, gain = s.density * gradientWeightScale(s, m_work.view);
        GradientNode common;
        common.inverse = float(1 / spread), common.cut = float(s.cut), common.reach = float(s.radius * spread);
        common.segment = k;
        m_warp.each([&](int lane) {
            for (std::uint32_t i = s.firstNode + std::uint32_t(lane); i < s.endNode; i += warpLanes) {
                const GradientRule &rule = m_work.rules[i];
                const GradientVector at = curve.sum(rule.point), slope = curve.sum(rule.slope);
                GradientNode node = common;
                node.x = at.x, node.y = at.y;
                node.weight = float(gain * rule.weight * sqrt(slope.x * slope.x + slope.y * slope.y));
                node.entry = s.firstEntry + (i - s.firstNode) * s.mostX * s.mostY;
                findTiles(at.x, node.reach, m_work.columns, s.mostX, node.tileX, node.tilesX);
                findTiles(at.y, node.reach, m_work.rows, s.mostY, node.tileY, node.tilesY);
                m_work.nodes[i] = node;
                addToBox(lane, node);
            }
        });
    }

    SUFFUSE_PROGRAM void addToBox(int lane, const GradientNode &node)
    {
        const float by = node.reach + gradientMargin, x = float(node.x), y = float(node.y);
        m_left[lane] = math::min_(m_left[lane], x - by), m_right[lane] = math::min_(m_right[lane], -(x + by));
        m_top[lane] = math::min_(m_top[lane], y - by), m_bottom[lane] = math::min_(m_bottom[lane], -(y + by));
    }

    /// Finds the first tile and the number of tiles along an axis, whose pixels' centres a node can reach.
    static SUFFUSE_PROGRAM void findTiles(double at, float reach, int tiles, int most, std::int16_t &first,
                                          std::int16_t &count)
    {
        const double by = double(reach) + double(gradientMargin);
        const double low = ceil((at - by - (gradientSide - 0.5)) / gradientSide),
                     high = floor((at + by - 0.5) / gradientSide);
        const int from = low > 0 ? (low < tiles ? int(low) : tiles) : 0;
        const int to = high < tiles - 1 ? (high > -1 ? int(high) : -1) : tiles - 1;
        const int all = to - from + 1 < most ? to - from + 1 : most;
        first = std::int16_t(from), count = std::int16_t(all > 0 ? all : 0);
    }

    Warp &m_warp;
    const GradientWork &m_work;
    std::uint32_t m_stroke;
    Var<float> m_left, m_top, m_right, m_bottom; ///< of the box, the last two with their signs changed
};

} // namespace suffuse::cuda
