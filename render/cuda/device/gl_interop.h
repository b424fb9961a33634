// CUDA writes to OpenGL textures here. The header is C++17 and knows no Qt.
#pragma once

#include "render/cuda/device/device.h"

#include <memory>

namespace suffuse::cuda {

/// Registers a texture (2-D, RGBA8, with its storage) of the current OpenGL context for writing from `device`. Returns
/// null if that device does not draw the context. Then fault.what says why, and fault.kind is None, since nothing is
/// wrong with the device. The result must be destroyed with the same context current, before the texture. It may be
/// called from any thread, also while another one uses the device.
std::unique_ptr<GlTexture> registerGlTexture(int device, unsigned texture, Fault &fault);

} // namespace suffuse::cuda
