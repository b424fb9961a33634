// Where a renderer puts its pixels.
#pragma once

#include "render/view.h"

#include <cstdint>
#include <vector>

namespace suffuse {

/// Receives finished pixels: straight (unassociated) RGBA, RGB sRGB-encoded, each in [0, 1].
class Target {
public:
    Target() : m_serial(nextSerial()) {}
    Target(const Target &) : Target() {}
    Target &operator=(const Target &) { return *this; }
    virtual ~Target() = default;
    /// Never used twice in a process, as an address is: a renderer knows by it which target it drew last.
    std::uint64_t serial() const { return m_serial; }
    /// Before the first store of a picture of another size.
    virtual void resize(int width, int height) = 0;
    /// `rgba`: 4 floats a pixel, rows of `stride` pixels. Called from several threads at once for disjoint rectangles.
    virtual void store(const PixelRect &rect, const float *rgba, int stride) = 0;

    /// True where 8 bits are all that is kept: then renderers that make them themselves call `storeArgb` instead.
    virtual bool keepsArgb() const { return false; }
    /// `argb`: 0xAARRGGBB, rows of `stride` pixels.
    virtual void storeArgb(const PixelRect &, const std::uint32_t *, int) {}
    /// True where the picture may stay on the device (RenderStats::frame) and nothing need be stored.
    virtual bool takesDeviceFrames() const { return false; }

private:
    static std::uint64_t nextSerial();

    std::uint64_t m_serial;
};

/// A picture in memory, float RGBA.
class FloatPicture : public Target {
public:
    int width = 0;
    int height = 0;
    std::vector<float> rgba; ///< width·height·4

    void resize(int w, int h) override
    {
        width = w, height = h;
        rgba.assign(std::size_t(w) * h * 4, 0.0f);
    }
    void store(const PixelRect &rect, const float *pixels, int stride) override;
    const float *at(int x, int y) const { return rgba.data() + (std::size_t(y) * width + x) * 4; }
};

/// A picture in memory, 8 bits a channel, 0xAARRGGBB straight alpha (QImage::Format_ARGB32), rounded to nearest.
class Picture8 : public Target {
public:
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> argb;

    void resize(int w, int h) override
    {
        width = w, height = h;
        argb.assign(std::size_t(w) * h, 0);
    }
    void store(const PixelRect &rect, const float *pixels, int stride) override;
    bool keepsArgb() const override { return true; }
    void storeArgb(const PixelRect &rect, const std::uint32_t *pixels, int stride) override;
};

} // namespace suffuse
