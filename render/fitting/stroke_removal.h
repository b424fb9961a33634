// What each stroke of a fit is good for.
#pragma once

#include "render/fitting/fit_stroke.h"
#include "render/gradient/differentiator.h"

#include <atomic>

namespace suffuse::fitting {

/// What strokes are measured by.
struct RemovalView {
    const FitPicture &target; ///< R, G, B
    const FitPicture &weight; ///< of the same size, or empty
    const View &view;         ///< shows the strokes at that size
    const std::vector<float> *ground = nullptr; ///< R, Y, B of each of its pixels, in place of the background; or null
};

/// The pixels that a stroke may reach, in whole tiles.
PixelRect boxOf(const FitStroke &stroke, const View &view);
bool meet(const PixelRect &a, const PixelRect &b);
/// What a view shows in a box of its pixels.
View partOf(const View &view, const PixelRect &box);
/// The ground in a box of pixels, of a picture that is `width` wide; null if there is none of its own for each pixel.
std::shared_ptr<const std::vector<float>> groundIn(const std::vector<float> *ground, int width, const PixelRect &box);
/// The sum of weighted square errors of all channels in a box.
double errorIn(const std::vector<FitStroke> &strokes, StyleKind style, const Colour &background,
               const RemovalView &seen, const PixelRect &box);

/// For each of the strokes `which`, by how much the sum of weighted square errors of all channels grows if it is taken
/// away, exactly: what lies in its box is drawn with and without it. Below 0: the picture is better without it. Empty
/// when `cancel` was set.
std::vector<double> errorsWithout(const std::vector<FitStroke> &strokes, const std::vector<std::size_t> &which,
                                  StyleKind style, const Colour &background, const RemovalView &seen,
                                  const Threads &threads, const std::atomic<bool> *cancel = nullptr);

/// About the same for all strokes, in the time of some steps of a fit. The picture is nearly affine in the opacity o of
/// one stroke, so its error is nearly a parabola, and without the stroke it is greater by −o ∂L/∂o + o²
/// Σ(∂picture/∂o)². That sum over pixels is the mean square of the way back from random signs at all pixels; so few of
/// these are taken that it is off by a third. Empty when `cancel` was set.
std::vector<double> roughErrorsWithout(gradient::Differentiator &gradient, const gradient::FlatScene &scene,
                                       const RemovalView &seen, std::uint64_t seed,
                                       const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::fitting
