// The picture of diffusion curves (Orzan et al. 2008): their colours diffuse, and are blurred then.
#pragma once

#include "model/formats/ink/curve_set.h"

#include <atomic>

namespace suffuse::curves {

struct SolvedCurves {
    int width = 0, height = 0;
    std::vector<float> rgb; ///< sRGB-encoded R, G, B in [0, 1] of each pixel, row by row
};

/// Why curves have no picture, or an empty text: the size of the file makes none, or there is no curve.
QString problemOf(const CurveSet &set);

/// Solves the Laplace equation for the sRGB-encoded values, each curve being held at its left colours on its left side
/// and at its right ones on the other; nothing flows across the border of the picture. The blur diffuses from the
/// curves in the same way, and each pixel is the mean under a Gaussian of that width. All is done on pixels of half the
/// size, as long as these are few enough, whose means are the picture's. The same bits for any number of threads.
/// Curves that lie between pixels, or beside them, hold nothing: the picture then has their mean colour. Empty when
/// `cancel` was set. `problemOf` must have found nothing.
SolvedCurves solvedCurves(const CurveSet &set, int width, int height, int threads = 0,
                          const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::curves
