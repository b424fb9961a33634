// Measures how far apart two pictures are.
#pragma once

#include "model/result.h"
#include "render/target.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace suffuse {

/// The greatest difference that the contract allows between a backend and the reference, in each channel.
inline constexpr double pictureTolerance = 1.0 / 512;

/// Differences of colour are taken of associated colour (colour · alpha), since straight colour says little where
/// little is covered. For opaque pictures both are the same.
struct PictureDifference {
    std::array<double, 4> maximum{}; ///< largest difference in R, G, B and A
    std::array<double, 4> mean{};
    int x = 0; ///< pixel of the largest difference in any channel
    int y = 0;
    std::array<float, 4> first{}; ///< the two pictures at that pixel, straight
    std::array<float, 4> second{};
    std::size_t pixels = 0; ///< number of pixels that were compared
    std::size_t over = 0;   ///< pixels with a channel over pictureTolerance
    /// pixels with a value that is not a number, in either picture; they count as over the tolerance
    std::size_t notFinite = 0;

    double largest() const { return std::max({maximum[0], maximum[1], maximum[2], maximum[3]}); }
    bool isWithinTolerance() const { return over == 0; }
};

/// Compares two pictures. It fails if their sizes differ.
Result<PictureDifference> compare(const FloatPicture &a, const FloatPicture &b);

} // namespace suffuse
