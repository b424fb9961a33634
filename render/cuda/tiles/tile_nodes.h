// Nodes are copied from memory here, and placed as a tile sees them.
#pragma once

#include "render/cuda/tiles/records.h"
#include "render/cuda/warp.h"
#include "render/math/scalar.h"
// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/shade.h"

namespace suffuse::cuda {

/// Holds four numbers, or any 16 bytes of a record.
struct alignas(16) [[gnu::may_alias]] Float4 {
    float x, y, z, w;
};
struct alignas(8) [[gnu::may_alias]] Float2 {
    float x, y;
};

SUFFUSE_PROGRAM std::uint32_t strokeIndexOf(const ListEntry &entry)
{
    return entry.strokeAndNodes / 128;
}
SUFFUSE_PROGRAM std::uint32_t nodesOf(const ListEntry &entry)
{
    return entry.strokeAndNodes % 128;
}

/// Holds a chunk's nodes and its stroke, as they come from memory. The parts of 16 bytes of all nodes lie one after
/// another, so that no two lanes need the same bank at once (warp.h).
struct Fetched {
    Float4 nodes[sizeof(NodeRecord) / sizeof(Float4)][chunkNodes];
    Float4 stroke[sizeof(StrokeRecord) / sizeof(Float4)];
};

/// Starts the copy of a lane's part of a stroke's record.
template <class Start>
SUFFUSE_PROGRAM void fetchStroke(const Frame &frame, std::uint32_t stroke, int lane, Start start, Float4 *to)
{
    static_assert(sizeof(Float4) == fetchBytes && sizeof(StrokeRecord) <= warpLanes * fetchBytes);
    if (lane < int(sizeof(StrokeRecord) / fetchBytes))
        start(to + lane, reinterpret_cast<const Float4 *>(frame.strokes + stroke) + lane);
}

template <class Warp>
SUFFUSE_PROGRAM void fetchChunk(Warp &warp, const Frame &frame, const ChunkRecord &chunk, Fetched &to,
                                bool withStroke = true)
{
    warp.fetch([&](int lane, auto start) {
        if (withStroke)
            fetchStroke(frame, chunk.stroke, lane, start, to.stroke);
        if (std::uint32_t(lane) >= (chunk.nodes & chunkCountBits))
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

/// The same for a chunk of a fill.
SUFFUSE_PROGRAM FillRecord fillRecordOf(const Fetched &chunk, int n)
{
    FillRecord record;
    SUFFUSE_UNROLL
    for (int part = 0; part < int(sizeof(FillRecord) / fetchBytes); ++part)
        reinterpret_cast<Float4 *>(&record)[part] = chunk.nodes[part][n];
    return record;
}

/// Returns the record of a stroke that has arrived.
SUFFUSE_PROGRAM const StrokeRecord &strokeOf(const Float4 *arrived)
{
    return *static_cast<const StrokeRecord *>(static_cast<const void *>(arrived));
}

/// Tells whether a tile shows pixels of a chunk's bounds.
SUFFUSE_PROGRAM bool meetsTile(const ChunkRecord &c, std::int32_t cellX, std::int32_t cellY)
{
    const std::int32_t left = cellX * tileSide, top = cellY * tileSide;
    return c.left < left + tileSide && left < c.right && c.top < top + tileSide && top < c.bottom;
}

/// Says where a node lies seen from the centre of a tile, in px.
struct NodePlace {
    float dx, dy;

    SUFFUSE_PROGRAM NodePlace(const NodeRecord &n, std::int32_t cellX, std::int32_t cellY)
    {
        constexpr float half = tileSide / 2;
        dx = float((n.cellX - cellX) * tileSide) + (n.x - half);
        dy = float((n.cellY - cellY) * tileSide) + (n.y - half);
    }

    /// Is false only if the node adds exactly nothing to the tile.
    SUFFUSE_PROGRAM bool meetsTile(float reachX, float reachY) const
    {
        return outside(dx) <= reachX && outside(dy) <= reachY;
    }
    /// The same for a block of samples of the tile around (x, y), from the tile's centre, that is step times as wide.
    SUFFUSE_PROGRAM bool meets(float x, float y, float step, float reachX, float reachY) const
    {
        constexpr float half = tileSide / 2, margin = 0.05f;
        const float side = half * step + margin;
        return math::abs_(dx - x) - side <= reachX && math::abs_(dy - y) - side <= reachY;
    }
    /// Returns the distance from the tile's edge along an axis, which is below 0 inside.
    static SUFFUSE_PROGRAM float outside(float d)
    {
        constexpr float half = tileSide / 2, margin = 0.05f; // Places in floats are off by less.
        return math::abs_(d) - (half + margin);
    }
};

} // namespace suffuse::cuda
