// Drawing over a part of a stroke: that part follows the new line.
#pragma once

#include "model/shaping/reshape.h"

namespace suffuse {

/// The part of a chain that a line takes the place of: from `from` to `to` along the stroke.
struct RedrawnPart {
    CurvePlace from, to;
    bool reversed = false;  ///< the line was drawn against the stroke's direction
    bool joinsStart = true; ///< it goes on from what is before the part; else it is the chain's start
    bool joinsEnd = true;   ///< and goes on to what is behind it; else it is the chain's end
};

/// What a line (canvas units, two points or more) would redraw of a stroke. An end of the line is on the stroke where
/// that is no farther than `reach`. With both ends on it the part between is meant, and with one the part from there on
/// to the chain's end that the line goes towards. None where neither is, or both are at one place. What takes paint
/// away is not drawn over.
std::optional<RedrawnPart> partToRedraw(const Stroke &stroke, const std::vector<Point> &line, double reach);

/// What the redrawn part has of the line, and what of the stroke.
enum class RedrawValues {
    Kept, ///< values and times that it had, by its arc length
    Line  ///< those of the line
};

/// The stroke with a part of it replaced by the curve of `line`, which bends into what is before and behind the part
/// within `reach`. Where the line leaves against the stroke's direction there is a corner. `sources`: for each segment
/// of the result the index of that it came from; −1: from the line. None where it cannot be held.
std::optional<Stroke> redrawn(const Stroke &stroke, const RedrawnPart &part, const Stroke &line, double reach,
                              RedrawValues values, std::vector<int> *sources = nullptr);

/// Points along all of a stroke's curves, canvas units.
std::vector<Point> pointsAlong(const Stroke &stroke);

} // namespace suffuse
