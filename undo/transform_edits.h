// Moving, scaling, turning, aligning. As in edits.h: an empty Edit where there is nothing to do, locked strokes left
// alone.
#pragma once

#include "model/shaping/transform.h"
#include "undo/edits.h"

namespace suffuse {

/// The selected strokes mapped; none of them if one cannot be.
Edit transformSelection(const Document &document, const Affine &map, SpreadRule rule);
/// The same for a drag: the strokes as they were in `before` with the selection of then, whatever stands in the
/// document now; the identity brings them back.
Edit transformSelection(const Document &document, const Painting &before, const Selection &selection, const Affine &map,
                        SpreadRule rule);

/// Box of the selected, unlocked strokes' curves (`curveBox`), canvas units; empty without any.
Rect selectionBox(const Painting &painting, const Selection &selection);

enum class Align { Left, Centre, Right, Top, Middle, Bottom };
enum class AlignTo { Selection, Anchor, Biggest, Canvas };
/// Moves the selected strokes by the boxes of what is seen of them when dry (`seenBox`); groups that are selected as a whole move as one. `anchor`: the
/// stroke that, with its group, stays under `AlignTo::Anchor`; without it the topmost one does.
Edit align(const Document &document, Align how, AlignTo to = AlignTo::Selection, StrokeId anchor = 0);

enum class Axis { Horizontal, Vertical };
enum class Spacing { Gaps, Centres };
/// Three or more selected strokes (or whole groups), by the same boxes, with even gaps or centres between the two outermost, which stay.
Edit distribute(const Document &document, Axis axis, Spacing spacing);

} // namespace suffuse
