// The boundary of what lies inside an outline that may cross and overlap itself.
#pragma once

#include "model/area/area_effort.h"
#include "model/area/rising_arc.h"
#include "model/painting/fill.h"

namespace suffuse {

/// A part of the boundary: what lies right of it (greater x) is inside (+1), or what lies left of it (−1).
struct BoundaryArc {
    RisingArc arc;
    int enters = 1;
    friend bool operator==(const BoundaryArc &a, const BoundaryArc &b)
    {
        return a.enters == b.enters && a.arc.curve.p == b.arc.curve.p;
    }
};

/// A level part of it: inside begins (+1) or ends (−1) with greater y.
struct BoundaryFlat {
    double y = 0, left = 0, right = 0;
    int jump = 0;
    friend bool operator==(const BoundaryFlat &, const BoundaryFlat &) = default;
};

/// Whatever the outline is, on every level line the arcs enter and leave by turns, and where arcs begin and end the
/// flats join them. So a number that is summed along level lines is right within rounding.
struct AreaBoundary {
    std::vector<BoundaryArc> arcs; ///< in the order of the outline
    std::vector<BoundaryFlat> flats;
};

/// Finds it for closed loops of curves (see closedOutline). Where the outline crosses itself arcs are cut; all others
/// stay whole, and none depends on what lies elsewhere, but for being inside or not.
AreaBoundary boundaryOf(const std::vector<std::vector<Cubic>> &loops, FillRule rule, AreaEffort *effort = nullptr);
/// The same for what the loops run around at least so often (≥ 1).
AreaBoundary boundaryWhere(const std::vector<std::vector<Cubic>> &loops, int least, AreaEffort *effort = nullptr);

} // namespace suffuse
