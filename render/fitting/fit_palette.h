// A fit with few paints.
#pragma once

#include "render/fitting/fit_stroke.h"

#include <cstdint>

namespace suffuse::fitting {

/// The paints of a fit, and which stroke has which. While it is empty, each stroke has a colour of its own.
class FitPalette {
public:
    FitPalette() = default;
    /// Finds up to `paints` colours for those of strokes by k-means in OKLab, each stroke counting by the area that it
    /// covers, and gives each stroke the nearest one.
    FitPalette(std::vector<FitStroke> &strokes, StyleKind style, int paints, std::uint64_t seed);

    bool isEmpty() const { return m_paints.empty(); }
    /// The paints in use, RYB, the most used first.
    std::vector<Colour> paints() const;
    /// Puts in place of each stroke's slope by its colour the sum over all strokes of its paint.
    void share(std::vector<StrokeSlope> &slopes) const;
    /// Makes the colours of the strokes of a paint equal again.
    void apply(std::vector<FitStroke> &strokes);
    /// Forgets strokes that are gone: `kept[i]` is the former place of stroke i.
    void keep(const std::vector<std::size_t> &kept);

private:
    std::vector<std::array<double, 3>> m_paints;
    std::vector<std::size_t> m_paintOf; ///< of each stroke
};

} // namespace suffuse::fitting
