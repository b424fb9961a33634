// Where a renderer puts its pixels.
#pragma once

#include "render/pages.h"
#include "render/view.h"

#include <cstdint>
#include <vector>

namespace suffuse {

/// Receives finished pixels as straight (unassociated) RGBA. RGB is sRGB-encoded, and all values are in [0, 1].
class Target {
public:
    Target() : m_serial(nextSerial()) {}
    Target(const Target &) : Target() {}
    Target &operator=(const Target &) { return *this; }
    virtual ~Target() = default;
    /// Unlike an address it is never used twice in a process, so a renderer can tell by it which target it drew last.
    std::uint64_t serial() const { return m_serial; }
    /// Called before the first `store` of a picture of another size, or of another renderer. What is there already may
    /// stay where the size does: all of it is stored again.
    virtual void resize(int width, int height) = 0;
    /// Moves the picture's pixels to the right and down (or left and up), if it can; those that come into view are
    /// stored afterwards. Returns false where it cannot.
    virtual bool move(int /*dx*/, int /*dy*/) { return false; }
    /// Stores a rectangle. `rgba` has 4 floats for each pixel, in rows of `stride` pixels. It is called from several
    /// threads at once for rectangles that do not overlap.
    virtual void store(const PixelRect &rect, const float *rgba, int stride) = 0;

    /// Whether only 8 bits are kept. Renderers that can make these themselves then call `storeArgb` instead.
    virtual bool keepsArgb() const { return false; }
    /// Stores a rectangle of 0xAARRGGBB, in rows of `stride` pixels.
    virtual void storeArgb(const PixelRect &, const std::uint32_t *, int) {}
    /// Whether the picture may stay on the device (RenderStats::frame), so that nothing need be stored.
    virtual bool takesDeviceFrames() const { return false; }

private:
    static std::uint64_t nextSerial();

    std::uint64_t m_serial;
};

/// A picture in memory, as float RGBA.
class FloatPicture : public Target {
public:
    int width = 0;
    int height = 0;
    Pixels<float> rgba; ///< width·height·4

    void resize(int w, int h) override
    {
        if (w == width && h == height && rgba.size() == std::size_t(w) * h * 4)
            return;
        width = w, height = h;
        rgba = {}; // Two pictures need not fit into memory.
        rgba = Pixels<float>(std::size_t(w) * h * 4);
    }
    bool move(int dx, int dy) override;
    void store(const PixelRect &rect, const float *pixels, int stride) override;
    const float *at(int x, int y) const { return rgba.data() + (std::size_t(y) * width + x) * 4; }
};

/// A picture in memory with 8 bits a channel, 0xAARRGGBB with straight alpha (QImage::Format_ARGB32), rounded to
/// nearest.
class Picture8 : public Target {
public:
    int width = 0;
    int height = 0;
    Pixels<std::uint32_t> argb; ///< width·height

    void resize(int w, int h) override
    {
        if (w == width && h == height && argb.size() == std::size_t(w) * h)
            return;
        width = w, height = h;
        argb = {}; // Two pictures need not fit into memory.
        argb = Pixels<std::uint32_t>(std::size_t(w) * h);
    }
    bool move(int dx, int dy) override;
    void store(const PixelRect &rect, const float *pixels, int stride) override;
    bool keepsArgb() const override { return true; }
    void storeArgb(const PixelRect &rect, const std::uint32_t *pixels, int stride) override;
};

} // namespace suffuse
