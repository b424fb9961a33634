// The paper texture η, docs/paper.md. Scalar: a picture needs it once a pixel.
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

/// Lattice value in [−1, 1).
SUFFUSE_INLINE double paperCorner(std::uint32_t base, std::int64_t x, std::int64_t y)
{
    std::uint32_t h = paperMix(base ^ std::uint32_t(x) * 0xC2B2AE35u);
    h = paperMix(h ^ std::uint32_t(y) * 0x27D4EB2Fu);
    return h / 2147483648.0 - 1.0;
}

/// η of the procedural paper at canvas point (x, y) for samples of size px (canvas units).
SUFFUSE_INLINE double proceduralPaper(double x, double y, double px, std::uint32_t seed, double scale, double strength)
{
    const auto fade = [](double f) { return f * f * f * (f * (f * 6 - 15) + 10); };
    double sum = 0, amplitude = 1, wavelength = scale;
    for (std::uint32_t i = 0; i < 48; ++i, amplitude *= 0.70710678118654752, wavelength *= 0.5) {
        const double band = std::fmin(1.0, (wavelength / px - 2) / 2);
        if (band <= 0)
            break;
        const double u = x / wavelength, v = y / wavelength, fu = std::floor(u), fv = std::floor(v);
        const auto X = std::int64_t(fu), Y = std::int64_t(fv);
        const double a = fade(u - fu), b = fade(v - fv);
        const std::uint32_t base = seed * 0x9E3779B9u + i * 0x85EBCA6Bu;
        const double top = paperCorner(base, X, Y) * (1 - a) + paperCorner(base, X + 1, Y) * a;
        const double bottom = paperCorner(base, X, Y + 1) * (1 - a) + paperCorner(base, X + 1, Y + 1) * a;
        sum += band * amplitude * (top * (1 - b) + bottom * b);
    }
    const double n = std::fmin(1.0, std::fmax(0.0, 0.5 + 0.75 * sum));
    return 1 - strength * n;
}

/// η of an image paper: bilinear between texel centres, repeated.
SUFFUSE_INLINE double imagePaper(double x, double y, const float *grey, int width, int height, double scale, double strength)
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
