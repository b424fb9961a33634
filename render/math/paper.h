// The paper texture η, docs/paper.md, at one point in double. render/cpu computes the same noise many samples at a time.
#pragma once

#include "render/math/compat.h"

#include <cmath>
#include <cstdint>

namespace suffuse::math {

SUFFUSE_INLINE std::uint32_t paperMix(std::uint32_t z)
{
    z ^= z >> 16;
    z *= 0x7FEB352Du;
    z ^= z >> 15;
    z *= 0x846CA68Bu;
    return z ^ (z >> 16);
}

/// Without the library's calls, which cost as much as the noise.
SUFFUSE_INLINE std::int64_t paperFloor(double u)
{
    const auto whole = std::int64_t(u);
    return whole - (u < double(whole));
}

SUFFUSE_INLINE double paperClamp(double t, double low, double high)
{
    return t < low ? low : t > high ? high : t;
}

SUFFUSE_INLINE double paperFade(double f)
{
    return f * f * f * (f * (f * 6 - 15) + 10);
}

/// What the lattice point (X + i, Y + j) adds at its offset (f − i, g − j).
SUFFUSE_INLINE double paperCorner(std::uint32_t base, std::uint32_t x, std::uint32_t y, double f, double g)
{
    const std::uint32_t h = paperMix(paperMix(base ^ x * 0xC2B2AE35u) ^ y * 0x27D4EB2Fu);
    return ((h & 0xFFFFu) / 32768.0 - 1) * f + ((h >> 16) / 32768.0 - 1) * g;
}

/// The greatest number of octaves, and how much less each counts than the one before.
inline constexpr std::uint32_t paperMostOctaves = 48;
inline constexpr double paperFalloff = 0.70710678118654752;

/// What the hashes of a layer's lattice points begin with.
SUFFUSE_INLINE std::uint32_t paperBase(std::uint32_t layer, std::uint32_t seed)
{
    return seed * 0x9E3779B9u + layer * 0x85EBCA6Bu;
}

/// Gradient noise of a layer.
SUFFUSE_INLINE double paperNoise(double u, double v, std::uint32_t layer, std::uint32_t seed)
{
    const std::int64_t left = paperFloor(u), above = paperFloor(v);
    const double f = u - double(left), g = v - double(above), a = paperFade(f), b = paperFade(g);
    const auto x = std::uint32_t(left), y = std::uint32_t(above);
    const std::uint32_t base = paperBase(layer, seed);
    const double top = paperCorner(base, x, y, f, g) * (1 - a) + paperCorner(base, x + 1, y, f - 1, g) * a;
    const double bottom =
        paperCorner(base, x, y + 1, f, g - 1) * (1 - a) + paperCorner(base, x + 1, y + 1, f - 1, g - 1) * a;
    return top * (1 - b) + bottom * b;
}

/// Share of a layer that has so many samples a wavelength.
SUFFUSE_INLINE double paperBand(double samples)
{
    const double t = paperClamp((samples - 2) / 3, 0, 1);
    return t * t * (3 - 2 * t);
}

/// A turn by atan(4/3) and an enlargement.
SUFFUSE_INLINE void paperTurn(double &u, double &v, double times)
{
    const double turned = times * (0.6 * u - 0.8 * v);
    v = times * (0.8 * u + 0.6 * v);
    u = turned;
}

/// The octaves that all grains have, at cell coordinates of octave 0.
SUFFUSE_INLINE double paperOctaves(double u, double v, double samples, std::uint32_t seed)
{
    paperTurn(u, v, 1);
    double sum = 0, amplitude = 1;
    for (std::uint32_t i = 0; i < paperMostOctaves; ++i) {
        const double band = paperBand(samples);
        if (band <= 0)
            break;
        sum += band * amplitude * paperNoise(u + 0.5, v + 0.5, i, seed);
        paperTurn(u, v, 2);
        amplitude *= paperFalloff;
        samples *= 0.5;
    }
    return sum;
}

/// Threads over and under each other: 1 on a thread's back, 0 in the holes; less its mean.
SUFFUSE_INLINE double paperWeave(double u, double v, std::uint32_t seed)
{
    const double s = u + 0.35 * paperNoise(u * 0.25, v * 0.25, 48, seed);
    const double t = v + 0.35 * paperNoise(u * 0.25, v * 0.25, 49, seed);
    const std::int64_t column = paperFloor(s), row = paperFloor(t);
    const double p = 2 * (s - double(column)) - 1, q = 2 * (t - double(row)) - 1;
    const double over = (column + row) & 1 ? 1.0 : -1.0;
    const double a = 1 - p * p, b = 1 - q * q;
    const double warp = a * (1 + over * b), weft = b * (1 - over * a);
    return (warp > weft ? warp : weft) / 2 - 0.58;
}

/// Long hairs in five directions; less their mean.
SUFFUSE_INLINE double paperFibres(double u, double v, std::uint32_t seed)
{
    double sum = 0;
    for (std::uint32_t j = 0; j < 5; ++j) {
        paperTurn(u, v, 1);
        sum += paperClamp(1 - 12 * std::fabs(paperNoise(u * 0.125, v, 50 + j, seed)), 0, 1) - 0.19;
    }
    return sum;
}

/// η of the procedural paper at canvas point (x, y) for samples of size px (canvas units). `grain`: PaperGrain.
SUFFUSE_INLINE double proceduralPaper(double x, double y, double px, std::int32_t grain, std::uint32_t seed,
                                      double scale, double strength)
{
    const double u = x / scale, v = y / scale, samples = scale / px;
    const double octaves = paperOctaves(u, v, samples, seed);
    double n = 2.5 * octaves;
    if (grain == 1)
        n = octaves - (samples > 5 ? paperBand(0.4 * samples) * paperFibres(u, v, seed) : 0.0);
    else if (grain == 2)
        n = 0.75 * octaves - (samples > 2 ? 2.2 * paperBand(samples) * paperWeave(u, v, seed) : 0.0);
    const double t = paperClamp(n / 1.5, -1, 1);
    return 1 - strength * (0.5 + 0.25 * t * (3 - t * t));
}

/// η of an image paper: bilinear between texel centres, repeated.
SUFFUSE_INLINE double imagePaper(double x, double y, const float *grey, int width, int height, double scale,
                                 double strength)
{
    const double u = x / scale - 0.5, v = y / scale - 0.5, fu = std::floor(u), fv = std::floor(v);
    const auto wrap = [](double i, int n) { return int(i - std::floor(i / n) * n); };
    const int x0 = wrap(fu, width), y0 = wrap(fv, height);
    const int x1 = x0 + 1 < width ? x0 + 1 : 0, y1 = y0 + 1 < height ? y0 + 1 : 0;
    const double a = u - fu, b = v - fv;
    const auto at = [&](int i, int j) { return double(grey[std::size_t(j) * width + i]); };
    const double g = (at(x0, y0) * (1 - a) + at(x1, y0) * a) * (1 - b) + (at(x0, y1) * (1 - a) + at(x1, y1) * a) * b;
    return 1 - strength * (1 - g);
}

} // namespace suffuse::math
