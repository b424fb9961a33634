// Which nodes a tile of the gradient sees, and the memory of the warp that draws it.
#pragma once

#include "render/cuda/gradient/gradient_curve.h"
#include "render/math/paint_slopes.h"
#include "render/math/scalar.h"
#include "render/math/shade_params.h"

namespace suffuse::cuda {

/// A node as a tile sees it: its place counts from the centre of the tile's first pixel.
struct alignas(16) NearNode {
    float x, y, inverse, weight, cut;
    std::uint32_t segment;
    std::uint32_t entry; ///< this tile's
    std::uint32_t padding;
};

/// Which of a stroke's nodes are looked for: all of one that does not fade, those of paint, or those that make it
/// paler.
enum class NearKind { All, Paint, Fading };

/// What a warp has in its block's fast memory. With `varies`, values may vary along strokes, and strokes may fade.
template <bool varies>
struct GradientScratch {
    static constexpr int batch = 8;                    ///< so many nodes have tables at once
    static constexpr int rowStride = gradientSide + 4; ///< Eight rows of so many numbers lie in different banks.

    NearNode nodes[warpLanes];
    /// Of e_x and e_y, less what is cut off, and u e/s; those along y times the weight, and in the order of
    /// `placeOfRow`.
    alignas(16) float inside[batch][2][gradientSide], once[batch][2][gradientSide];
    alignas(16) float rows[batch][rowStride];   ///< e_y on the way back
    alignas(16) float sums[3][gradientSize];    ///< of a stroke; on the way back, the derivatives by them
    alignas(16) float colours[3][gradientSize]; ///< R, Y, B; on the way back, the derivatives by them
    alignas(16) float planes[varies ? valuePlanes : 1][varies ? gradientSize : 4];
    alignas(16) float own[varies ? gradientSize : 4];  ///< derivatives by the density of one segment
    alignas(16) float left[varies ? gradientSize : 4]; ///< e^(−φ_f); on the way back, derivatives by φ_f
};

/// A lane has two pixels side by side in each of four rows.
inline constexpr int lanePairs = 4, lanePixels = 2 * lanePairs;
SUFFUSE_PROGRAM int pairOf(int lane, int i)
{
    return (lane / 8 + 4 * i) * gradientSide + 2 * (lane % 8);
}
/// Where tables have row y, so that the four rows of a lane lie side by side.
SUFFUSE_PROGRAM int placeOfRow(int y)
{
    return (y % 4) * 4 + y / 4;
}

/// A tile, and what a warp needs to work on it.
template <class Warp, bool varies>
class GradientPlace {
public:
    using Scratch = GradientScratch<varies>;
    template <class T>
    using Var = typename Warp::template Var<T>;

    SUFFUSE_PROGRAM GradientPlace(Warp &warp, const GradientWork &work, Scratch &scratch, int column, int row)
        : warp(warp), work(work), scratch(scratch), column(column), row(row)
    {}

    /// Whether the box of a stroke meets the tile.
    SUFFUSE_PROGRAM bool meets(const GradientBox &box) const
    {
        const float x = float(column * gradientSide) + 0.5f, y = float(row * gradientSide) + 0.5f;
        return box.left <= x + (gradientSide - 1) && box.right >= x && box.top <= y + (gradientSide - 1) &&
               box.bottom >= y;
    }

    /// Returns whether a stroke may show in the tile.
    SUFFUSE_PROGRAM bool mayShow(const GradientStroke &stroke, float level)
    {
        Var<float> density, slope;
        warp.each([&](int lane) {
            density[lane] = slope[lane] = 0;
            for (std::uint32_t i = stroke.firstNode + std::uint32_t(lane); i < stroke.endNode; i += warpLanes)
                if (isOf(work.nodes[i], paintOf(stroke)))
                    addBounds(work.nodes[i], density[lane], slope[lane]);
        });
        const float most = warp.sum(density), steepest = warp.sum(slope);
        return !vanishes(stroke.kind, level, most * 1.001f, 0.5f * steepest * 1.001f);
    }

    static SUFFUSE_PROGRAM NearKind paintOf(const GradientStroke &stroke)
    {
        return varies && stroke.fades ? NearKind::Paint : NearKind::All;
    }

    /// Writes those of the nodes [from, from + 32), as far as `end`, that reach the tile to the scratch memory. Returns
    /// how many they are.
    SUFFUSE_PROGRAM int gather(std::uint32_t from, std::uint32_t end, NearKind kind)
    {
        Var<NearNode> node;
        Var<int> isNear;
        warp.each([&](int lane) {
            const std::uint32_t i = from + std::uint32_t(lane);
            isNear[lane] = i < end && isOf(work.nodes[i], kind) && take(work.nodes[i], node[lane]);
        });
        const std::uint32_t mask = warp.ballot([&](int lane) { return isNear[lane] != 0; });
        warp.each([&](int lane) {
            if (isNear[lane])
                scratch.nodes[Warp::rank(mask, lane)] = node[lane];
        });
        return Warp::count(mask);
    }

    Warp &warp;
    const GradientWork &work;
    Scratch &scratch;
    int column, row;

private:
    /// The distance of a place from the pixels of the tile along an axis.
    static SUFFUSE_PROGRAM float beyond(float place)
    {
        constexpr float half = 0.5f * (gradientSide - 1);
        return math::max_(math::abs_(place - half) - half, 0.0f);
    }
    SUFFUSE_PROGRAM bool isOf(const GradientNode &node, NearKind kind) const
    {
        return kind == NearKind::All || (work.segments[node.segment].fade != 0) == (kind == NearKind::Fading);
    }
    SUFFUSE_PROGRAM bool isListed(const GradientNode &node) const
    {
        const int x = column - node.tileX, y = row - node.tileY;
        return x >= 0 && x < node.tilesX && y >= 0 && y < node.tilesY;
    }
    SUFFUSE_PROGRAM float along(double place, int tile) const
    {
        return float(place - (double(tile * gradientSide) + 0.5));
    }

    /// The square of the distance of a node from the tile's pixels, or a negative number if it does not reach them.
    SUFFUSE_PROGRAM float distance(const GradientNode &node, float x, float y) const
    {
        const float dx = beyond(x), dy = beyond(y), square = dx * dx + dy * dy, reach = node.reach + 1e-3f;
        return isListed(node) && square <= reach * reach ? square : -1;
    }
    SUFFUSE_PROGRAM void addBounds(const GradientNode &node, float &density, float &slope) const
    {
        const float square = distance(node, along(node.x, column), along(node.y, row));
        if (square < 0)
            return;
        const float u2 = square * node.inverse * node.inverse, e = math::exp2_(float(-math::log2e) * u2);
        if (node.weight > 0)
            density += node.weight * e;
        slope += math::abs_(node.weight) * node.inverse * (u2 < 0.5f ? 0.8578f : (1 + u2) * e);
    }
    SUFFUSE_PROGRAM bool take(const GradientNode &node, NearNode &out) const
    {
        out.x = along(node.x, column), out.y = along(node.y, row);
        out.inverse = node.inverse, out.weight = node.weight, out.cut = node.cut, out.segment = node.segment;
        out.entry = node.entry + std::uint32_t((row - node.tileY) * node.tilesX + column - node.tileX);
        return distance(node, out.x, out.y) >= 0;
    }
};

} // namespace suffuse::cuda
