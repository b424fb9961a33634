// Pixels that are chosen or not: the region around one of them, its distances and its outline.
#pragma once

#include "model/geometry/geometry.h"

#include <cstdint>
#include <vector>

namespace suffuse {

/// Rows from top to bottom; a pixel is 0 or 1. The pixel (x, y) covers the square from (x, y) to (x + 1, y + 1).
struct Mask {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;

    Mask() = default;
    Mask(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}

    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    /// Pixels beyond the borders are 0.
    bool at(int x, int y) const { return contains(x, y) && pixels[index(x, y)] != 0; }
    std::size_t count() const;
};

/// The squared distance of each pixel to the nearest one that is 1, between their middles; infinite where there is none.
/// (P. F. Felzenszwalb, D. P. Huttenlocher, Distance Transforms of Sampled Functions, 2012.)
std::vector<double> squaredDistances(const Mask &mask);

/// The pixels that are nearer to one that is 1 than `by` pixels; where `by` is negative, those that are farther from each
/// that is 0. Beyond the borders nothing counts.
Mask grown(const Mask &mask, double by);

/// The pixels that are 1 and hang together with a pixel by their sides. Openings that are narrower than `gap` pixels are
/// no way; corners are then rounded by half of that. Where the pixel itself lies in such a narrow place, less of the
/// gap counts. It is empty where the pixel is 0.
Mask regionAround(const Mask &mask, int x, int y, double gap = 0);

/// The outlines of a mask, in pixels: closed loops around what is 1, and the other way around within it. They are
/// smooth but at corners, and within about a pixel of the pixels' edges. Loops around less than `least` square pixels
/// are left out.
std::vector<std::vector<Cubic>> outlinesOf(const Mask &mask, double least = 6);

} // namespace suffuse
