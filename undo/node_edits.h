// Edits of nodes and curves. As in edits.h: an empty Edit where there is nothing to do, locked strokes left alone.
// Selected segments stay selected: both parts of one that is split, and what one becomes part of.
#pragma once

#include "model/shaping/reshape.h"
#include "undo/edits.h"

#include <limits>
#include <map>

namespace suffuse {

using PlacesOfStrokes = std::map<StrokeId, std::vector<CurvePlace>>;

/// Puts in strokes that take the place of those with the same ids. What drags push: the state made from the one at the
/// press, whatever stands in the document now. Strokes that are there already, to the bit, are left out.
Edit replaceStrokes(const Document &document, std::vector<Stroke> strokes);

Edit insertNodes(const Document &document, const PlacesOfStrokes &places);
/// Inner nodes: their two segments become one. End nodes go with their segment; strokes of which less than a segment
/// would be left go as a whole.
Edit deleteNodes(const Document &document, const std::set<NodeRef> &nodes);
/// Each run of these segments becomes one that goes on smoothly from its neighbours.
Edit bridgeSegments(const Document &document, const std::set<SegmentRef> &segments);
Edit moveNodes(const Document &document, const std::set<NodeRef> &nodes, Point by);
Edit setNodeKind(const Document &document, const std::set<NodeRef> &nodes, NodeKind kind);

/// Cuts strokes into strokes of their own, or chains, at places or nodes. The first part keeps the id; all are selected
/// if the stroke was. Parts stand together in the order.
Edit splitAt(Document &document, const PlacesOfStrokes &places, Leaves leaves = Leaves::Strokes);
Edit splitAtNodes(Document &document, const std::set<NodeRef> &nodes, Leaves leaves = Leaves::Strokes);
/// Takes away what lies nearer than `radius` to the path and is painted by T; of all visible strokes if `targets` is
/// empty.
Edit eraseAlong(Document &document, const std::set<StrokeId> &targets, const std::vector<Point> &path, double radius,
                Microseconds T = std::numeric_limits<Microseconds>::max(), Leaves leaves = Leaves::Strokes);

/// Joins the ends of two chains, of two strokes or of one. The upper stroke's place, name and style stay.
Edit joinNodes(const Document &document, NodeRef a, NodeRef b);
/// Joins the selected strokes to the topmost one, each time the one that has the end nearest to its ends.
Edit joinSelection(const Document &document);
Edit reverseSelection(const Document &document);
/// Goes on with a stroke at its end (or start): the segments of `added`, from its start on, with the values they have.
Edit extendStroke(const Document &document, StrokeId stroke, bool atEnd, const Stroke &added);

} // namespace suffuse
