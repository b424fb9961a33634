// What has to be known to see a picture at a pixel.
#pragma once

#include <cstdint>

namespace suffuse {

/// A picture at one of its sizes: rows of premultiplied sRGB values and alpha, 65535 for 1.
struct PictureLevel {
    const std::uint16_t *rgba = nullptr;
    int width = 0;
    int height = 0;
};

/// How a picture lies in a view: the two levels that are looked at, and where on the finer one a pixel lies.
struct PictureView {
    PictureLevel finer, coarser;
    double u = 0, ux = 0, uy = 0; ///< the pixel at (x, y) lies at column u + ux·x + uy·y, in pixels of the finer level
    double v = 0, vx = 0, vy = 0; ///< and row v + vx·x + vy·y
    float share = 0;              ///< of the coarser level
    float padding = 0;
};

} // namespace suffuse
