// Reshapes strokes: nodes, handles, splits and joins. All functions are pure. Where `problemOf` of the stroke is empty,
// that of the result is, too. Segments that a function does not touch keep their bits. A result never has a segment
// whose control points are one point: a change that would make one is left undone.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/stroke_places.h"
#include "model/shaping/curves/chains.h"

#include <optional>
#include <vector>

namespace suffuse {

/// The place of a node in canvas units. The node must exist.
Point nodePosition(const Stroke &stroke, int node);
/// The kind of an inner node, or of the seam of a closed chain. Where the curve's direction breaks it is a corner,
/// whatever is stored. The ends of other chains have no opposite handles, and count as corners.
NodeKind nodeKind(const Stroke &stroke, int node);
/// The handle on the side of the segment after (or before) the node, canvas units; no value beyond an end. It may lie
/// on the node itself (drawn in).
std::optional<Point> handlePosition(const Stroke &stroke, int node, bool after);
/// The inner nodes at which the curve's direction breaks, whatever their kinds say.
std::vector<int> cornersOf(const Stroke &stroke);

/// The place of the curve that is nearest to a point. `distance` gets how far away it is (canvas units).
CurvePlace nearestPlace(const Stroke &stroke, Point point, double *distance = nullptr);

/// The stroke with new nodes, made by exact splits. A place that is nearer than float32 resolution to a node makes
/// none. New nodes are smooth; a symmetric node beside one becomes smooth. `sources` gets, for each segment of the
/// result, the index of the segment that it came from; so node k is new where sources[k] = sources[k − 1].
Stroke withNodes(const Stroke &stroke, const std::vector<CurvePlace> &places, std::vector<int> *sources = nullptr);
/// The stroke without some of its nodes. The segments beside an inner node become one segment, which keeps the tangents
/// at its ends, and the shape as far as one cubic can. What came from an exact split becomes what it was. Values are
/// means by length. An end node goes with its segment, and a chain that would have fewer than two nodes goes as a
/// whole. If no chain would be left, the stroke stays as it is. `sources` gets the index of the first segment that each
/// segment came from.
Stroke withoutNodes(const Stroke &stroke, const std::vector<int> &nodes, std::vector<int> *sources = nullptr);
/// Replaces the segments first … last by one cubic that goes on smoothly from its neighbours. Values are means by
/// length. If the segments belong to several chains, these become one.
Stroke withBridge(const Stroke &stroke, int first, int last);
/// The stroke from its end to its start, its chains included. Each segment keeps its values and its time of birth.
Stroke reversed(const Stroke &stroke);
/// Joins one end of stroke b to an end of stroke a: to its end if `aAtEnd`, else to its start. Direction, id, name,
/// style and mixing are those of a; b's segments keep their style as their own. Ends that lie apart are bridged
/// smoothly, with the values of a's end. No value if b cannot be stored in float32 relative to a's origin.
std::optional<Stroke> joined(const Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd);
/// Does the same in place. Returns false, and does nothing, if b cannot be stored so.
bool join(Stroke &a, bool aAtEnd, const Stroke &b, bool bAtEnd);
/// The stroke with its end joined to its start by a smooth bridge that has the values of the end. No value if they lie
/// on each other. In a stroke of several chains, the end of the last one is joined to the start of the first one, and
/// the two become one chain.
std::optional<Stroke> closed(const Stroke &stroke);
/// Joins an end of one of b's chains to an end of one of a's, as `joined` does. The other chains of b become chains of
/// a. No value if b cannot be stored, or a node is no end.
std::optional<Stroke> joinedAt(const Stroke &a, int aNode, const Stroke &b, int bNode);
/// Stroke b's chains as further chains of stroke a, in a's place and with the style that they had. None where a cannot
/// hold them.
std::optional<Stroke> combined(const Stroke &a, const Stroke &b);
/// Joins the ends of two chains of a stroke, which become one chain, or both ends of one chain, which becomes closed.
/// No value if there is nothing to join.
std::optional<Stroke> joinedWithin(const Stroke &stroke, int node, int other);

/// The stroke with each closed chain begun elsewhere that has its seam among the nodes, which get their new numbers; a
/// seam is then an inner node. Chains stay of which all nodes are among them, or the parts of which are not born at one
/// time, since segments are in the order of time.
Stroke withSeamsBeside(const Stroke &stroke, std::vector<int> &nodes);

/// Moves nodes together with their handles; a closed chain stays closed. If these are all nodes, only the origin moves.
Stroke withNodeMoved(const Stroke &stroke, const std::vector<int> &nodes, Point by);
/// Moves a handle to a place. The opposite handle of a smooth node turns with it, that of a symmetric node mirrors it
/// (see `nodeKind`).
Stroke withHandleMoved(const Stroke &stroke, int node, bool after, Point to);
/// Sets the kind of nodes. For smooth and symmetric ones the two handles are turned into one line if they are not in
/// one; handles that are drawn in come out by a third of the way to the next node; those of symmetric nodes become
/// equally long.
Stroke withNodeKind(const Stroke &stroke, const std::vector<int> &nodes, NodeKind kind);
/// Drags the point at parameter p of a segment by moving its two handles. The point gets exactly where it is dragged
/// to. The nodes stay, and keep their kinds; only within an eighth of the segment from a node, that node comes along in
/// part.
Stroke withCurveDragged(const Stroke &stroke, int segment, double p, Point by);

} // namespace suffuse
