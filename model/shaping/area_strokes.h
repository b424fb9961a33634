// Filled strokes as areas, and areas as filled strokes.
#pragma once

#include "model/area/area_sets.h"
#include "model/painting/stroke.h"

#include <optional>
#include <vector>

namespace suffuse {

/// What areas become together.
enum class AreaSet {
    Union,        ///< what lies in any of them
    Difference,   ///< what lies in the first one alone
    Intersection, ///< what lies in all of them
    Exclusion,    ///< what lies in an odd number of them
    Division      ///< the first one, cut along the outlines of the others
};

/// What lies inside closed loops, if two computations agree about it.
std::optional<Area> certainArea(const std::vector<std::vector<Cubic>> &outline, FillRule rule,
                                AreaEffort *effort = nullptr);

/// The areas of filled strokes, as offsets from the origin of the first one. Places that float32 cannot tell apart at
/// their distance from that origin are one, so that outlines which touch in the picture touch in numbers. No value where
/// outlines lie on each other in such a way that no two computations agree.
std::optional<std::vector<Area>> areasOf(const std::vector<StrokePtr> &strokes, AreaEffort *effort = nullptr);

/// The set of one or more areas. A division has a part for each combination of areas, all others have at most one. No
/// value where the sizes of what is computed do not add up.
std::optional<std::vector<Area>> setOf(const std::vector<Area> &areas, AreaSet how, AreaEffort *effort = nullptr);

/// The area with outlines of few nodes, none of which is farther away than `tolerance`. Corners are what turns by more
/// than about 55° within a few steps; `step` is in the unit of the area. An outline of very many steps stays as it is.
Area drawnAnew(const Area &area, double step, double tolerance);

/// A filled stroke with another area, offsets from its origin. Its new segments have the values of those that lay where
/// they lie, of the stroke or of others from which the area was made; what takes paint away stays. No value where
/// float32 leaves nothing of the area, or it reaches too far.
std::optional<Stroke> withArea(const Stroke &stroke, const Area &area, const std::vector<StrokePtr> &others = {});

/// Appends what takes paint away from another stroke. Returns false, and leaves the stroke as it was, if that reaches too
/// far.
bool appendLifts(Stroke &stroke, const Stroke &other);

} // namespace suffuse
