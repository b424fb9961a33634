// The undo stack as it goes into a file, and out of it again.
#pragma once

#include "model/document/document.h"
#include "model/formats/suffuse/suffuse_history.h"

#include <QString>

#include <memory>
#include <vector>

class QUndoStack;

namespace suffuse {

/// The steps of a stack around its place, as far as they are edits of a document.
UndoHistory historyOf(const QUndoStack &stack);

/// Fills an empty stack with the steps of the painting that the document holds (`readHistory` has tried them). The
/// document stays as it is; the stack is clean.
void restoreHistory(QUndoStack &stack, Document &document, const UndoHistory &history);

/// The steps that are undone, while something is tried that would make the stack drop them: where it comes to nothing,
/// they are put back.
class UndoneSteps {
public:
    /// Call it before a push. Keeps what the push would drop; where there is nothing, what was kept before stays.
    void keep(const QUndoStack &stack);
    /// Call it after a push, and after a step was given up: puts the steps back where the stack stands where they began
    /// and has nothing to redo. True if it did.
    bool putBack(QUndoStack &stack, Document &document);
    void clear() { m_steps.clear(); }

private:
    struct Step {
        QString text;
        std::shared_ptr<Edit> edit;
    };
    std::vector<Step> m_steps; ///< the first to be redone comes first
    int m_begin = 0;           ///< index of the stack at which they were undone
    int m_clean = -1;          ///< the stack's clean index, where that is among them
};

} // namespace suffuse
