// Redraws a part of a stroke, which then follows a new line.
#pragma once

#include "model/shaping/nodes/reshape.h"

namespace suffuse {

/// The part of a chain that a line replaces: from `from` to `to` along the stroke.
struct RedrawnPart {
    CurvePlace from, to;
    bool reversed = false;  ///< whether the line was drawn against the stroke's direction
    bool joinsStart = true; ///< whether it continues what is before the part; otherwise it begins the chain
    bool joinsEnd = true;   ///< whether it goes on to what is behind the part; otherwise it ends the chain
};

/// The part of a stroke that a line (canvas units, two points or more) would redraw. An end of the line counts as on
/// the stroke if it is no farther away than `reach`. With both ends on the stroke, it is the part between them; with
/// one, the part from there to the end of the chain towards which the line goes. No value where neither end is on the
/// stroke, or both are at one place. What takes paint away cannot be redrawn.
std::optional<RedrawnPart> partToRedraw(const Stroke &stroke, const std::vector<Point> &line, double reach);

/// Where the values of the redrawn part come from.
enum class RedrawValues {
    Kept, ///< from the part itself, with its times, by its arc length
    Line  ///< from the line
};

/// The stroke with a part of it replaced by the curve of `line`, which bends within `reach` into what is before and
/// behind the part. If the line sets out against the stroke's direction, there is a corner. `sources` gets, for each
/// segment of the result, the index of the segment that it came from, or −1 if it came from the line. No value where
/// the result would leave the domains of a stroke.
std::optional<Stroke> redrawn(const Stroke &stroke, const RedrawnPart &part, const Stroke &line, double reach,
                              RedrawValues values, std::vector<int> *sources = nullptr);

/// Points along all curves of a stroke, canvas units.
std::vector<Point> pointsAlong(const Stroke &stroke);

} // namespace suffuse
