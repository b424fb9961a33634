// Edits that move, scale, turn and align. A function returns an empty Edit if there is nothing to do, and leaves locked
// strokes alone.
#pragma once

#include "model/shaping/transform.h"
#include "undo/edits.h"

namespace suffuse {

/// Maps the selected strokes. If one of them cannot be mapped, none is.
Edit transformSelection(const Document &document, const Affine &map, SpreadRule rule);
/// Does the same for drags: it maps the strokes as they were in `before`, with the selection of then, whatever the
/// document has now. So the identity brings them back.
Edit transformSelection(const Document &document, const Painting &before, const Selection &selection, const Affine &map,
                        SpreadRule rule);

/// The box of the curves (`curveBox`) of the selected, unlocked strokes, canvas units; empty if there are none.
Rect selectionBox(const Painting &painting, const Selection &selection);

/// How many things align and distribute move: the selected, unlocked strokes, groups that are selected as a whole as
/// one.
int movedUnits(const Document &document);

enum class Align { Left, Centre, Right, Top, Middle, Bottom };
enum class AlignTo { Selection, Anchor, Biggest, Canvas };
/// Moves the selected strokes so that the boxes of what is seen of them when dry (`seenBox`) are aligned. Groups that
/// are selected as a whole move as one. Under `AlignTo::Anchor` the stroke `anchor` stays, with its group; without an
/// anchor it is the topmost one.
Edit align(const Document &document, Align how, AlignTo to = AlignTo::Selection, StrokeId anchor = 0);

enum class Axis { Horizontal, Vertical };
enum class Spacing { Gaps, Centres };
/// Moves three or more selected strokes (or whole groups), by the same boxes, to even gaps or evenly spaced centres
/// between the two outermost, which stay.
Edit distribute(const Document &document, Axis axis, Spacing spacing);

} // namespace suffuse
