// Sums of Gaussians and of their slopes at a point, many at a time.
#pragma once

#include <array>
#include <cstddef>

namespace suffuse::contours {

/// What a sum may be weighted by, at most.
inline constexpr int mostChannels = 4;
/// Gaussians are read in runs of so many; weights of 0 fill the last one up.
inline constexpr std::size_t gaussRun = 16;

/// Gaussians as columns of floats, relative to a place nearby: 2^(a·dx² + 2b·dx·dy + c·dy²).
struct GaussColumns {
    const float *x = nullptr, *y = nullptr, *a = nullptr, *b = nullptr, *c = nullptr;
    std::array<const float *, mostChannels> weight{};
    std::size_t count = 0; ///< a multiple of gaussRun
};

/// For each channel the sum at a point, and its slopes along x and y.
using GaussSums = std::array<std::array<float, 3>, mostChannels>;
GaussSums gaussSums(const GaussColumns &columns, int channels, float x, float y);

} // namespace suffuse::contours
