// Edits of what lies within strokes. As in edits.h: they are empty where there is nothing to do.
#pragma once

#include "model/document/document.h"

#include <functional>

namespace suffuse {

/// The fill with which a stroke begins: the colour, the spread, the grain and the drying time of its paint, and so dense
/// that the paint ends on the outline. It is born with the last segment of the outline.
Fill usualFill(const Stroke &stroke);

/// Fills those of the strokes that are not filled.
Edit addFills(const Document &document, const std::set<StrokeId> &strokes);
/// Takes away the fills of the strokes (`withoutFill`).
Edit removeFills(const Document &document, const std::set<StrokeId> &strokes);
/// Gives the fills that have none a gradient, in which the colour fades away from left to right, across the outline.
Edit addGradients(const Document &document, const std::set<StrokeId> &strokes);
/// Leaves of gradients the first colour.
Edit removeGradients(const Document &document, const std::set<StrokeId> &strokes);
/// The two colours of gradients change places.
Edit swapGradients(const Document &document, const std::set<StrokeId> &strokes);
/// Applies `change` to the fills of the strokes. `then` is the fill of the stroke in `before`, or the present one where
/// it had none. A fill that becomes invalid (`problemOf`) stays as it was.
Edit changeFills(const Document &document, const Painting &before, const std::set<StrokeId> &strokes,
                 const std::function<void(Fill &now, const Fill &then)> &change);

} // namespace suffuse
