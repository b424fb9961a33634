// A warp goes through the layers of a tile's strokes here (render/composition): it lays aside what lies below a layer
// that begins, and puts the layer on it where it ends. What is laid aside stays in memory, since registers hold one
// picture alone.
#pragma once

#include "render/cuda/tiles/tile_shade.h"
#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"

namespace suffuse::cuda {

/// Puts a pixel of a layer on what lies below. It is called, not inlined, since its code is long.
SUFFUSE_CALL BackdropPixel putPixel(const LayerRecord &layer, const BackdropPixel above, const BackdropPixel below)
{
    LayerPut how;
    how.mode = BlendMode(layer.mode), how.opacity = layer.opacity, how.opaque = layer.opaque != 0;
    for (int c = 0; c < 3; ++c)
        how.bare[c] = layer.bare[c];
    const math::Pixel<float> out =
        math::put(how, math::Pixel<float>{above.red, above.yellow, above.blue, above.coverage},
                  math::Pixel<float>{below.red, below.yellow, below.blue, below.coverage});
    return {out.red, out.yellow, out.blue, out.coverage};
}

template <class Warp>
class TileComposition {
public:
    template <class T>
    using Var = typename Warp::template Var<T>;

    /// `index` is that of the tile job.
    SUFFUSE_PROGRAM TileComposition(Warp &warp, const Frame &frame, std::uint32_t index)
        : m_warp(warp), m_frame(frame), m_planes(frame.layerPixels + std::size_t(index) * frame.layerPlanes * tileSize)
    {}

    /// Goes on to a stroke, of which this chunk is one.
    SUFFUSE_PROGRAM void goTo(std::uint32_t stroke, std::uint32_t chunk, Var<LaneBackdrop> &backdrop)
    {
        passEverywhere(chunk, backdrop);
        to(m_frame.layerOf[stroke], backdrop);
    }
    /// Goes on to the end of all.
    SUFFUSE_PROGRAM void goToEnd(Var<LaneBackdrop> &backdrop)
    {
        passEverywhere(0xffffffff, backdrop);
        to(none, backdrop);
    }

private:
    static constexpr std::int32_t none = -1;

    SUFFUSE_PROGRAM int depthOf(std::int32_t layer) const { return layer == none ? 0 : m_frame.layers[layer].depth; }

    /// Visits the layers that act everywhere and begin up to this chunk.
    SUFFUSE_PROGRAM void passEverywhere(std::uint32_t chunk, Var<LaneBackdrop> &backdrop)
    {
        SUFFUSE_ROLLED
        for (; m_everywhere < m_frame.everywhereCount; ++m_everywhere) {
            const EverywhereRecord next = m_frame.everywhere[m_everywhere];
            if (next.firstChunk > chunk)
                break;
            to(next.layer, backdrop);
        }
    }

    /// Ends layers and begins others until `wanted` is the innermost one that is open.
    SUFFUSE_PROGRAM void to(std::int32_t wanted, Var<LaneBackdrop> &backdrop)
    {
        SUFFUSE_ROLLED
        while (m_layer != wanted) {
            // The layer around `wanted` that is as deep as the open one, and the one within it.
            std::int32_t around = wanted, within = none;
            const int depth = depthOf(m_layer);
            while (depthOf(around) > depth)
                within = around, around = m_frame.layers[around].parent;
            if (around == m_layer)
                begin(within, backdrop);
            else
                end(backdrop);
        }
    }

    SUFFUSE_PROGRAM void begin(std::int32_t layer, Var<LaneBackdrop> &backdrop)
    {
        store(depthOf(m_layer), backdrop);
        m_layer = layer;
        m_warp.each([&](int lane) { backdrop[lane] = {}; });
    }

    SUFFUSE_PROGRAM void end(Var<LaneBackdrop> &backdrop)
    {
        const LayerRecord &layer = m_frame.layers[m_layer];
        store(layer.depth, backdrop);
        BackdropPixel *above = m_planes + std::size_t(layer.depth) * tileSize, *below = above - tileSize;
        m_warp.each([&](int lane) {
            SUFFUSE_ROLLED
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k); // Each lane has samples of its own, so none waits for another.
                below[at] = putPixel(layer, above[at], below[at]);
            }
        });
        m_warp.each([&](int lane) {
            LaneBackdrop &b = backdrop[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k) {
                const BackdropPixel p = below[sampleAt(lane, k)];
                b.red[k] = p.red, b.yellow[k] = p.yellow, b.blue[k] = p.blue, b.coverage[k] = p.coverage;
            }
        });
        m_layer = layer.parent;
    }

    SUFFUSE_PROGRAM void store(int plane, const Var<LaneBackdrop> &backdrop)
    {
        BackdropPixel *pixels = m_planes + std::size_t(plane) * tileSize;
        m_warp.each([&](int lane) {
            const LaneBackdrop &b = backdrop[lane];
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k)
                pixels[sampleAt(lane, k)] = {b.red[k], b.yellow[k], b.blue[k], b.coverage[k]};
        });
    }

    Warp &m_warp;
    const Frame &m_frame;
    BackdropPixel *m_planes;
    std::int32_t m_layer = none;
    std::uint32_t m_everywhere = 0; ///< how many of those that act everywhere have begun
};

} // namespace suffuse::cuda
