// Gaussians in double precision, found by place: what a stroke's segments are to whoever asks for their density at many
// points, and for its slope.
#pragma once

#include "model/geometry/geometry.h"
#include "render/contours/gauss_sums.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace suffuse::contours {

/// weight · e^(−(a·dx² + 2b·dx·dy + c·dy²)), which counts as 0 where the exponent is beyond `cut`.
struct Gauss {
    Point at; ///< offset from the stroke's origin, canvas units
    double a = 0, b = 0, c = 0;
    double weight = 0;
    double cut = 0;
    double spread = 0;                    ///< the smaller axis
    double reach = 0;                     ///< how far it counts along the longer one
    double halfWidth = 0, halfHeight = 0; ///< of the box in which it counts
    std::uint32_t row = 0;                ///< of what it is a part
};

/// A number with its slope.
struct Sloped {
    double value = 0;
    Point slope;

    void add(double weight, const Sloped &other)
    {
        value += weight * other.value;
        slope = slope + weight * other.slope;
    }
};

/// Sums over Gaussians, each with weights of its own.
using ChannelSums = std::array<Sloped, mostChannels>;
/// By what the weights of the Gaussians of a row are multiplied, for each channel.
using ChannelGains = std::array<double, mostChannels>;

/// Gaussians of similar spreads in a grid of squares that are as wide as two spreads.
class GaussBins {
public:
    /// `gains` are those of the rows.
    GaussBins(std::vector<Gauss> all, const std::vector<ChannelGains> &gains, int channels);

    const std::vector<Gauss> &all() const { return m_all; }
    /// Those that may count at a point.
    std::span<const std::uint32_t> near(Point p) const;
    /// Adds the sums at a point: in floats relative to the square, unless its Gaussians are so wide that digits are
    /// missed.
    void addSums(Point p, ChannelSums &sums) const;

private:
    struct Bin {
        std::uint32_t begin = 0, end = 0; ///< in m_indices
        std::uint32_t column = 0; ///< in m_columns, where each column begins after as many as the one before has
    };
    const Bin *binAt(Point p) const;
    void makeColumns();

    std::vector<Gauss> m_all;
    std::vector<ChannelGains> m_gains;
    int m_channels;
    bool m_wide = false;
    double m_side = 1;
    std::unordered_map<std::uint64_t, Bin> m_bins;
    std::vector<std::uint32_t> m_indices;
    std::vector<float> m_columns; ///< x, y, a, b, c and the weights of each bin
};

/// What a Gaussian is at a point.
Sloped valueAt(const Gauss &gauss, Point p);

} // namespace suffuse::contours
