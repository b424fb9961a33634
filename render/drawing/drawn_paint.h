// What colour a path of a drawing has.
#pragma once

#include "render/contours/contours.h"

#include <array>
#include <vector>

namespace suffuse {

/// sRGB-encoded red, green and blue, and how much of a band's opacity there is.
using DrawnColour = std::array<double, 4>;

/// One colour, or one that changes evenly between stops along a line, as SVG's linear gradients do.
struct DrawnPaint {
    struct Stop {
        double place = 0; ///< [0, 1], ascending
        DrawnColour colour{};
    };
    std::vector<Stop> stops; ///< one: the same colour everywhere
    Point from, to;          ///< canvas units; of a gradient

    bool isGradient() const { return stops.size() > 1; }
    DrawnColour at(Point canvas) const;
};

/// The colour of a stroke whose bands are these. A gradient of its fill is itself; other colours that change become the
/// gradient that comes nearest to them.
DrawnPaint paintOf(const contours::StrokeContours &contours, const std::vector<contours::Band> &bands);

} // namespace suffuse
