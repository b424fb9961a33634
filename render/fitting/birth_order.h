// In which order the strokes of a fit are painted.
#pragma once

#include "render/fitting/fit_picture.h"
#include "render/gradient/differentiator.h"

#include <atomic>
#include <cstdint>

namespace suffuse::fitting {

/// When each stroke of a scene is painted: its place in time, from 0 on. A stroke lies where it lies among the others, however
/// late it comes. They come from the back to the front, but one that would take the picture away from the target waits until
/// what was painted meanwhile makes it bring the picture nearer: a stroke that was fitted to be seen between others may do
/// harm while it lies alone. So each of a hundred moments of the painting that is played comes nearer than the one before,
/// as far as there are strokes that do so.
///
/// The picture is affine in the opacity o of one stroke, so painting it adds o ∂E/∂o + o² Σ(∂picture/∂o)² to the square
/// error E, with derivatives at o = 0. One way back gives the first for all strokes that wait, and ways back from random
/// signs estimate the second, over moments that follow each other. `weight` may be empty. Empty when `cancel` was set.
std::vector<std::size_t> birthOrder(gradient::Differentiator &gradient, gradient::FlatScene scene,
                                    const FitPicture &target, const FitPicture &weight, std::uint64_t seed,
                                    const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::fitting
