// What a fit makes small: how far the picture drawn is from the one wanted.
#pragma once

#include "render/fitting/fit_picture.h"

#include <cstddef>

namespace suffuse::fitting {

/// A sum over pixels: the square difference of sRGB-encoded values and, by the share `perceptual` in [0, 1], that in
/// OKLab, where equal differences look alike. A difference of lightness counts as much in both.
class FitLoss {
public:
    FitLoss() = default;
    /// `weight` may be empty.
    FitLoss(FitPicture target, FitPicture weight, double perceptual);

    const FitPicture &target() const { return m_target; }
    const FitPicture &weight() const { return m_weight; }
    /// Whether it is nothing but the sum of square differences from the target.
    bool isPlain() const { return m_weight.isEmpty() && m_perceptual <= 0; }
    /// Writes the derivatives by the R, G, B of pixels [first, first + count). Any thread.
    void differentiate(std::size_t first, std::size_t count, const float *rgb, float *byRgb) const;
    /// The loss of one pixel.
    double at(std::size_t pixel, const float *rgb) const;

private:
    FitPicture m_target, m_weight;
    FitPicture m_perceived; ///< OKLab of the target; empty if it does not count
    float m_perceptual = 0;
};

} // namespace suffuse::fitting
