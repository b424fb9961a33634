// The area that a pen of constant width covers along lines, as a stroke of SVG or PostScript does.
#pragma once

#include "model/area/area_effort.h"
#include "model/geometry/geometry.h"

#include <cstdint>
#include <vector>

namespace suffuse {

enum class LineCap : std::uint8_t { Butt, Round, Square };
/// A miter that would be longer than its limit is a bevel.
enum class LineJoin : std::uint8_t { Miter, Round, Bevel };

struct Pen {
    double width = 1;
    LineCap cap = LineCap::Butt;
    LineJoin join = LineJoin::Miter;
    double miterLimit = 4;      ///< the greatest length of a miter by the width, ≥ 1
    std::vector<double> dashes; ///< lengths of dashes and gaps by turns, none below 0; a sum of 0 means no dashes
    double dashOffset = 0;      ///< how far into the pattern a line begins
};

/// Curves each of which starts where the one before it ends; of a closed line the last one ends where the first starts.
struct PenLine {
    std::vector<Cubic> curves; ///< none for a point, of which only round and square caps show
    bool isClosed = false;
    Point point;           ///< the place of a line without curves
    Point direction{1, 0}; ///< which way a point looks, a unit vector
};

/// The outline as closed loops: what they wind around (FillRule::NonZero) is the area within `tolerance`. Loops overlap
/// and cross each other, but nowhere do they run around a part of the area in opposite directions.
std::vector<std::vector<Cubic>> penOutline(const std::vector<PenLine> &lines, const Pen &pen, double tolerance,
                                           AreaEffort *effort = nullptr);

/// Divides a line into its dashes, each as long as the pattern says, by arc length. Where the last dash of a closed
/// line meets its first one they are one. A line of more than `most` dashes, or
/// of more than the effort allows, stays whole.
std::vector<PenLine> dashesOf(const PenLine &line, const std::vector<double> &pattern, double offset,
                              std::size_t most = 100'000, AreaEffort *effort = nullptr);

} // namespace suffuse
