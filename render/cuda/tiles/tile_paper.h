// This finds the paper texture at samples (16).
#pragma once

#include "render/cuda/tiles/tile_sums.h"
#include "render/math/paper.h"

namespace suffuse::cuda {

/// Converts pixels of the picture to canvas units.
SUFFUSE_PROGRAM void toCanvas(const Frame &frame, double X, double Y, double &x, double &y)
{
    const ToCanvas &m = frame.toCanvas;
    x = m.x0 + m.xx * X + m.xy * Y;
    y = m.y0 + m.yx * X + m.yy * Y;
}

/// Returns η of a sample at (X, Y) that is `step` wide, all in pixels.
SUFFUSE_CALL float etaAt(const Frame &frame, double X, double Y, float step)
{
    SUFFUSE_IS_LAUNCHED(frame);
    const PaperParams &p = frame.paper;
    double x, y;
    toCanvas(frame, X, Y, x, y);
    const double strength = double(p.strength);
    if (p.kind == 1)
        return float(math::proceduralPaper(x, y, double(step) * frame.toCanvas.px, p.grain, p.seed, p.scale, strength));
    return p.grey ? float(math::imagePaper(x, y, p.grey, p.width, p.height, p.scale, strength)) : 1.0f;
}

/// The η of one block of samples, of which the device keeps those that are asked for most (Frame::eta).
struct EtaPlane {
    float *kept = nullptr; ///< null: it is not kept
    std::uint32_t *known = nullptr;
};
/// Returns the place of a block's η. `plane` is 0 for a tile's pixels, 1 + quadrant for the samples of a quadrant,
/// below 0 for others.
SUFFUSE_PROGRAM EtaPlane etaPlane(const Frame &frame, int column, int row, int plane)
{
    if (plane < 0 || plane >= int(frame.etaPlanes))
        return {};
    const std::size_t columns = std::size_t(frame.width + tileSide - 1) / tileSide;
    const std::size_t at = (std::size_t(row) * columns + std::size_t(column)) * frame.etaPlanes + std::size_t(plane);
    return {frame.eta + at * tileSize, frame.etaKnown + at};
}

/// Leaves η at a block of samples of a tile in `eta`, in the order of `sampleAt`. Whoever needs a kept block first
/// evaluates it; several warps may do so at once, and find the same bits.
template <class Warp>
SUFFUSE_PROGRAM void findEta(Warp &warp, const Frame &frame, int column, int row, const Block &block, int plane,
                             float *eta)
{
    const EtaPlane place = etaPlane(frame, column, row, plane);
    if (place.kept && warp.any([&](int lane) { return lane == 0 && Warp::look(place.known) == frame.etaStamp; })) {
        const Float4 *kept = reinterpret_cast<const Float4 *>(place.kept);
        warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < tileSize / 4 / warpLanes; ++k)
                reinterpret_cast<Float4 *>(eta)[k * warpLanes + lane] =
                    Warp::readPublished(kept + k * warpLanes + lane);
        });
        return;
    }
    warp.each([&](int lane) {
        SUFFUSE_ROLLED
        for (int k = 0; k < laneSamples; ++k) {
            const double x = (double(sampleColumn(lane, k)) - 7.5) * double(block.step);
            const double y = (double(sampleRow(lane, k)) - 7.5) * double(block.step);
            eta[sampleAt(lane, k)] = etaAt(frame, column * tileSide + tileSide / 2 + double(block.x) + x,
                                           row * tileSide + tileSide / 2 + double(block.y) + y, block.step);
        }
    });
    if (!place.kept)
        return;
    warp.each([&](int lane) {
        SUFFUSE_UNROLL
        for (int k = 0; k < laneSamples; ++k)
            place.kept[k * warpLanes + lane] = eta[k * warpLanes + lane];
    });
    warp.publish(place.known, frame.etaStamp);
}

} // namespace suffuse::cuda
