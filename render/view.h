// Which part of the canvas a picture shows.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A rectangle of whole pixels.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    bool isEmpty() const { return width <= 0 || height <= 0; }
    friend bool operator==(const PixelRect &, const PixelRect &) = default;
};

/// How many pixels lie in rectangles that do not overlap.
inline double pixelsIn(const std::vector<PixelRect> &rects)
{
    double pixels = 0;
    for (const PixelRect &r : rects)
        pixels += double(r.width) * r.height;
    return pixels;
}

/// A similarity between canvas units and pixels. It is stored with the canvas point at the centre of the picture, so
/// that deep zoom loses no digits: subtract in double first, then scale.
struct View {
    Point centre;          ///< canvas point at the centre of the picture
    double scale = 1;      ///< pixels per unit (the zoom), 1e-3 … 1e9
    double rotation = 0;   ///< radians, clockwise on screen (y down)
    bool mirrored = false; ///< left and right swapped, before the rotation
    int width = 0;         ///< pixels
    int height = 0;
    friend bool operator==(const View &, const View &) = default;

    double px() const { return 1 / scale; } ///< size of a pixel in canvas units

    /// The view of an area: pixel (i, j) samples area.xy + (i+½, j+½)·px, px = area.width/width.
    static View ofArea(const Rect &area, int width, int height)
    {
        View v;
        v.scale = width / area.width();
        v.width = width;
        v.height = height;
        v.centre = {area.left + 0.5 * width / v.scale, area.top + 0.5 * height / v.scale};
        return v;
    }
    /// The view of a rectangle of the picture's pixels.
    View part(const PixelRect &pixels) const
    {
        View v = *this;
        v.centre = toCanvas({pixels.x + 0.5 * pixels.width, pixels.y + 0.5 * pixels.height});
        v.width = pixels.width;
        v.height = pixels.height;
        return v;
    }
    Point toPixels(Point canvas) const
    {
        Point d = canvas - centre;
        if (mirrored)
            d.x = -d.x;
        const double c = std::cos(rotation), s = std::sin(rotation);
        return {scale * (c * d.x - s * d.y) + 0.5 * width, scale * (s * d.x + c * d.y) + 0.5 * height};
    }
    Point toCanvas(Point pixel) const { return toCanvas(pixel, std::cos(rotation), std::sin(rotation)); }
    /// The same for many pixels, with the cosine and the sine of the rotation.
    Point toCanvas(Point pixel, double c, double s) const
    {
        const Point q{(pixel.x - 0.5 * width) / scale, (pixel.y - 0.5 * height) / scale};
        Point d{c * q.x + s * q.y, c * q.y - s * q.x};
        if (mirrored)
            d.x = -d.x;
        return centre + d;
    }
};

/// The height of a picture of `area` in pixels: round(area.height / (area.width / width)).
inline int heightForWidth(const Rect &area, int width)
{
    return int(std::lround(area.height() / (area.width() / width)));
}

} // namespace suffuse
