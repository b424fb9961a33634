// Lists the renderers, and makes them. Only the programs include this, since no backend knows another one.
#pragma once

#include "render/gradient/differentiator.h"
#include "render/renderer.h"

namespace suffuse {

/// Makes a renderer. Auto, Cpu and Reference never fail. Cuda fails with the reason where it cannot run.
Result<std::unique_ptr<Renderer>> makeRenderer(const RendererOptions &options);

/// Makes a renderer that can draw at once. Where a GPU is asked for, or Auto, the CPU draws until the GPU has started;
/// where it cannot start, the CPU goes on, and the renderer's notice says why. It never fails.
Result<std::unique_ptr<Renderer>> makeRendererAtOnce(const RendererOptions &options);

/// The backend by which so many pictures like this one are drawn soonest, the start of a device included: what Auto
/// means for a program that draws them and ends. It never asks whether there is a GPU.
Backend quickestBackend(const RenderRequest &request, std::size_t pictures, const RendererOptions &options);

/// Makes renderers that share work by whole pictures (render/sequence.h): one for each GPU (`options.devices` of them),
/// or one for the CPU.
Result<std::vector<std::unique_ptr<Renderer>>> makeRenderers(const RendererOptions &options);

/// Makes what finds gradients for a fit. Auto takes a GPU where there is one. Cuda fails with the reason where it cannot run, and
/// Reference always, since it has no gradients.
Result<std::unique_ptr<gradient::Differentiator>> makeDifferentiator(Backend backend, const Threads &threads);

struct BackendInfo {
    Backend backend;
    QString device;
    QString unavailable; ///< empty, or why it cannot run here
};
std::vector<BackendInfo> backends();

} // namespace suffuse
