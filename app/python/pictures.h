// Pictures as arrays.
#pragma once

#include "app/python/bindings.h"
#include "render/renderer.h"

#include <mutex>

namespace suffuse::python {

enum class Depth { Bits8, Bits16, Float };

/// Of a dtype: uint8, uint16 or float32. Raises DataError.
Depth depthOf(const py::object &type);
/// (height, width, 3), or 4 with alpha. Floats are the picture's own memory.
py::array arrayOfPicture(const std::shared_ptr<const FloatPicture> &picture, Depth depth, bool alpha);
/// The numbers of an array (height, width, 3 or 4) as floats, RGBA; white is 1. Raises DataError.
FloatPicture pictureOf(const py::array &pixels);

/// Draws again and again, and evaluates only what differs. Threads may share it.
class KeptRenderer {
public:
    explicit KeptRenderer(const RendererOptions &options);
    /// With alpha where the request is transparent. Raises what went wrong.
    py::array render(const RenderRequest &request, Depth depth);
    const Renderer &renderer() const { return *m_renderer; }

private:
    std::mutex m_mutex; ///< several threads may ask
    std::unique_ptr<Renderer> m_renderer;
    FloatPicture m_picture;
};

} // namespace suffuse::python
