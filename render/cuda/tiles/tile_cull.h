// A warp finds here in which tiles of half a macro-tile a stroke can show, and what it costs there.
#pragma once

#include "render/cuda/tiles/fill_region.h"

namespace suffuse::cuda {

/// Holds a node as culling sees it: its centre, from the corner of half a macro-tile, and its reach, px; the least
/// eigenvalue of the metric times −log₂ e, the weight if it lays paint, and |weight| times the root of the greatest
/// eigenvalue (as in render/scene/node_boxes.h).
struct CullNode {
    Float4 place; ///< x, y, reachX, reachY
    Float4 decay; ///< slowest, weight, steepest, nothing

    /// Tells whether it meets any tile of the half. If it meets none, it adds nothing to them.
    SUFFUSE_PROGRAM bool meetsHalf() const
    {
        constexpr float half = tileSide / 2, width = macroSide, height = macroSide / 2;
        const auto beyond = [](float d, float side) { return math::max_(half - d, d - (side - half)); };
        return NodePlace::outside(math::max_(beyond(place.x, width), 0.0f)) <= place.z &&
               NodePlace::outside(math::max_(beyond(place.y, height), 0.0f)) <= place.w;
    }
};

/// A warp that culls has this in shared memory.
struct CullScratch {
    union { // They are used one after the other.
        CullNode nodes[chunkNodes];
        FillEnds ends[chunkNodes];
    };
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
};

/// Holds what one warp has found of a stroke's nodes: for each tile of the half bounds of φ and |∇φ|, and how many meet
/// it.
template <bool fills>
struct CullPart {
    float density[listTiles], slope[listTiles];
    std::uint32_t met[listTiles];
    std::int32_t base[fills ? listTiles : 1]; ///< how often a fill is entered left of what meets the tile
};

SUFFUSE_PROGRAM CullNode cullNodeOf(const NodeRecord &n, std::int32_t cellX, std::int32_t cellY)
{
    const float middle = 0.5f * (n.a + n.c), half = 0.5f * (n.a - n.c);
    const float spread = n.b == 0 ? math::abs_(half) : math::sqrt_(math::mulAdd_(half, half, n.b * n.b));
    const float slowest = math::max_(0.9999f * (middle - spread), 0.0f), greatest = 1.0001f * (middle + spread);
    const float x = float((n.cellX - cellX) * tileSide) + n.x, y = float((n.cellY - cellY) * tileSide) + n.y;
    const float laid = math::max_(n.weight, 0.0f), steepest = math::abs_(n.weight) * math::sqrt_(greatest);
    return {{x, y, n.reachX, n.reachY}, {slowest * -float(math::log2e), laid, steepest, 0}};
}

/// Finds in which tiles of half a macro-tile one stroke may show. Each lane looks at one tile. If `fills`, it may have
/// a fill.
template <class Warp, bool fills>
class StrokeCull {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// The half's first tile lies in cell (cellX, cellY).
    SUFFUSE_PROGRAM StrokeCull(Warp &warp, const Frame &frame, std::uint32_t stroke, std::int32_t cellX,
                               std::int32_t cellY, CullScratch &scratch)
        : m_warp(warp), m_frame(frame), m_cellX(cellX), m_cellY(cellY), m_s(scratch)
    {
        m_warp.fetch([&](int lane, auto start) { fetchStroke(m_frame, stroke, lane, start, m_s.stroke); });
        m_warp.each([&](int lane) { m_density[lane] = m_slope[lane] = 0, m_met[lane] = 0; });
        if constexpr (fills)
            m_warp.each([&](int lane) { m_base[lane] = 0; });
    }

