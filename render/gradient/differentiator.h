// What draws flat scenes and takes derivatives for a fit, whichever processor does it.
#pragma once

#include "render/gradient/scene_gradient.h"

#include <QString>

namespace suffuse::gradient {

/// A loss that is a sum over pixels.
struct PixelLoss {
    SceneGradient<float>::PixelLoss slopes;
    /// If the loss is Σ(picture − target)² over pixels and channels, its target: R, G, B of each pixel. A device keeps them in
    /// its memory, and the picture need not come back. Else null.
    std::shared_ptr<const std::vector<float>> squaresTo;
};

/// Does what SceneGradient<float> does, and with its words. On one processor results have the same bits each time.
class Differentiator {
public:
    virtual ~Differentiator() = default;
    virtual void choose(const FlatScene &scene, const Precision &precision = {}) = 0;
    /// R, G, B of each pixel, valid until the next call.
    virtual std::span<const float> draw(const FlatScene &scene) = 0;
    /// The derivatives of a loss at the scene drawn last, valid until the next call.
    virtual const FlatGradient &backward(std::span<const float> lossByRgb) = 0;
    virtual const FlatGradient &drawAndDifferentiate(const FlatScene &scene, const PixelLoss &loss) = 0;

    /// What works now, for people: "CPU", or a GPU's name.
    virtual QString deviceName() const = 0;
    /// Why a GPU that worked before does not any more, in its driver's words; else empty.
    virtual QString notice() const { return {}; }
};

/// The CPU's.
std::unique_ptr<Differentiator> makeCpuDifferentiator(const Threads &threads);

} // namespace suffuse::gradient
