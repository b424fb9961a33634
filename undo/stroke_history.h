// What the undo stack knows about single strokes.
#pragma once

#include "model/document/document.h"

#include <QString>

#include <vector>

class QUndoStack;

namespace suffuse {

/// A state that a stroke once had.
struct StrokeState {
    QString text;     ///< name of the step that led to it; empty for the state that the painting was opened with
    StrokePtr stroke; ///< never null
};

/// The states of a stroke from the oldest to the one of now, by the steps that are done. Steps after which it was
/// absent are left out. Empty where there is no such stroke.
std::vector<StrokeState> statesOf(const QUndoStack &stack, const Document &document, StrokeId id);

/// Puts a stroke's values and curve back to an earlier state; its place, group and lock stay. Empty where the stroke is
/// gone or locked, or already is like that.
Edit putBack(const Document &document, const Stroke &state);

/// The painting as it was before the last steps that altered selected strokes and nothing else; null where the last
/// step was of another kind. What is undecided, the way back from something that is in no step yet, counts as the last.
PaintingPtr beforeEditsOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided = nullptr);
/// Whether the last step was of that kind.
bool endsWithEditOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided = nullptr);

} // namespace suffuse
