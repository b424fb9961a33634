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
SUFFUSE_CALL BackdropPixel putPixel(const LayerRecord &layer, float opacity, const BackdropPixel above,
                                    const BackdropPixel below)
{
    LayerPut how;
    how.mode = BlendMode(layer.mode), how.opacity = layer.opacity, how.opaque = layer.opaque != 0;
    for (int c = 0; c < 3; ++c)
        how.bare[c] = layer.bare[c];
    const math::Pixel<float> out =
        math::put(how, opacity, math::Pixel<float>{above.red, above.yellow, above.blue, above.coverage},
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
        : m_warp(warp), m_frame(frame), m_planes(frame.layerPixels + std::size_t(index) * frame.layerPlanes * tileSize),
          m_bounds(frame.boundPixels ? frame.boundPixels + std::size_t(index) * frame.layerPlanes * tileSize : nullptr)
    {}

    /// Begins with the canvas.
    SUFFUSE_PROGRAM void begin() { clearBounds(0); }
    /// Adds the opacity of a sample of a stroke to the coverage of the base of which it is a part.
    SUFFUSE_PROGRAM void addPart(int lane, int k, std::uint32_t stroke, float w)
    {
        const std::int32_t part = m_frame.shapeOf[stroke];
        if (part != none)
            addTo(m_bounds[std::size_t(depthOf(m_layer)) * tileSize + std::size_t(sampleAt(lane, k))], part,
                  BlendMode::Normal, w);
    }

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
        clearBounds(depthOf(layer));
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
                const float opacity = m_bounds ? bounded(layer, above[at].coverage, at) : layer.opacity;
                if (!layer.isMask)
                    below[at] = putPixel(layer, opacity, above[at], below[at]);
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

    SUFFUSE_PROGRAM void clearBounds(int plane)
    {
        if (!m_bounds)
            return;
        m_warp.each([&](int lane) {
            SUFFUSE_UNROLL
            for (int k = 0; k < laneSamples; ++k)
                m_bounds[std::size_t(plane) * tileSize + std::size_t(sampleAt(lane, k))] = {0, 1, none, 0};
        });
    }
    SUFFUSE_PROGRAM static void addTo(BoundPixel &bound, std::int32_t part, BlendMode mode, float coverage)
    {
        bound.shape = math::coverageWith(mode, coverage, bound.base == part ? bound.shape : 0);
        bound.base = part;
    }

    /// The opacity with which a layer that ends is put at a sample, where it has a coverage: its own, times the
    /// coverage of what it is clipped to, and that of its masks. What did not come to the tile has coverage 0. Then its
    /// own counts for what is bounded by it.
    SUFFUSE_PROGRAM float bounded(const LayerRecord &layer, float coverage, int at)
    {
        const BoundPixel own = m_bounds[std::size_t(layer.depth) * tileSize + std::size_t(at)];
        BoundPixel &around = m_bounds[std::size_t(layer.depth - 1) * tileSize + std::size_t(at)];
        float opacity = layer.opacity;
        if (layer.clippedTo != none)
            opacity *= around.base == layer.clippedTo ? around.shape : 0;
        if (layer.masks > 0)
            opacity *= own.masks == layer.masks ? own.mask : 0;
        if (layer.isMask)
            around.mask *= coverage * opacity, ++around.masks;
        else if (layer.shape != none)
            addTo(around, layer.shape, BlendMode(layer.shapeMode), coverage * opacity);
        return opacity;
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
    BoundPixel *m_bounds; ///< null if nothing is clipped or masked
    std::int32_t m_layer = none;
    std::uint32_t m_everywhere = 0; ///< how many of those that act everywhere have begun
};

} // namespace suffuse::cuda
