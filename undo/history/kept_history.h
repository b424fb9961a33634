// Converts the undo stack to what is kept in files, and back.
#pragma once

#include "model/document/document.h"
#include "model/formats/suffuse/suffuse_history.h"

#include <QString>

class QUndoStack;

namespace suffuse {

/// The steps of a stack around its place, as far as they are edits of a document.
UndoHistory historyOf(const QUndoStack &stack);

/// Fills an empty stack with the steps of the painting that the document has. `readHistory` must have checked them. The
/// document stays as it is, and the stack is clean.
void restoreHistory(QUndoStack &stack, Document &document, const UndoHistory &history);

} // namespace suffuse
