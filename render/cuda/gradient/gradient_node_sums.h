// Sums over nodes at the pixels of a tile, and the way back from derivatives by these sums to those by the nodes.
#pragma once

#include "render/cuda/gradient/gradient_near.h"

namespace suffuse::cuda {

/// φ, −½∂φ/∂x, −½∂φ/∂y at a lane's pixels.
struct LaneSums {
    float v[3][lanePixels];
};
/// Σφ_k·value and φ⁺ there.
struct LanePlanes {
    float v[valuePlanes][lanePixels];
};
/// Derivatives by a node's weight, place and spread.
struct NodeBack {
    float weight, x, y, spread;
};

template <class Warp, bool varies>
class GradientNodeSums {
public:
    using Place = GradientPlace<Warp, varies>;
    using Scratch = typename Place::Scratch;
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM explicit GradientNodeSums(Place &place)
        : m_place(place), m_warp(place.warp), m_scratch(place.scratch)
    {}

    /// Adds nodes of a kind to sums; with `planes` also to what varies.
    template <bool withPlanes>
    SUFFUSE_PROGRAM void add(std::uint32_t first, std::uint32_t end, NearKind kind, Var<LaneSums> &sums,
                             Var<LanePlanes> *planes)
    {
        for (std::uint32_t from = first; from < end; from += warpLanes) {
            const int count = m_place.gather(from, end, kind);
            SUFFUSE_ROLLED
            for (int at = 0; at < count; at += Scratch::batch) {
                const int n = count - at < Scratch::batch ? count - at : Scratch::batch;
                fillTables(at, n);
                m_warp.each([&](int lane) {
                    for (int i = 0; i < n; ++i) {
                        addNode(lane, i, sums[lane]);
                        if (withPlanes)
                            addToPlanes(lane, i, m_scratch.nodes[at + i].segment, (*planes)[lane]);
                    }
                });
            }
        }
    }

    /// Writes the derivatives by nodes [at, at + n) of the scratch memory, n ≤ 8, to their entries. `g`: derivatives by
    /// φ at the pixels.
    SUFFUSE_PROGRAM void back(int at, int n, const float *g)
    {
        fillRows(at, n);
        Var<float> weight, x, y, spread;
        m_warp.each([&](int lane) {
            const NodeBack by = backAt(lane, at + nodeOf(lane, n), g);
            weight[lane] = by.weight, x[lane] = by.x, y[lane] = by.y, spread[lane] = by.spread;
        });
        m_warp.sumFours(weight);
        m_warp.sumFours(x);
        m_warp.sumFours(y);
        m_warp.sumFours(spread);
        m_warp.each([&](int lane) {
            if (lane % lanesOfNode != 0 || lane / lanesOfNode >= n)
                return;
            const NearNode &node = m_scratch.nodes[at + lane / lanesOfNode];
            Warp::writeFour(m_place.work.entries[node.entry].v,
                            {weight[lane], node.weight * x[lane], node.weight * y[lane], node.weight * spread[lane]});
        });
    }

private:
    static constexpr int lanesOfNode = 4; // each of which has four columns
    static_assert(warpLanes / lanesOfNode == Scratch::batch);

    /// The node of a lane, or the last one where there is none for it.
    static SUFFUSE_PROGRAM int nodeOf(int lane, int n) { return lane / lanesOfNode < n ? lane / lanesOfNode : n - 1; }

    static SUFFUSE_PROGRAM float gaussian(float u, float cut)
    {
        const float e = math::exp2_(float(-math::log2e) * u * u);
        return cut < e ? e : 0;
    }

    /// Half of the lanes fill the tables along x, half of them those along y.
    SUFFUSE_PROGRAM void fillTables(int at, int n)
    {
        m_warp.each([&](int lane) {
            const int axis = lane / gradientSide, place = lane % gradientSide;
            const int to = axis ? placeOfRow(place) : place;
            for (int i = 0; i < n; ++i) {
                const NearNode &node = m_scratch.nodes[at + i];
                const float u = (float(place) - (axis ? node.y : node.x)) * node.inverse;
                const float e = gaussian(u, node.cut), scale = axis ? node.weight : 1.0f;
                m_scratch.inside[i][axis][to] = math::max_(e - node.cut, 0.0f) * scale;
                m_scratch.once[i][axis][to] = u * e * (node.inverse * scale);
            }
        });
    }

    SUFFUSE_PROGRAM void addNode(int lane, int i, LaneSums &sums)
    {
        const Two c = Warp::readTwo(m_scratch.inside[i][0] + 2 * (lane % 8)),
                  cs = Warp::readTwo(m_scratch.once[i][0] + 2 * (lane % 8));
        const Four r = Warp::readFour(m_scratch.inside[i][1] + 4 * (lane / 8));
        const Four rs = Warp::readFour(m_scratch.once[i][1] + 4 * (lane / 8));
        const float row[4] = {r.x, r.y, r.z, r.w}, rowSlope[4] = {rs.x, rs.y, rs.z, rs.w};
        const float column[2] = {c.x, c.y}, columnSlope[2] = {cs.x, cs.y};
        SUFFUSE_UNROLL
        for (int p = 0; p < lanePixels; ++p) {
            sums.v[0][p] = math::mulAdd_(column[p % 2], row[p / 2], sums.v[0][p]);
            sums.v[1][p] = math::mulAdd_(columnSlope[p % 2], row[p / 2], sums.v[1][p]);
            sums.v[2][p] = math::mulAdd_(column[p % 2], rowSlope[p / 2], sums.v[2][p]);
        }
    }

