// How near a picture comes to another one.
#pragma once

#include "render/fitting/fit_picture.h"

namespace suffuse::fitting {

/// The mean square difference of all channels of two pictures of one size; with a weight, of what it counts.
double meanSquare(const FitPicture &a, const FitPicture &b, const FitPicture &weight = {});

/// The peak signal to noise ratio in dB of values in [0, 1], −10 log₁₀ of the mean square; at most 99 dB, which equal
/// pictures have.
double peakRatio(double meanSquare);

/// The structural similarity of two pictures at several scales.
struct SimilarityAtScales {
    double value = 1; ///< 1: equal
    int scales = 0; ///< how many; 5 where both sides have 176 pixels or more, 0 where a side is shorter than the window
};

/// MS-SSIM (Wang, Simoncelli, Bovik 2003): a Gaussian window of 11 × 11 pixels with σ = 1.5 that lies within the
/// picture, constants (0.01)² and (0.03)², scales that are means over 2 × 2 pixels, weights 0.0448, 0.2856, 0.3001,
/// 0.2363, 0.1333, and the mean over R, G, B. Where a picture is too small for five scales, there are fewer, and the
/// weights are divided by their sum.
SimilarityAtScales multiScaleSimilarity(const FitPicture &a, const FitPicture &b);

} // namespace suffuse::fitting
