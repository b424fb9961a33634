// Erasures as the Segments tool takes them: a chain of segments that take paint away is one thing.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <optional>

namespace suffuse {

/// The segments of the chain that a segment which takes paint away belongs to; none where it lays paint.
std::set<SegmentRef> erasureOf(const Painting &painting, const SegmentRef &segment);
/// All that one stroke of the eraser's hand has left: the erasure of that segment, and its parts in other visible,
/// unlocked strokes and behind gaps. Nothing in a painting says which parts belong together, so they are told by their
/// births and size. Parts further apart in time than an erasure takes to dry are parts of another one, unless they
/// touch, or the hand may have gone straight on from one to the other at its pace. An erasure that was doubled is a
/// thing of its own, and so is that of a copied stroke, also where the copy still lies upon it.
std::set<SegmentRef> wholeErasureOf(const Painting &painting, const SegmentRef &segment);
/// Whether an erasure of several parts, one of which has the segment, is what is selected.
bool isWholeErasure(const Painting &painting, const std::set<SegmentRef> &selected, const SegmentRef &segment);
/// What is selected after a click on what takes paint away, which means all of the erasure, in all strokes; a second
/// one means its part in this stroke. `add` leaves what was selected. None where the click means the segment: where it
/// lays paint, or that part is what is selected already.
std::optional<Selection> withErasure(const Painting &painting, const Selection &selected, const SegmentRef &hit,
                                     bool add);
/// A place on an erasure.
struct ErasurePlace {
    StrokeId stroke = 0;
    int segment = 0;
    double p = 0;
};
/// The place of an erasure of a visible, unlocked stroke that is nearest to a point, at most so many canvas units
/// away. `only`: of these strokes; null: of any.
std::optional<ErasurePlace> erasureAt(const Painting &painting, Point point, double reach,
                                      const std::set<StrokeId> *only = nullptr);
/// The nodes of the erasure that a node belongs to; none where it lies on paint.
std::set<NodeRef> nodesOfErasureAt(const Painting &painting, const NodeRef &node);
/// The nodes of those of the segments that take paint away.
std::set<NodeRef> nodesOfErasures(const Painting &painting, const std::set<SegmentRef> &segments);

} // namespace suffuse