    /// Adds a chunk of the stroke. Bit i of the result says whether nodes of the chunk meet tile i.
    SUFFUSE_PROGRAM std::uint32_t add(const ListEntry &chunk)
    {
        const std::uint32_t listed = nodesOf(chunk);
        if (listed == 0) // Deep nodes lie everywhere.
            return m_warp.ballot(
                [&](int lane) { return meetsTile(m_frame.chunks[chunk.chunk], cellX(lane), cellY(lane)); });
        if (fills && (listed & fillChunk))
            return addFill(chunk, int(listed & chunkCountBits));
        Var<CullNode> node;
        const std::uint32_t near = m_warp.ballot([&](int lane) {
            if (std::uint32_t(lane) >= listed)
                return false;
            node[lane] = cullNodeOf(m_frame.nodes[chunk.firstNode + std::uint32_t(lane)], m_cellX, m_cellY);
            if (!m_frame.cull)
                node[lane].place.z = node[lane].place.w = 1e30f;
            return node[lane].meetsHalf();
        });
        m_warp.each([&](int lane) {
            if (near >> lane & 1)
                m_s.nodes[Warp::rank(near, lane)] = node[lane];
        });
        const int nodes = Warp::count(near);
        const std::uint32_t hits = m_warp.ballot([&](int lane) {
            constexpr float half = tileSide / 2;
            const float centreX = float(lane % macroTiles * tileSide) + half;
            const float centreY = float(lane / macroTiles * tileSide) + half;
            const std::uint32_t before = m_met[lane];
            SUFFUSE_UNROLL_BY_4
            for (int n = 0; n < nodes; ++n) {
                const Float4 place = m_s.nodes[n].place, decay = m_s.nodes[n].decay;
                const float outX = NodePlace::outside(place.x - centreX), outY = NodePlace::outside(place.y - centreY);
                const bool counts = outX <= place.z && outY <= place.w;
                // The nearest point of the tile is u spreads away. The density there is e^(−u²). Its slope 2u e^(−u²),
                // which is greatest at u² = ½, is at most (1 + u²) e^(−u²).
                const float ox = math::max_(outX, 0.0f), oy = math::max_(outY, 0.0f);
                const float log = counts ? math::mulAdd_(ox, ox, oy * oy) * decay.x : -1000.0f;
                const float e = math::exp2_(log);
                const float rise = math::min_(0.8578f, math::negMulAdd_(log * float(math::ln2), e, e));
                m_met[lane] += counts;
                m_density[lane] = math::mulAdd_(decay.y, e, m_density[lane]);
                m_slope[lane] = math::mulAdd_(decay.z, rise, m_slope[lane]);
            }
            return m_met[lane] != before;
        });
        m_warp.meet(); // The next chunk's nodes overwrite these.
        return hits;
    }

    /// Finds the tiles where the stroke may show. In the others F is exactly zero.
    SUFFUSE_PROGRAM std::uint32_t seen()
    {
        m_warp.arrive(false);
        const StrokeRecord &stroke = strokeOf(m_s.stroke);
        return m_warp.ballot([&](int lane) {
            if (fills && m_frame.cull && stroke.fill && !(stroke.fill & deepFill) && stroke.deep == 0 &&
                m_met[lane] == 0 && m_base[lane] == 0)
                return false; // The tile lies outside of the fill.
            const float fill = fills && m_base[lane] ? stroke.fillDensity : 0.0f;
            const float phi = (m_density[lane] + fill) * 1.001f, h = 0.5f * m_slope[lane] * 1.001f;
            if (!m_frame.cull || !stroke.hasLevels || phi > stroke.lowest)
                return true;
            for (int k = 0; k < stroke.shade.kinds; ++k)
                if (!vanishes(stroke.shade, k, stroke.level[k], phi, h))
                    return true;
            return false;
        });
    }

    /// Finds the tiles that nodes meet.
    SUFFUSE_PROGRAM std::uint32_t metTiles()
    {
        return m_warp.ballot([&](int lane) { return m_met[lane] != 0 || (fills && m_base[lane] != 0); });
    }
    /// Leaves what was found so far to another warp, which adds the parts of all warps.
    SUFFUSE_PROGRAM void give(CullPart<fills> &part)
    {
        m_warp.each([&](int lane) {
            part.density[lane] = m_density[lane], part.slope[lane] = m_slope[lane], part.met[lane] = m_met[lane];
            if (fills)
                part.base[lane] = m_base[lane];
        });
    }
    SUFFUSE_PROGRAM void take(const CullPart<fills> &part)
    {
        m_warp.each([&](int lane) {
            m_density[lane] += part.density[lane], m_slope[lane] += part.slope[lane], m_met[lane] += part.met[lane];
            if (fills)
                m_base[lane] += part.base[lane];
        });
    }

