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

SUFFUSE_PROGRAM std::uint32_t strokeIndexOf(const ListEntry &entry)
{
    return entry.strokeAndNodes / 64;
}
SUFFUSE_PROGRAM std::uint32_t nodesOf(const ListEntry &entry)
{
    return entry.strokeAndNodes % 64;
}

/// A chunk's nodes and its stroke, as they come from memory: the nodes' parts of 16 bytes one after another, so that
/// lanes meet no bank twice.
struct Fetched {
    Float4 nodes[sizeof(NodeRecord) / sizeof(Float4)][chunkNodes];
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
};

/// What a lane copies of a stroke's record.
template <class Start>
SUFFUSE_PROGRAM void fetchStroke(const Frame &frame, std::uint32_t stroke, int lane, Start start, Float4 *to)
{
    static_assert(sizeof(Float4) == fetchBytes && sizeof(StrokeRecord) <= warpLanes * fetchBytes);
    if (lane < int(sizeof(StrokeRecord) / fetchBytes))
        start(to + lane, reinterpret_cast<const Float4 *>(frame.strokes + stroke) + lane);
}

template <class Warp>
SUFFUSE_PROGRAM void fetchChunk(Warp &warp, const Frame &frame, const ChunkRecord &chunk, Fetched &to)
{
    warp.fetch([&](int lane, auto start) {
        fetchStroke(frame, chunk.stroke, lane, start, to.stroke);
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

/// A node seen from the centre of a tile, px.
struct NodePlace {
    float dx, dy;

    SUFFUSE_PROGRAM NodePlace(const NodeRecord &n, std::int32_t cellX, std::int32_t cellY)
    {
        constexpr float half = tileSide / 2;
        dx = float((n.cellX - cellX) * tileSide) + (n.x - half);
        dy = float((n.cellY - cellY) * tileSide) + (n.y - half);
    }

    /// Conservative: where false, the node adds exactly nothing.
    SUFFUSE_PROGRAM bool meetsTile(float reachX, float reachY) const
    {
        return outside(dx) <= reachX && outside(dy) <= reachY;
    }
    /// Distance from the tile's edge along an axis, below 0 inside.
    static SUFFUSE_PROGRAM float outside(float d)
    {
        constexpr float half = tileSide / 2, margin = 0.05f; // places in floats are off by less
        return math::abs_(d) - (half + margin);
    }
};

} // namespace suffuse::cuda
