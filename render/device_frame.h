// A finished picture that stayed in the memory of the device that computed it.
#pragma once

#include "model/result.h"
#include "render/view.h"

#include <memory>
#include <vector>

namespace suffuse {

/// A texture of an OpenGL context that a device may write to. Ends with that context current.
class TextureLink {
public:
    virtual ~TextureLink() = default;
};

/// Two pictures of one size: the one that is worked on, and the one that is shown. Calls of `publish` and the others
/// must not overlap (FrameBoard holds its frame's lock).
class DeviceFrame {
public:
    virtual ~DeviceFrame() = default;
    virtual int width() const = 0;
    virtual int height() const = 0;
    /// Brings what is shown up to date with what was rendered, in these rectangles.
    virtual Result<void> publish(const std::vector<PixelRect> &rects) = 0;
    /// For an OpenGL texture (RGBA8, of this size) of the context that is current; fails with the reason where another
    /// device or a software renderer draws that context.
    virtual Result<std::unique_ptr<TextureLink>> link(unsigned texture) = 0;
    /// Copies rectangles of what is shown into the texture, whose context is current.
    virtual Result<void> copyTo(TextureLink &texture, const std::vector<PixelRect> &rects) = 0;
};

} // namespace suffuse
