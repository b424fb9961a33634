// How frames come by their renderers.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <memory>

namespace suffuse {

/// As makeRenderer (render/backends.h); tests put others in its place.
using MakeRenderer = std::function<Result<std::unique_ptr<Renderer>>(const RendererOptions &)>;

} // namespace suffuse
