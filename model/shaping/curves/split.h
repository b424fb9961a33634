// What reshaping, erasing and transforming have in common: exact splits, rounded to float32.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/stroke_places.h"

#include <array>
#include <vector>

namespace suffuse {

/// The part of a stroke's segment between two of its parameters.
struct Piece {
    int source = 0; ///< the index of the segment
    double from = 0;
    double to = 1;
    Segment segment;
};

/// The part of a cubic between two parameters, from ≤ to. It is exact except for the last bits of double precision.
Cubic partOf(const Cubic &cubic, double from, double to);
/// Those of the parameters that lie in (0, 1) and are farther than float32 resolution from each other and from the
/// ends.
std::vector<double> distinct(std::vector<double> ps, const Cubic &curve);
/// A stroke's segments, each split at its parameters, which must be `distinct`. A segment without any is one piece.
std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<std::vector<double>> &parameters);
/// The same for places in any order, which may lie near to each other.
std::vector<Piece> piecesOf(const Stroke &stroke, const std::vector<CurvePlace> &places);
/// The node at a place, if it is nearer to one than float32 resolution; −1 otherwise.
int nodeAt(const Stroke &stroke, const CurvePlace &place);

/// The control points rounded to float32.
std::array<Offset, 4> toOffsets(const Cubic &cubic);

/// Whether all four control points are one point. Such a segment has no length, and so no density.
bool isPoint(const Segment &segment);
/// A few steps of float32 at the largest of these offsets. Points that are nearer to each other are one place.
double resolutionAt(const Cubic &offsets);

/// The curve's direction at its start (or end), also where handles are drawn in. Its length is 1, or 0 for a point.
Point startDirection(const Cubic &cubic);
Point endDirection(const Cubic &cubic);
/// The vector with length 1; 0 stays 0.
Point unit(Point vector);

/// A cubic from one point in a direction to another point in a direction (both along the way), as round as an arc.
Cubic arcBetween(Point from, Point direction, Point to, Point arrival);

/// Gives a segment means by length of several. Style, rewetting and the node's kind stay those of the segment itself.
void setMeanValues(Segment &result, const std::vector<const Segment *> &of);

/// Returns `result` or, where it has left the domains, the stroke that it was made of.
Stroke validOr(Stroke result, const Stroke &before);

} // namespace suffuse
