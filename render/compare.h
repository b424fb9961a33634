// How far two pictures are apart.
#pragma once

#include "model/result.h"
#include "render/target.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace suffuse {

/// What the contract allows between a backend and the reference, per channel.
inline constexpr double pictureTolerance = 1.0 / 512;

/// Differences of colour are taken of associated colour (colour · alpha): where little is covered, straight colour says
/// little. For opaque pictures the two are the same.
struct PictureDifference {
    std::array<double, 4> maximum{}; ///< largest difference in R, G, B and A
    std::array<double, 4> mean{};
    int x = 0; ///< pixel of the largest difference in any channel
    int y = 0;
    std::array<float, 4> first{}; ///< the two pictures there, straight
    std::array<float, 4> second{};
    std::size_t pixels = 0;    ///< compared
    std::size_t over = 0;      ///< pixels with a channel over pictureTolerance
    std::size_t notFinite = 0; ///< pixels with a value that is no number, in either picture; they count as over

    double largest() const { return std::max({maximum[0], maximum[1], maximum[2], maximum[3]}); }
    bool isWithinTolerance() const { return over == 0; }
};

/// Fails if the sizes differ.
Result<PictureDifference> compare(const FloatPicture &a, const FloatPicture &b);

} // namespace suffuse
