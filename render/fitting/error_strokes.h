// Where a picture lacks strokes, and with which new ones to begin there.
#pragma once

#include "render/fitting/fit_stroke.h"

#include <atomic>
#include <cstdint>

namespace suffuse::fitting {

/// What is to be improved.
struct ErrorView {
    const FitPicture &target; ///< R, G, B
    const FitPicture &drawn;  ///< of the same size
    const FitPicture &weight; ///< of the same size, or empty
    double scale = 1;         ///< its pixels for each pixel of the picture that is fitted
};

/// Finds up to `count` new strokes, the larger first. Each is put where a Gaussian of one of several widths takes the
/// most from the square error: there the error has one sign over an area of that width. It lies along the ridge that
/// the structure tensor of the error shows there, and takes the colour that the target has. What it takes away is
/// subtracted before the next ones are looked for. There are fewer where little is left, or when `cancel` is set.
std::vector<FitStroke> strokesForError(const ErrorView &view, std::size_t count, const FitLimits &limits,
                                       std::uint64_t seed, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::fitting
