// Where diffusion curves cut the links between neighbouring pixels, and which colours stand there.
#pragma once

#include "model/formats/ink/curve_set.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace suffuse::curves {

/// What diffuses: R, G, B, and the standard deviation of the blur.
inline constexpr int curveValues = 4;

/// The Laplace equation of a picture that curves cut, on its pixels. A link between the centres of two pixels that a
/// curve cuts carries nothing. Each of the two is linked to the colour on its own side of the curve instead, at the
/// distance θ of the cut: with the conductance 1/θ. Between the cuts the equation is the usual one of five points.
struct CurveLinks {
    int width = 0, height = 0;
    std::vector<std::uint8_t> right, down; ///< whether a pixel is linked to the next one; never at the picture's border
    std::vector<float> anchors;            ///< of each pixel: the sum of 1/θ
    std::vector<float> sources[curveValues]; ///< of each pixel: the sum of 1/θ times the value of the curve
    std::array<double, curveValues> mean{};  ///< of all values at cuts; of the curves where nothing is cut

    std::size_t pixels() const { return anchors.size(); }
    bool isCut = false; ///< Else nothing holds the picture, and each constant solves the equation.
};

/// The links of curves in a picture of this size, whatever the size in the file: curves and blurs are scaled to it.
/// Returns early, with something unfinished, when `cancel` is set.
CurveLinks linksOf(const CurveSet &set, int width, int height, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::curves
