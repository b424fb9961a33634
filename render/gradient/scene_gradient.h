// The picture of a flat scene, and the exact derivatives of a loss by all of its numbers (docs/solver.md, "The gradient
// of the picture").
#pragma once

#include "render/gradient/flat_scene.h"
#include "render/threads/parallel.h"

#include <functional>
#include <memory>
#include <span>

namespace suffuse::gradient {

/// Draws a scene and takes derivatives. `Number` is float, or double to check it by. Pictures and derivatives are a
/// pure function of the scene, the nodes chosen and the loss: the same bits for any number of threads and any history.
/// It keeps its memory from one picture to the next.
template <class Number>
class SceneGradient {
public:
    explicit SceneGradient(Threads threads = {});
    ~SceneGradient();

    /// Chooses how many nodes each segment has, and where they are cut off. Until the next call they stay, so that the
    /// picture is a smooth function of the scene's numbers. Call it when spreads or lengths have changed by some
    /// percent, and whenever segments come or go.
    void choose(const FlatScene &scene, const Precision &precision = {});

    /// Draws the scene: sRGB-encoded R, G, B of each pixel, row by row, valid until the next call. `choose` must have
    /// seen a scene with as many segments and strokes. Segments with s below 1 px are drawn as if they were resolved.
    std::span<const Number> draw(const FlatScene &scene);

    /// Returns the derivatives of the loss by the numbers of the scene drawn last, from ∂L/∂(R, G, B) of each pixel,
    /// laid out like the picture. Valid until the next call.
    const FlatGradient &backward(std::span<const Number> lossByRgb);

    /// Does both at once, in two thirds of the time, for a loss that is a sum over pixels. `loss` is called for pixels
    /// [first, first + count), which lie side by side in a row, from several threads at once: it gets their R, G, B,
    /// and writes ∂L/∂(R, G, B).
    using PixelLoss = std::function<void(std::size_t first, std::size_t count, const Number *rgb, Number *byRgb)>;
    const FlatGradient &drawAndDifferentiate(const FlatScene &scene, const PixelLoss &loss);
    /// The picture drawn last.
    std::span<const Number> picture() const;

private:
    struct Work;
    std::unique_ptr<Work> m;
};

extern template class SceneGradient<float>;
extern template class SceneGradient<double>;

} // namespace suffuse::gradient
