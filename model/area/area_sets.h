// Areas with and without each other.
#pragma once

#include "model/area/area_effort.h"
#include "model/geometry/geometry.h"
#include "model/painting/fill.h"

#include <vector>

namespace suffuse {

/// An area as closed loops that run around it once: the winding number is 1 inside and 0 outside, however the loops
/// touch. Parts of curves stay curves.
struct Area {
    std::vector<std::vector<Cubic>> loops;

    bool isEmpty() const { return loops.empty(); }
    Rect box() const; ///< of the control points
    std::size_t curves() const;
};

/// How large it is, in square units.
double sizeOf(const Area &area);

/// What lies inside closed loops of any kind.
Area areaOf(const std::vector<std::vector<Cubic>> &loops, FillRule rule, AreaEffort *effort = nullptr);

Area intersection(const Area &a, const Area &b, AreaEffort *effort = nullptr);
/// What lies in a and not in b.
Area difference(const Area &a, const Area &b, AreaEffort *effort = nullptr);
Area united(const Area &a, const Area &b, AreaEffort *effort = nullptr);
/// What lies in one of them alone.
Area exclusion(const Area &a, const Area &b, AreaEffort *effort = nullptr);

} // namespace suffuse
