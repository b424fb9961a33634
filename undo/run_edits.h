// Edits that reshape the selected strokes, or the selected runs of their segments. A function returns an empty Edit if
// there is nothing to do, and leaves locked strokes alone.
#pragma once

#include "model/document/document.h"
#include "model/shaping/nodes/redraw.h"
#include "model/shaping/nodes/tweak.h"

#include <functional>

namespace suffuse {

/// Reshapes a stroke. `chosen` says for each segment whether it is to be reshaped; if it is empty, all are. `sources`
/// gets, for each segment of the result, the index of the segment that it came from. If it stays empty, the segments
/// are the same ones.
using ReshapeRuns =
    std::function<Stroke(const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *sources)>;

/// Reshapes what was selected in `before`, as it was there, whatever the document has now. So a dialog can show one try
/// after the other. Hidden strokes are left alone, too.
Edit reshapeSelection(const Document &document, const Painting &before, const Selection &selection,
                      const ReshapeRuns &change);

/// Which segments of a stroke a selection means; empty if it means all.
std::vector<bool> chosenSegments(const Stroke &stroke, const Selection &selection);

/// Applies touches of a brush, one after the other, to strokes of the document. Hidden strokes are left alone. Parts of
/// a selected segment that had to be split stay selected.
Edit tweakStrokes(const Document &document, const std::vector<StrokePtr> &strokes, const std::vector<Tweak> &touches);

/// Makes a part of a stroke follow a line that was drawn over it (see `partToRedraw`).
Edit redrawStroke(const Document &document, StrokeId stroke, const Stroke &line, double reach, RedrawValues values);

} // namespace suffuse
