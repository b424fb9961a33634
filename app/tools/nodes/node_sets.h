// Nodes of a painting, as the Segments tool takes them together.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <set>

namespace suffuse {

struct View;

/// The nodes at both ends of segments.
std::set<NodeRef> nodesAround(const Painting &painting, const std::set<SegmentRef> &segments);
/// Nodes with the other ends of closed chains: a seam is one node for people.
std::set<NodeRef> withSeams(const Painting &painting, const std::set<NodeRef> &nodes);
/// The nodes of strokes that lie within a rectangle of a view's pixels; locked and hidden strokes have none.
std::set<NodeRef> nodesWithin(const Painting &painting, const std::set<StrokeId> &strokes, const View &view,
                              const Rect &pixels);
/// The strokes that nodes belong to.
std::set<StrokeId> strokesOf(const std::set<NodeRef> &nodes);
/// Leaves out the nodes that are not there, or not on any of the strokes.
void keepNodesOf(const Painting &painting, const std::set<StrokeId> &strokes, std::set<NodeRef> &nodes);

} // namespace suffuse
