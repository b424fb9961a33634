// A warp turns sums into what a stroke shows here, and mixes strokes.
#pragma once

#include "render/cuda/tiles/tile_sums.h"
#include "render/math/colour.h"

namespace suffuse::cuda {

/// Holds the picture at a lane's samples while strokes are mixed into it.
struct LaneBackdrop {
    float red[laneSamples], yellow[laneSamples], blue[laneSamples], coverage[laneSamples];
};

/// Calls `use` with one of the stroke's styles, which the host has made.
template <class Use>
SUFFUSE_PROGRAM void withMadeStyle(const StrokeRecord &stroke, int kind, Use use)
{
    const float *made = stroke.style[kind];
    switch (stroke.shade.kind[kind].kind) {
    case StyleKind::Uniform:
        return use(*reinterpret_cast<const math::Uniform<float> *>(made));
    case StyleKind::Feathering:
        return use(*reinterpret_cast<const math::Feathering<float> *>(made));
    case StyleKind::Edge:
        return use(*reinterpret_cast<const math::Edge<float> *>(made));
    }
}

/// Replaces φ′ by the pixel mean of F, found from φ′ and h², for a stroke of one style. Returns false if the stroke
/// shows nothing at any sample. Loops over samples are hardly unrolled, since the styles' code would not fit the
/// instruction cache otherwise.
template <class Warp>
SUFFUSE_PROGRAM bool meanOfStyle(Warp &warp, const StrokeRecord &stroke, MeanScratch &s)
{
    typename Warp::template Var<std::uint32_t> seen, isLong; // bit k of isLong is for sample k
    withMadeStyle(stroke, 0, [&](const auto style) {
        warp.each([&](int lane) {
            seen[lane] = isLong[lane] = 0;
            SUFFUSE_UNROLL_BY_2
            for (int k = 0; k < laneSamples; ++k) {
                const int at = sampleAt(lane, k);
                const float phi = s.density[at], h2 = s.h2[at], f = style.simpleMean(phi, h2);
                const bool isSeen = style.seen(phi, h2);
                const bool needsLong = isSeen && !style.simple(phi, h2);
                s.density[at] = needsLong ? phi : isSeen ? f : 0.0f;
                seen[lane] |= std::uint32_t(isSeen);
                isLong[lane] |= std::uint32_t(needsLong) << k;
            }
        });
    });
    if (!warp.any([&](int lane) { return seen[lane] != 0; }))
        return false;
    if (!warp.any([&](int lane) { return isLong[lane] != 0; }))
        return true;
    int longOnes = 0;
    SUFFUSE_ROLLED
    for (int k = 0; k < laneSamples; ++k) {
        const std::uint32_t mask = warp.ballot([&](int lane) { return (isLong[lane] >> k & 1) != 0; });
        warp.each([&](int lane) {
            if (mask >> lane & 1)
                s.longOnes[longOnes + Warp::rank(mask, lane)] = std::uint8_t(sampleAt(lane, k));
        });
        longOnes += Warp::count(mask);
    }
    withMadeStyle(stroke, 0, [&](const auto style) {
        SUFFUSE_ROLLED
        for (int from = 0; from < longOnes; from += warpLanes)
            warp.each([&](int lane) {
                if (from + lane < longOnes) {
                    const int at = s.longOnes[from + lane];
                    s.density[at] = style.longMean(s.density[at], math::sqrt_(s.h2[at]));
                }
            });
    });
    return true;
}

/// Puts one sample of a stroke on top of an over map: first into the planes of all colours, then into those of one (0
/// red, 1 yellow, 2 blue). `over` has the tile's planes.
SUFFUSE_PROGRAM void composeCoverage(float *over, int pixel, float w, float keep)
{
    const auto plane = [&](int p) -> float & { return over[p * tileSize + pixel]; };
    plane(0) *= math::negMulAdd_(w, keep, 1.0f);
    plane(7) *= 1 - w;
    plane(8) = math::mulAdd_(1 - w, plane(8), w);
}
SUFFUSE_PROGRAM void composeColour(float *over, int pixel, int component, float w, float colour, float keep)
{
    const float factor = math::negMulAdd_(w, keep, 1.0f);
    float &add = over[(1 + component) * tileSize + pixel], &limit = over[(4 + component) * tileSize + pixel];
    add = math::mulAdd_(factor, add, w * colour);
    limit = math::min_(1.0f, math::mulAdd_(factor, limit, w * colour));
}

/// The same for one component, where 3 is that of all colours.
SUFFUSE_PROGRAM void composeComponent(float *over, int pixel, int component, float w, float colour, float keep)
{
    if (component == 3)
        composeCoverage(over, pixel, w, keep);
    else
        composeColour(over, pixel, component, w, colour, keep);
}
/// The same for all of a sample of w and colour.
SUFFUSE_PROGRAM void composeSample(float *over, int pixel, const Float4 &sample, float keep)
{
    composeCoverage(over, pixel, sample.x, keep);
    composeColour(over, pixel, 0, sample.x, sample.y, keep);
    composeColour(over, pixel, 1, sample.x, sample.z, keep);
    composeColour(over, pixel, 2, sample.x, sample.w, keep);
}

SUFFUSE_PROGRAM void applySample(const float *over, int pixel, LaneBackdrop &b, int k)
{
    const auto plane = [&](int p) { return over[p * tileSize + pixel]; };
    float *colour[3] = {&b.red[k], &b.yellow[k], &b.blue[k]};
    SUFFUSE_UNROLL
    for (int c = 0; c < 3; ++c)
        *colour[c] = math::min_(plane(4 + c), math::mulAdd_(plane(0), *colour[c], plane(1 + c)));
    b.coverage[k] = math::mulAdd_(plane(7), b.coverage[k], plane(8));
}

/// Returns the straight RGBA of a finished sample, from RYB and coverage (1 if the picture is not transparent, or all
/// is covered).
SUFFUSE_PROGRAM Float4 finishSample(const Float4 &sample)
{
    const auto rgb = math::rgbFromRyb(sample.x, sample.y, sample.z);
    const float alpha = sample.w, covered = math::max_(alpha, 1e-30f);
    const auto uncover = [&](float v) {
        return alpha > 0 ? math::min_(1.0f, math::max_(0.0f, (v - (1 - alpha)) / covered)) : 0.0f;
    };
    if (alpha == 1)
        return {rgb.x, rgb.y, rgb.z, 1};
    return {uncover(rgb.x), uncover(rgb.y), uncover(rgb.z), alpha};
}

SUFFUSE_PROGRAM std::uint32_t argbOf(const Float4 &rgba)
{
    const auto level = [](float v) { return std::uint32_t(v * 255.0f + 0.5f); }; // as files are rounded
    return level(rgba.w) << 24 | level(rgba.x) << 16 | level(rgba.y) << 8 | level(rgba.z);
}

} // namespace suffuse::cuda
