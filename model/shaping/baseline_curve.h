// Lengths along a chain of curves.
#pragma once

#include "model/geometry/geometry.h"

#include <vector>

namespace suffuse {

/// A chain of cubics by the length along it.
class BaselineCurve {
public:
    explicit BaselineCurve(const std::vector<Cubic> &curves);

    double length() const { return m_at.empty() ? 0 : m_at.back().length; }
    struct Place {
        Point point;
        Point direction{1, 0}; ///< of length 1
    };
    /// The place at a length along the chain; before its start and behind its end on a straight line.
    Place at(double length) const;
    /// The length near another one at which a point lies straight beside the chain. Of a corner's outer side it is the
    /// corner's.
    double besides(Point point, double near) const;

private:
    struct Step {
        double length = 0;
        std::size_t curve = 0;
        double t = 0;
    };
    Place placeOn(std::size_t curve, double t) const;

    std::vector<Cubic> m_curves; ///< those that have a length
    std::vector<Step> m_at;
};

} // namespace suffuse
