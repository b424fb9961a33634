// A finished picture that stayed in the memory of the device that computed it.
#pragma once

#include "model/result.h"
#include "render/view.h"

#include <memory>
#include <vector>

namespace suffuse {

/// A texture of an OpenGL context that a device may write to. It must end while that context is current.
class TextureLink {
public:
    virtual ~TextureLink() = default;
};

/// Two pictures of one size: one is being worked on, and the other is shown. Calls of `publish` must not overlap with
/// others (FrameBoard holds the lock of its frame).
class DeviceFrame {
public:
    virtual ~DeviceFrame() = default;
    virtual int width() const = 0;
    virtual int height() const = 0;
    /// Copies what was rendered in these rectangles to the picture that is shown.
    virtual Result<void> publish(const std::vector<PixelRect> &rects) = 0;
    /// Links an OpenGL texture (RGBA8, of this size) of the current context. It fails with the reason if another device
    /// or a software renderer draws that context.
    virtual Result<std::unique_ptr<TextureLink>> link(unsigned texture) = 0;
    /// Copies rectangles of the shown picture into the texture, whose context must be current.
    virtual Result<void> copyTo(TextureLink &texture, const std::vector<PixelRect> &rects) = 0;
};

} // namespace suffuse
