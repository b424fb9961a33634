#pragma once

#include "render/backends.h"

namespace suffuse::settings {

/// What the settings say of the renderer. The environment variable SUFFUSE_BACKEND=auto|cpu|cuda goes before the
/// setting.
RendererOptions rendererOptions();

} // namespace suffuse::settings
