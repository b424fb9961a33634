#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// How strongly an input acts: a smooth curve through its points, which never overshoots them (a monotone cubic).
/// Before the first and after the last point it is constant. Its points go from left to right, and both coordinates are
/// in [0, 1].
struct ResponseCurve {
    static constexpr std::size_t mostPoints = 16;

    std::vector<Offset> points{{0, 0}, {1, 1}};

    /// The value of the curve, in [0, 1]. x is clamped to [0, 1].
    double at(double x) const;
    /// Whether there are two to `mostPoints` points, in order and in their domain.
    bool isValid() const;

    friend bool operator==(const ResponseCurve &, const ResponseCurve &) = default;
};

} // namespace suffuse
