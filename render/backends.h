// Which renderers there are, and making one. Nothing below includes this: a backend knows no other one.
#pragma once

#include "render/renderer.h"

namespace suffuse {

/// Never null for Auto, Cpu and Reference; Cuda fails with the reason where it cannot run.
Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options);

struct BackendInfo {
    QString name;
    QString device;
    QString unavailable; ///< empty, or why it cannot run here
};
std::vector<BackendInfo> backends();

} // namespace suffuse
