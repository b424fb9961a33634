// Finds out from the undo stack what happened to single strokes.
#pragma once

#include "model/document/document.h"

#include <QString>

#include <vector>

class QUndoStack;

namespace suffuse {

/// A state that a stroke once had.
struct StrokeState {
    QString text;     ///< the name of the step that led to it; empty for the state in which the painting was opened
    StrokePtr stroke; ///< never null
};

/// The states of a stroke from the oldest to the present one, by the steps that are done. Steps after which it did not
/// exist are left out. Empty if there is no such stroke.
std::vector<StrokeState> statesOf(const QUndoStack &stack, const Document &document, StrokeId id);

/// Puts a stroke's values and curve back to an earlier state. Its place, group and lock stay. The edit is empty if the
/// stroke does not exist, is locked, or already has this state.
Edit putBack(const Document &document, const Stroke &state);

/// The painting as it was before the last steps that altered selected strokes and nothing else; null if the last step
/// was of another kind. `undecided`, the way back from something that is in no step yet, counts as the last step.
PaintingPtr beforeEditsOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided = nullptr);
/// Whether the last step was one that altered selected strokes and nothing else.
bool endsWithEditOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided = nullptr);

} // namespace suffuse
