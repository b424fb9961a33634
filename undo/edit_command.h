// The one undo command: an Edit and its name.
#pragma once

#include "model/document/document.h"

#include <QUndoCommand>

#include <memory>
#include <optional>

class QUndoStack;

namespace suffuse {

/// One step of an undo stack. What it did is done before the step is made, by whoever exchanged the edit with the
/// document; redo() and undo() are the same exchange, and undo brings the selection back, too. A stack calls redo() for
/// each step that is pushed, and undo() for those that were undone in an earlier session: these calls do nothing.
class EditCommand : public QUndoCommand {
public:
    enum class State { Done, Undone };

    /// `edit` holds the state that the document does not have: the one before what is done, the one after what is
    /// undone.
    EditCommand(Document &document, Edit edit, const QString &text, State state = State::Done);

    void redo() override;
    void undo() override;

    /// The state that the document does not have: the one before while the command is done, the one after while it is
    /// undone.
    const Edit &edit() const { return *m_edit; }
    /// The same, for whoever goes on with a step that is the last one (`goOnWithStep`).
    const std::shared_ptr<Edit> &sharedEdit() const { return m_edit; }

private:
    Document &m_document;
    std::shared_ptr<Edit> m_edit; ///< never null
    int m_skips = 0;              ///< calls that are not to do anything
};

/// Does an edit, and returns the way back, which brings back what was selected, too. Nothing where it changes nothing
/// but the selection: that is no step.
std::optional<Edit> doEdit(Document &document, Edit edit);

/// Does an edit as a part of the step that was done last. Where the step comes back to its start, it is dropped.
void goOnWithStep(QUndoStack &stack, Document &document, Edit edit);

} // namespace suffuse
