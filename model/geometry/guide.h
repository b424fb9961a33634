// A line that helps to draw straight and in line.
#pragma once

namespace suffuse {

/// A guide goes through the whole canvas, upright or level.
struct Guide {
    bool upright = false;
    double place = 0; ///< its x, where it is upright, else its y; canvas units
    friend bool operator==(const Guide &, const Guide &) = default;
};

} // namespace suffuse
