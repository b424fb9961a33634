// Edits of nodes and curves. A function returns an empty Edit if there is nothing to do, and leaves locked strokes
// alone. Selected segments stay selected: of one that is split both parts, and of one that is merged the segment that
// it has become a part of.
#pragma once

#include "model/shaping/nodes/reshape.h"
#include "model/shaping/nodes/soft_move.h"
#include "undo/edits.h"

#include <limits>
#include <map>

namespace suffuse {

using PlacesOfStrokes = std::map<StrokeId, std::vector<CurvePlace>>;

/// Puts strokes in the places of those with the same ids. Drags use it: their state is made from the strokes at the
/// press, whatever the document has now. Strokes that the document has already, to the last bit, are left out.
Edit replaceStrokes(const Document &document, std::vector<Stroke> strokes);

/// Adds nodes at places, by exact splits.
Edit insertNodes(const Document &document, const PlacesOfStrokes &places);
/// Deletes nodes. The two segments at an inner node become one. An end node goes with its segment. A stroke is removed
/// if less than a segment of it would be left. Where nodes are shown so far apart (`coarseNodes`), one of them stands
/// for the curve up to those beside it, and its bend goes (`withoutBends`).
Edit deleteNodes(const Document &document, const std::set<NodeRef> &nodes, double gap = 0);
/// Replaces each run of the segments by one that goes on smoothly from its neighbours.
Edit bridgeSegments(const Document &document, const std::set<SegmentRef> &segments);
/// Moves nodes, with their handles, by a vector in canvas units. The curve follows within `reach` (canvas units along
/// it; see `SoftMove`).
Edit moveNodes(const Document &document, const std::set<NodeRef> &nodes, Point by, double reach = 0,
               SoftMove::Ends ends = SoftMove::Ends::Follow);
Edit setNodeKind(const Document &document, const std::set<NodeRef> &nodes, NodeKind kind);

/// Cuts strokes, at places or nodes, into strokes or into chains. The first part keeps the id, and all parts are
/// selected if the stroke was. They stand together in the order.
Edit splitAt(Document &document, const PlacesOfStrokes &places, Leaves leaves = Leaves::Strokes);
/// Cuts strokes into chains along the line from a to b, which crosses them at the places. Fills fall into pieces along
/// it (`filledCut`).
Edit cutAlong(const Document &document, const PlacesOfStrokes &places, Point a, Point b);
Edit splitAtNodes(Document &document, const std::set<NodeRef> &nodes, Leaves leaves = Leaves::Strokes);
/// Takes away what lies nearer than `radius` to the path and is painted by T, of those of the targets that are visible.
Edit eraseAlong(Document &document, const std::set<StrokeId> &targets, const std::vector<Point> &path, double radius,
                Microseconds T = std::numeric_limits<Microseconds>::max(), Leaves leaves = Leaves::Strokes);

/// Joins the ends of two chains, which may be chains of one stroke. Place, name and style are those of the upper
/// stroke.
Edit joinNodes(const Document &document, NodeRef a, NodeRef b);
/// Joins the selected strokes to the topmost one, each time the one whose end is nearest to its ends.
Edit joinSelection(const Document &document);
/// The selected strokes become one, whose chains are theirs: their densities add up, and nothing mixes over anything.
/// It takes the place, name and mixing of the topmost one; styles stay. Filled strokes become one only where the
/// picture stays: all are filled alike, and their areas are apart. Else there is no edit, and `keepsFills` gets false.
Edit combineSelection(const Document &document, bool *keepsFills = nullptr);
/// The opposite: the chains of the selected strokes become strokes, each with what takes paint away from it.
Edit breakApart(Document &document);
/// What takes paint away goes, of the selected segments, or of the selected strokes without any; so paint comes back.
Edit removeErasures(const Document &document);
/// Reverses the direction of the selected strokes.
Edit reverseSelection(const Document &document);
/// Goes on with a stroke from an end of one of its chains: the segments of `added`, from its start on, with the values
/// they have.
Edit extendStroke(const Document &document, NodeRef end, const Stroke &added);

} // namespace suffuse