    SUFFUSE_PROGRAM const StrokeRecord &stroke() const { return strokeOf(m_s.stroke); }
    /// Finds at which tiles of the mask the stroke is evaluated apart. `general` are the tiles of the general kernel,
    /// and `weights` say what is known to be left to the tiles so far.
    SUFFUSE_PROGRAM std::uint32_t apart(std::uint32_t mask, std::uint32_t general, const std::uint32_t *weights)
    {
        const ApartLimits &limits = m_frame.apartLimits;
        return m_warp.ballot([&](int lane) {
            const bool isGeneral = general >> lane & 1;
            if (!(mask >> lane & 1) || (!stroke().plain && !isGeneral))
                return false;
            const std::uint32_t least = isGeneral ? limits.inGeneral : limits.from;
            return cost(lane) >= (fills && stroke().fill ? limits.ofFill : least) || weights[lane] >= limits.above;
        });
    }
    /// Finds the tiles of the mask where it costs so much that it is taken before others.
    SUFFUSE_PROGRAM std::uint32_t costly(std::uint32_t mask)
    {
        constexpr std::uint32_t much = 2500;
        return m_warp.ballot([&](int lane) { return (mask >> lane & 1) && cost(lane) >= much; });
    }
    /// Adds what the stroke costs to the weights of the tiles in the mask, in which it is evaluated apart from those in
    /// another one.
    SUFFUSE_PROGRAM void addWeights(std::uint32_t mask, std::uint32_t apart, std::uint32_t *weights)
    {
        m_warp.each([&](int lane) {
            if (mask >> lane & 1)
                Warp::add(weights + lane, apart >> lane & 1 ? mixWeight : cost(lane));
        });
    }

private:
    /// Adds a chunk of the stroke's fill.
    SUFFUSE_PROGRAM std::uint32_t addFill(const ListEntry &chunk, int records)
    {
        m_warp.arrive(false); // The fill's numbers are in the stroke's record.
        const StrokeRecord &stroke = strokeOf(m_s.stroke);
        const FillValues &values = m_frame.fills[stroke.fillValues];
        m_warp.each([&](int lane) {
            if (lane < records)
                m_s.ends[lane] = endsOf(readFillRecord(m_frame.nodes + chunk.firstNode + lane));
        });
        // Of a fill that is sampled finer than by tiles, parts of a tile must know of all that lies left of them.
        const bool crisp = (stroke.fill & crispFill) != 0, finer = crisp || (stroke.fill & thinFill) != 0;
        const std::uint32_t hits = m_warp.ballot([&](int lane) {
            const FillRegion region = fillRegion(values, cellX(lane), cellY(lane));
            std::uint32_t all = 0, cost = 0;
            std::int32_t base = 0;
            SUFFUSE_UNROLL_BY_2
            for (int n = 0; n < records; ++n) {
                const std::uint32_t use = useOf(m_s.ends[n], region);
                all |= use;
                cost += crisp ? ((use & metFill) ? crispCurveCost : 0) : (use & listedFill) ? fillNodeCost : 0;
                base += std::int32_t((use & enteredFill) != 0) - std::int32_t((use & leftFill) != 0);
            }
            const bool met = (all & metFill) != 0;
            m_base[lane] += base;
            m_met[lane] += cost + met;
            m_density[lane] += met ? stroke.fillDensity : 0.0f;
            m_slope[lane] += met ? stroke.fillSteepest : 0.0f;
            return met || base != 0 || (finer && (all & besideFill) != 0);
        });
        m_warp.meet(); // The next chunk's ends overwrite these.
        return hits;
    }

    static constexpr std::uint32_t fillNodeCost = 2;    ///< that of a fill's node, in nodes
    static constexpr std::uint32_t crispCurveCost = 32; ///< that of a panel of a crisp fill
    static constexpr std::uint32_t strokeWeight = 96;   ///< the cost of shading and mixing at a tile
    static constexpr std::uint32_t mixWeight = 16;      ///< that of mixing alone

    /// Returns what the stroke costs at a tile. What a node costs was measured; it depends on how often the nodes are
    /// summed.
    SUFFUSE_PROGRAM std::uint32_t cost(int lane) const
    {
        const ShadeParams &shade = stroke().shade;
        const std::uint32_t nodeWeight = shade.colourChannel >= 0 ? 17 : shade.lineChannel >= 0 ? 7 : 4;
        const std::uint32_t times = stroke().plain             ? 1
                                    : isSupersampled(stroke()) ? 6
                                                               : 2; // as often as blocks are evaluated
        return times * (strokeWeight + nodeWeight * m_met[lane]);
    }

    SUFFUSE_PROGRAM std::int32_t cellX(int lane) const { return m_cellX + lane % macroTiles; }
    SUFFUSE_PROGRAM std::int32_t cellY(int lane) const { return m_cellY + lane / macroTiles; }

    Warp &m_warp;
    const Frame &m_frame;
    std::int32_t m_cellX, m_cellY;
    CullScratch &m_s;
    Var<float> m_density, m_slope; ///< bounds of φ and |∇φ| (per pixel) in the lane's tile
    Var<std::uint32_t> m_met;      ///< nodes that meet the tile
    Var<std::int32_t> m_base;      ///< how often the stroke's fill is entered left of what meets the tile
};

} // namespace suffuse::cuda
