// Nodes as they come from memory, and where they lie seen from a tile.
#pragma once

#include "render/cuda/records.h"
#include "render/cuda/warp.h"
#include "render/math/scalar.h"
// After the numbers: templates over them.
#include "render/math/shade.h"

namespace suffuse::cuda {

/// 16 bytes of any record, too.
struct alignas(16) [[gnu::may_alias]] Float4 {
    float x, y, z, w;
};
struct alignas(8) [[gnu::may_alias]] Float2 {
    float x, y;
};

/// A chunk's nodes and its stroke, as they come from memory: the nodes' parts of 16 bytes one after another, so that
/// lanes meet no bank twice.
struct Fetched {
    Float4 nodes[sizeof(NodeRecord) / sizeof(Float4)][chunkNodes];
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
};

template <class Warp>
SUFFUSE_PROGRAM void fetchChunk(Warp &warp, const Frame &frame, const ChunkRecord &chunk, Fetched &to)
{
    static_assert(sizeof(Float4) == fetchBytes);
    warp.fetch([&](int lane, auto start) {
        const auto *stroke = reinterpret_cast<const Float4 *>(frame.strokes + chunk.stroke);
        if (lane < int(sizeof(to.stroke) / fetchBytes))
            start(to.stroke + lane, stroke + lane);
        if (std::uint32_t(lane) >= chunk.nodes)
            return;
        const auto *node = reinterpret_cast<const Float4 *>(frame.nodes + chunk.firstNode + std::uint32_t(lane));
        SUFFUSE_UNROLL
        for (int part = 0; part < int(sizeof(NodeRecord) / fetchBytes); ++part)
            start(&to.nodes[part][lane], node + part);
    });
}

SUFFUSE_PROGRAM NodeRecord nodeOf(const Fetched &chunk, int n)
{
    NodeRecord node;
    SUFFUSE_UNROLL
    for (int part = 0; part < int(sizeof(NodeRecord) / fetchBytes); ++part)
        reinterpret_cast<Float4 *>(&node)[part] = chunk.nodes[part][n];
    return node;
}

/// The record of a stroke that has arrived.
SUFFUSE_PROGRAM const StrokeRecord &strokeOf(const Float4 *arrived)
{
    return *static_cast<const StrokeRecord *>(static_cast<const void *>(arrived));
}

/// Whether a tile shows pixels of a chunk's bounds.
SUFFUSE_PROGRAM bool meetsTile(const ChunkRecord &c, std::int32_t cellX, std::int32_t cellY)
{
    const std::int32_t left = cellX * tileSide, top = cellY * tileSide;
    return c.left < left + tileSide && left < c.right && c.top < top + tileSide && top < c.bottom;
}

/// Bounds of φ and |∇φ| (per pixel) in a tile, as Kernels::findRuns (render/cpu/kernels.h).
struct LaneBound {
    float density = 0, slope = 0;
};

/// A node seen from the centre of a tile, px.
struct NodePlace {
    float dx, dy, outX, outY; ///< centre; distance of the tile's edge, below 0 inside
    bool meets;               ///< conservative: where false, the node adds exactly nothing

    SUFFUSE_PROGRAM NodePlace(const NodeRecord &n, std::int32_t cellX, std::int32_t cellY)
    {
        constexpr float half = tileSide / 2, margin = 0.05f; // places in floats are off by less
        dx = float((n.cellX - cellX) * tileSide) + (n.x - half);
        dy = float((n.cellY - cellY) * tileSide) + (n.y - half);
        outX = math::abs_(dx) - (half + margin);
        outY = math::abs_(dy) - (half + margin);
        meets = outX <= n.reachX && outY <= n.reachY;
    }

    /// Distance u in spreads to the nearest point: e^(−u²), and 2u e^(−u²), which is greatest at u² = ½ and then at
    /// most (1 + u²) e^(−u²).
    SUFFUSE_PROGRAM void addTo(const NodeRecord &n, LaneBound &bound) const
    {
        const float ox = math::max_(outX, 0.0f), oy = math::max_(outY, 0.0f);
        // Eigenvalues of the metric.
        const float middle = 0.5f * (n.a + n.c), half = 0.5f * (n.a - n.c);
        const float spread = n.b == 0 ? math::abs_(half) : math::sqrt_(math::mulAdd_(half, half, n.b * n.b));
        const float slowest = math::max_(0.9999f * (middle - spread), 0.0f), greatest = 1.0001f * (middle + spread);
        const float u2 = math::mulAdd_(ox, ox, oy * oy) * slowest, e = math::exp2_(-float(math::log2e) * u2);
        bound.density += n.weight * e;
        bound.slope += n.weight * math::sqrt_(greatest) * (u2 < 0.5f ? 0.8578f : math::mulAdd_(u2, e, e));
    }
};

} // namespace suffuse::cuda
