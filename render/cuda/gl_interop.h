// OpenGL textures as CUDA sees them. C++17, no Qt.
#pragma once

#include "render/cuda/device.h"

#include <memory>

namespace suffuse::cuda {

/// Registers a texture (2-D, RGBA8, its storage made) of the current OpenGL context for writing from `device`. Null
/// where that device does not draw the context: then fault.what says why, and fault.kind is None, as nothing is wrong
/// with the device. Destroy the result with the same context current, before the texture. May be called from any
/// thread, also while another one uses the device.
std::unique_ptr<GlTexture> registerGlTexture(int device, unsigned texture, Fault &fault);

} // namespace suffuse::cuda
