// How far a picture that another program shows is from ours.
#pragma once

#include "render/target.h"

#include <algorithm>
#include <cmath>

namespace suffuse::test {

/// The means of squares of a picture's pixels.
inline FloatPicture meansOf(const FloatPicture &picture, int side)
{
    FloatPicture means;
    means.resize(picture.width / side, picture.height / side);
    for (int y = 0; y < means.height * side; ++y)
        for (int x = 0; x < means.width * side; ++x)
            for (int c = 0; c < 4; ++c)
                means.rgba.data()[4 * ((y / side) * means.width + x / side) + c] +=
                    picture.rgba.data()[4 * (y * picture.width + x) + c] / float(side * side);
    return means;
}

/// Of red, green and blue; 1 where the sizes differ.
inline double largestDifference(const FloatPicture &a, const FloatPicture &b)
{
    double largest = a.width == b.width && a.height == b.height ? 0 : 1;
    for (std::size_t i = 0; largest < 1 && i < a.rgba.size(); ++i)
        if (i % 4 != 3)
            largest = std::max(largest, double(std::abs(a.rgba.data()[i] - b.rgba.data()[i])));
    return largest;
}

} // namespace suffuse::test
