// The program that adds up what tiles say of one segment's nodes, and goes back from them to the segment's numbers.
#pragma once

#include "render/cuda/gradient/gradient_curve.h"

namespace suffuse::cuda {

template <class Warp>
class GradientSummer {
public:
    SUFFUSE_PROGRAM GradientSummer(Warp &warp, const GradientWork &work, std::uint32_t segment)
        : m_warp(warp), m_work(work), m_segment(segment)
    {}

    SUFFUSE_PROGRAM void run()
    {
        const GradientSegment &s = m_work.segments[m_segment];
        m_warp.each([&](int lane) { m_all[lane] = {}; });
        for (std::uint32_t from = s.firstNode; from < s.endNode; from += warpLanes) {
            if (s.mostX * s.mostY <= fewEntries)
                addEachByOne(s, from);
            else
                addEachByAll(s, from);
            chain(s, from);
        }
        write();
    }

private:
    template <class T>
    using Var = typename Warp::template Var<T>;
    static constexpr int numbers = GradientEntry::numbers;
    static constexpr int fewEntries = 64;
    static constexpr int outputs = 10 + gradientValues + 3;

    struct NodeTotals {
        double v[numbers];
    };
    struct Outputs {
        double v[outputs]; // in the order of GradientSums
    };

    SUFFUSE_PROGRAM void add(NodeTotals &to, std::uint32_t entry)
    {
        const float *from = m_work.entries[entry].v;
        SUFFUSE_UNROLL
        for (int part = 0; part < numbers; part += 4) {
            const Four four = Warp::readFour(from + part);
            to.v[part] += double(four.x), to.v[part + 1] += double(four.y);
            to.v[part + 2] += double(four.z), to.v[part + 3] += double(four.w);
        }
    }

    /// Nodes that reach few tiles: one a lane.
    SUFFUSE_PROGRAM void addEachByOne(const GradientSegment &s, std::uint32_t from)
    {
        m_warp.each([&](int lane) {
            m_node[lane] = {};
            const std::uint32_t i = from + std::uint32_t(lane);
            if (i >= s.endNode)
                return;
            const GradientNode &node = m_work.nodes[i];
            const std::uint32_t count = std::uint32_t(node.tilesX) * std::uint32_t(node.tilesY), first = node.entry;
            for (std::uint32_t at = 0; at < count; ++at)
                add(m_node[lane], first + at);
        });
    }

    /// Others: one after the other by the whole warp.
    SUFFUSE_PROGRAM void addEachByAll(const GradientSegment &s, std::uint32_t from)
    {
        m_warp.each([&](int lane) { m_node[lane] = {}; });
        SUFFUSE_ROLLED
        for (std::uint32_t i = from; i < s.endNode && i < from + warpLanes; ++i) {
            Var<NodeTotals> part;
            m_warp.each([&](int lane) {
                part[lane] = {};
                const GradientNode &node = m_work.nodes[i];
                const std::uint32_t count = std::uint32_t(node.tilesX) * std::uint32_t(node.tilesY);
                for (std::uint32_t at = std::uint32_t(lane); at < count; at += warpLanes)
                    add(part[lane], node.entry + at);
            });
            SUFFUSE_UNROLL
            for (int j = 0; j < numbers; ++j) {
                Var<double> one;
                m_warp.each([&](int lane) { one[lane] = part[lane].v[j]; });
                const double sum = m_warp.sum(one);
                m_warp.each([&](int lane) {
                    if (lane == int(i - from))
                        m_node[lane].v[j] = sum;
                });
            }
        }
    }

    /// From a node's weight, place and spread to the control points, φˢ and s.
    SUFFUSE_PROGRAM void chain(const GradientSegment &s, std::uint32_t from)
    {
        const GradientCurve curve(s, m_work.view);
        const double scale = gradientWeightScale(s, m_work.view), spread = s.spread * m_work.view.scale;
        m_warp.each([&](int lane) {
            const std::uint32_t i = from + std::uint32_t(lane);
            if (i >= s.endNode)
                return;
            const GradientRule &rule = m_work.rules[i];
            const NodeTotals &by = m_node[lane];
            double(&out)[outputs] = m_all[lane].v;
            const GradientVector slope = curve.sum(rule.slope);
            const double speed = sqrt(slope.x * slope.x + slope.y * slope.y), perSpeed = scale * rule.weight;
            const double bySpeed = speed > 0 ? by.v[0] * s.density * perSpeed / speed : 0;
            for (int j = 0; j < 4; ++j) {
                out[j] += by.v[1] * rule.point[j] + bySpeed * slope.x * rule.slope[j];
                out[4 + j] += by.v[2] * rule.point[j] + bySpeed * slope.y * rule.slope[j];
            }
            out[8] += by.v[0] * perSpeed * speed;
            out[9] += by.v[3] - 2 * by.v[0] * s.density * perSpeed * speed / spread;
            for (int j = 0; j < gradientValues; ++j)
                out[10 + j] += by.v[7 + j];
            for (int j = 0; j < 3; ++j)
                out[10 + gradientValues + j] += by.v[4 + j];
        });
    }

    SUFFUSE_PROGRAM void write()
    {
        Outputs sums;
        SUFFUSE_UNROLL
        for (int j = 0; j < outputs; ++j) {
            Var<double> one;
            m_warp.each([&](int lane) { one[lane] = m_all[lane].v[j]; });
            sums.v[j] = m_warp.sum(one);
        }
        const GradientView &view = m_work.view;
        m_warp.each([&](int lane) {
            if (lane > 0)
                return;
            GradientSums &out = m_work.sums[m_segment];
            for (int j = 0; j < 4; ++j) {
                out.x[j] = view.xx * sums.v[j] + view.yx * sums.v[4 + j];
                out.y[j] = view.xy * sums.v[j] + view.yy * sums.v[4 + j];
            }
            out.density = sums.v[8], out.spread = sums.v[9] * view.scale;
            for (int j = 0; j < gradientValues; ++j)
                out.value[j] = sums.v[10 + j];
            for (int j = 0; j < 3; ++j)
                out.xi[j] = sums.v[10 + gradientValues + j];
        });
    }

    Warp &m_warp;
    const GradientWork &m_work;
    std::uint32_t m_segment;
    Var<NodeTotals> m_node; ///< of 32 nodes
    Var<Outputs> m_all;
};

} // namespace suffuse::cuda
