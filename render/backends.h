// Lists the renderers, and makes them. Only the programs include this, since no backend knows another one.
#pragma once

#include "render/renderer.h"

namespace suffuse {

/// Makes a renderer. Auto, Cpu and Reference never fail. Cuda fails with the reason where it cannot run.
Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options);

/// Makes renderers that share work by whole pictures (render/sequence.h): one for each GPU (`options.devices` of them),
/// or one for the CPU.
Result<std::vector<std::unique_ptr<Renderer>>> makeRenderers(const RendererOptions &options);

struct BackendInfo {
    Backend backend;
    QString device;
    QString unavailable; ///< empty, or why it cannot run here
};
std::vector<BackendInfo> backends();

} // namespace suffuse
