// Edits that reshape the selected strokes, or the selected runs of their segments. As in edits.h: an empty Edit where
// there is nothing to do, locked strokes left alone.
#pragma once

#include "model/document/document.h"
#include "model/shaping/redraw.h"
#include "model/shaping/tweak.h"

#include <functional>

namespace suffuse {

/// What becomes of a stroke. `chosen`: for each segment whether it is meant; empty: all are. `sources` is to hold, for
/// each segment of the result, the index of that it came from; left empty it says that they are the same ones.
using ReshapeRuns =
    std::function<Stroke(const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *sources)>;

/// Reshapes what was selected in `before`, as it was there, whatever stands in the document now: so a dialog can show
/// one try after the other. Hidden strokes are left alone, too.
Edit reshapeSelection(const Document &document, const Painting &before, const Selection &selection,
                      const ReshapeRuns &change);

/// The segments of a stroke that a selection means; empty: all.
std::vector<bool> chosenSegments(const Stroke &stroke, const Selection &selection);

/// Strokes of the document under touches of a brush, one after the other. Hidden ones are left alone. Parts of what was
/// selected and had to be split stay selected.
Edit tweakStrokes(const Document &document, const std::vector<StrokePtr> &strokes, const std::vector<Tweak> &touches);

/// A part of a stroke follows a line that was drawn over it (`partToRedraw`).
Edit redrawStroke(const Document &document, StrokeId stroke, const Stroke &line, double reach, RedrawValues values);

} // namespace suffuse
