// Commands that give the selected strokes, or the selected runs of their segments, another shape or width.
#pragma once

#include "app/session/editor.h"

namespace suffuse {

enum class Reshaping { Simplify, Smooth, Straighten, Width, Offset };

/// By how much. The settings remember what was used last, so that a key does the same again.
struct ReshapeAmounts {
    double distance = 0.5;  ///< of Simplify: how far a curve may move, canvas units
    double values = 0.3;    ///< of Simplify: how far values may differ that become one, a share
    double smoothing = 10;  ///< wiggles of about this length go, canvas units
    double straight = 0.25; ///< share of the way to the chord
    double width = 1.1;     ///< factor
    double aside = 10;      ///< canvas units, to the right of the stroke's direction

    static ReshapeAmounts stored();
    void store() const;
};

/// Name of the step, translated.
QString nameOf(Reshaping what);

/// Reshapes what was selected in `before`; see `reshapeSelection` (undo/run_edits.h).
Edit reshapeEdit(const Document &document, const Painting &before, const Selection &selection, Reshaping what,
                 const ReshapeAmounts &amounts);
/// The same once, as a step, with the amounts that were used last. Returns what there is to say: why nothing was done,
/// or nothing.
QString reshapeSelected(Editor &editor, Reshaping what, const ReshapeAmounts &amounts);

/// How many segments the selection means, in strokes that can be changed.
std::size_t chosenCount(const Painting &painting, const Selection &selection);

} // namespace suffuse
