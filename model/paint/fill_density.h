// The density of a fill at a point, quickly, for tools and panels. render/probe.h has the exact figures.
#pragma once

#include "model/area/boundary.h"
#include "model/painting/stroke.h"

namespace suffuse {

/// φ_fill of a stroke at a time, as a function of the point. Whoever asks for many points keeps the object, since the
/// boundary of the area is found when it is made.
class DensityOfFill {
public:
    /// The stroke must have a fill that is there.
    DensityOfFill(const Stroke &stroke, Microseconds T);
    /// The same for points that are near one: the boundary is found there alone.
    DensityOfFill(const Stroke &stroke, Microseconds T, Point near);

    struct Value {
        double density = 0;
        double place = 0; ///< of what comes to the point, between the colours of the gradient, in [0, 1]
    };
    /// At a point relative to the stroke's origin, right to about a thousandth of ρ.
    Value operator()(Point fromOrigin) const;

private:
    DensityOfFill(const Stroke &stroke, Microseconds T, AreaBoundary boundary);

    Fill m_fill;
    double m_a, m_b, m_c; ///< u = a·x + b·y, v = c·y, in which the Gaussian is e^(−u² − v²)
    Rect m_reach;         ///< as influenceOf gives it, from the origin
    AreaBoundary m_boundary;
    std::vector<double> m_ends; ///< where arcs begin and end, in order
};

/// φ_fill of a stroke at a canvas point; 0 where it has no fill yet.
double fillDensityAt(const Stroke &stroke, Microseconds T, Point point);

} // namespace suffuse
