// Where what is selected is seen.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <set>

namespace suffuse {

/// The box of what is seen of the selected strokes when they are dry (`seenBox`), or of their selected segments, canvas
/// units; of what lays no paint, the box of its curves. Empty if nothing is selected.
Rect seenSelection(const Painting &painting, const Selection &selection);

/// The box of the curves that meet at the nodes, canvas units; empty without nodes.
Rect curvesAround(const Painting &painting, const std::set<NodeRef> &nodes);

} // namespace suffuse
