// A Gaussian blur whose width is another one at each pixel.
#pragma once

#include <atomic>
#include <span>
#include <vector>

namespace suffuse::curves {

/// `picture` has three values a pixel, row by row, and `deviation` the standard deviation of the blur at each pixel, in
/// pixels. Each pixel becomes the mean of what lies around it, weighted by its own Gaussian; what lies beyond the
/// picture does not count. Wide Gaussians are taken of pictures of half the size, a quarter and so on, whose means over
/// pixels are accounted for.
std::vector<float> blurredBy(const std::vector<float> &picture, std::span<const float> deviation, int width, int height,
                             int threads = 0, const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse::curves
