// What reshaping, erasing and transforming have in common: exact splits, held to float32.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/stroke_places.h"

#include <array>
#include <vector>

namespace suffuse {

/// Part of a stroke's segment between two of its parameters.
struct Piece {
    int source = 0; ///< index of the segment
    double from = 0;
    double to = 1;
    Segment segment;
};

/// The part of a cubic between two parameters, from ≤ to; exact but for the last bits of double precision.
Cubic partOf(const Cubic &cubic, double from, double to);
/// Those of the parameters that lie in (0, 1) and farther than float32 resolution from each other and from the ends.
std::vector<double> distinct(std::vector<double> ps, const Cubic &curve);
/// The stroke's segments, each split at parameters that are `distinct`. Segments without any come as they are.
std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<std::vector<double>> &parameters);
/// The same for places in any order, near to each other or not.
std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<CurvePlace> &places);
/// The place as a node, if it is nearer than float32 resolution to one; −1 if not.
int nodeAt(const Stroke &stroke, const CurvePlace &place);

/// The control points as offsets from the stroke's origin, in double precision: exact.
Cubic offsetsOf(const Segment &segment);
std::array<Offset, 4> toOffsets(const Cubic &cubic);

/// All four control points are one point: without length, and so without density.
bool isPoint(const Segment &segment);
/// A few steps of float32 at the largest of these offsets: what is nearer is the same place.
double resolutionAt(const Cubic &offsets);

/// The curve's direction at its start (end), also where handles are drawn in; length 1, or 0 for a point.
Point startDirection(const Cubic &cubic);
Point endDirection(const Cubic &cubic);
/// Of length 1; 0 stays 0.
Point unit(Point vector);

/// A cubic from one point in a direction to another in a direction (both along the way), as round as an arc.
Cubic arcBetween(Point from, Point direction, Point to, Point arrival);

/// The same segment with values that are means by length; style, rewetting and the node's kind are those of `values`.
void setMeanValues(Segment &result, const std::vector<const Segment *> &of);

/// `result`, or the stroke that it was made of where it left the domains.
Stroke validOr(Stroke result, const Stroke &before);

} // namespace suffuse