    SUFFUSE_PROGRAM void addToPlanes(int lane, int i, std::uint32_t segment, LanePlanes &planes)
    {
        const GradientSegment &s = m_place.work.segments[segment];
        if (s.lift)
            return;
        SUFFUSE_UNROLL
        for (int p = 0; p < lanePixels; ++p) {
            const float density =
                m_scratch.inside[i][0][2 * (lane % 8) + p % 2] * m_scratch.inside[i][1][4 * (lane / 8) + p / 2];
            for (int j = 0; j < gradientValues; ++j)
                planes.v[j][p] = math::mulAdd_(density, s.value[j], planes.v[j][p]);
            planes.v[gradientValues][p] += density;
        }
    }

    SUFFUSE_PROGRAM void fillRows(int at, int n)
    {
        m_warp.each([&](int lane) {
            const int slot = lane / lanesOfNode, part = lane % lanesOfNode * 4;
            const NearNode &node = m_scratch.nodes[at + nodeOf(lane, n)];
            const auto e = [&](int y) { return gaussian((float(y) - node.y) * node.inverse, node.cut); };
            Warp::writeFour(m_scratch.rows[slot] + part, {e(part), e(part + 1), e(part + 2), e(part + 3)});
        });
    }

    /// Sums over y, of which those that the same function of x multiplies are one, at four columns.
    struct Columns {
        float a[4], c[4], d[4], e[4], f1[4], f2[4];
    };

    /// The sums of one lane, over its four columns.
    SUFFUSE_PROGRAM NodeBack backAt(int lane, int i, const float *g)
    {
        const NearNode &node = m_scratch.nodes[i];
        const float *rows = m_scratch.rows[lane / lanesOfNode];
        const float nodeX = node.x, nodeY = node.y, inverse = node.inverse, cut = node.cut;
        const int left = lane % lanesOfNode * 4;
        Columns s = {};
        SUFFUSE_ROLLED
        for (int y = 0; y < gradientSide; y += 4) {
            const Four e = Warp::readFour(rows + y);
            const float es[4] = {e.x, e.y, e.z, e.w};
            SUFFUSE_UNROLL
            for (int j = 0; j < 4; ++j)
                addRow((float(y + j) - nodeY) * inverse, es[j], inverse, cut, g, (y + j) * gradientSide + left, s);
        }
        NodeBack out = {0, 0, 0, 0};
        SUFFUSE_UNROLL
        for (int x = 0; x < 4; ++x)
            addColumn((float(left + x) - nodeX) * inverse, inverse, cut, s, x, out);
        return out;
    }

    SUFFUSE_PROGRAM void addRow(float u, float e, float inverse, float cut, const float *g, int at, Columns &s)
    {
        const float ue = u * e, square = u * ue, inside = math::max_(e - cut, 0.0f), inverse2 = inverse * inverse;
        const float once = ue * inverse, twice = square * inverse;
        const float slope = math::mulAdd_(-0.5f, e, square) * inverse2, bySpread = u * (square - e) * inverse2;
        const Four b0 = Warp::readFour(g + at), b1 = Warp::readFour(m_scratch.sums[1] + at);
        const Four b2 = Warp::readFour(m_scratch.sums[2] + at);
        const float g0[4] = {b0.x, b0.y, b0.z, b0.w}, gx[4] = {b1.x, b1.y, b1.z, b1.w},
                    gy[4] = {b2.x, b2.y, b2.z, b2.w};
        SUFFUSE_UNROLL
        for (int x = 0; x < 4; ++x) {
            s.a[x] = math::mulAdd_(g0[x], inside, math::mulAdd_(gy[x], once, s.a[x]));
            s.c[x] = math::mulAdd_(g0[x], once, math::mulAdd_(gy[x], slope, s.c[x]));
            s.d[x] = math::mulAdd_(g0[x], twice, math::mulAdd_(gy[x], bySpread, s.d[x]));
            s.e[x] = math::mulAdd_(gx[x], inside, s.e[x]);
            s.f1[x] = math::mulAdd_(gx[x], once, s.f1[x]);
            s.f2[x] = math::mulAdd_(gx[x], twice, s.f2[x]);
        }
    }

    static SUFFUSE_PROGRAM void addColumn(float u, float inverse, float cut, const Columns &s, int x, NodeBack &out)
    {
        const float e = gaussian(u, cut), inside = math::max_(e - cut, 0.0f), ue = u * e, square = u * ue;
        const float twice = 2 * inverse, inverse2 = inverse * inverse, perSpread = ue * twice;
        const float slope = math::mulAdd_(-2.0f, square, e), bySpread = 2 * u * (square - e);
        out.weight = math::mulAdd_(inside, s.a[x], math::mulAdd_(ue * inverse, s.e[x], out.weight));
        out.x = math::mulAdd_(perSpread, s.a[x], math::negMulAdd_(slope * inverse2, s.e[x], out.x));
        out.y = math::mulAdd_(2 * inside, s.c[x], math::mulAdd_(perSpread, s.f1[x], out.y));
        out.spread = math::mulAdd_(square * twice, s.a[x], math::mulAdd_(2 * inside, s.d[x], out.spread));
        out.spread = math::mulAdd_(bySpread * inverse2, s.e[x], math::mulAdd_(perSpread, s.f2[x], out.spread));
    }

    Place &m_place;
    Warp &m_warp;
    Scratch &m_scratch;
};

} // namespace suffuse::cuda
