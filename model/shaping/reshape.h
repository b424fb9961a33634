// Reshaping a stroke: nodes, handles, splits and joins. All functions are pure; where `problemOf` of the stroke is
// empty, that of the result is. Segments that a function does not touch keep their bits. A result never holds a segment
// whose control points are one point: what would make one is left undone.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/stroke_places.h"
#include "model/shaping/chains.h"

#include <optional>
#include <vector>

namespace suffuse {

/// Canvas units. The node must exist.
Point nodePosition(const Stroke &stroke, int node);
/// The kind of an inner node; the ends of chains have no opposite handles and count as corners.
NodeKind nodeKind(const Stroke &stroke, int node);
/// The handle on the side of the segment after (or before) the node, canvas units; none beyond an end. It may lie on
/// the node itself (drawn in).
std::optional<Point> handlePosition(const Stroke &stroke, int node, bool after);
/// The inner nodes at which the curve's direction breaks, whatever their kind.
std::vector<int> cornersOf(const Stroke &stroke);

/// The place nearest to a point, and how far away it is (canvas units), if `distance` is given.
CurvePlace nearestPlace(const Stroke &stroke, Point point, double *distance = nullptr);

/// New nodes by exact splits. A place nearer than float32 resolution to a node makes none. New nodes are smooth; a
/// symmetric node beside one becomes smooth. `sources`: for each segment of the result, the index of that it came from;
/// so node k is new where sources[k] = sources[k − 1].
Stroke withNodes(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources = nullptr);
/// Without some nodes: the segments beside an inner one become one, which keeps the tangents at its ends and the shape
/// as far as one cubic can; what comes of an exact split becomes what it was. Values are means by length. An end node
/// goes with its segment, and a chain of which fewer than two nodes would be left goes as a whole. Where no chain would
/// be left, the stroke stays as it is. `sources`: as above, the first.
Stroke withoutNodes(const Stroke &stroke, const std::vector<int> &nodes, std::vector<int> *sources = nullptr);
/// Segments first … last replaced by one cubic that goes on smoothly from its neighbours; values are means by length.
/// Where they belong to several chains these become one.
Stroke withBridge(const Stroke &stroke, int first, int last);
/// From end to start, the chains too. Every segment keeps its values, its time of birth among them.
Stroke reversed(const Stroke &stroke);
/// Stroke b put to an end of stroke a (`aAtEnd`: its end, else its start) with one of its ends; a keeps its direction,
/// id, name, style and mixing, and b's segments keep their style as their own. Ends that lie apart are bridged smoothly
/// with the values of a's end. None if b cannot be held to float32 at a's origin.
std::optional<Stroke> joined(const Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd);
/// The same in place; false, and nothing done, if b cannot be held.
bool join(Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd);
/// The end joined to the start by a smooth bridge with the end's values; none if they lie on each other. Of a stroke of
/// several chains: the last one's end and the first one's start, which so become one.
std::optional<Stroke> closed(const Stroke &stroke);
/// Stroke b put to stroke a, an end of one of its chains at an end of one of a's, as above; b's other chains become
/// chains of a. None if b cannot be held, or a node is no end.
std::optional<Stroke> joinedAt(const Stroke &a, int aNode, const Stroke &b, int bNode);
/// The ends of two chains of a stroke joined, so that they become one chain, or of one chain, which is closed. None if
/// there is nothing to join.
std::optional<Stroke> joinedWithin(const Stroke &stroke, int node, int other);

/// Moves nodes, their handles along with them. All nodes: moves the origin alone.
Stroke withNodeMoved(const Stroke &stroke, const std::vector<int> &nodes, Point by);
/// Puts a handle somewhere. A smooth node's opposite handle turns, a symmetric one's mirrors.
Stroke withHandleMoved(const Stroke &stroke, int node, bool after, Point to);
/// Sets the kind of nodes. Smooth and symmetric: turns their handles into one line where they are not; handles that are
/// drawn in come out by a third of the way to the next node; symmetric ones become equally long.
Stroke withNodeKind(const Stroke &stroke, const std::vector<int> &nodes, NodeKind kind);
/// Drags the point at p of a segment along by its two handles; the nodes stay, and keep their kind.
Stroke withCurveDragged(const Stroke &stroke, int segment, double p, Point by);

} // namespace suffuse
