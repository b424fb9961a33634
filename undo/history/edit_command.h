// The one undo command: an Edit and its name.
#pragma once

#include "model/document/document.h"

#include <QUndoCommand>

#include <memory>
#include <optional>

class QUndoStack;

namespace suffuse {

/// One step of an undo stack. Whoever makes it has done its edit already. redo() and undo() exchange the edit with the
/// document, and undo() brings back the selection, too. A stack calls redo() when a step is pushed, and calls undo()
/// when steps are restored that an earlier session has undone: these calls do nothing.
class EditCommand : public QUndoCommand {
public:
    enum class State { Done, Undone };

    /// `edit` holds the state that the document does not have. For a step that is done this is the state before it, and
    /// for one that is undone the state after it.
    EditCommand(Document &document, Edit edit, const QString &text, State state = State::Done);

    void redo() override;
    void undo() override;

    /// Remembers what is selected after the step, which is done: redo() selects that again, and undo() what was
    /// selected before, whatever was selected in between.
    void keepSelection();

    /// The edit with the state that the document does not have, as in the constructor.
    const Edit &edit() const { return *m_edit; }
    /// The same edit, for whoever extends this step while it is the last one (`goOnWithStep`).
    const std::shared_ptr<Edit> &sharedEdit() const { return m_edit; }

private:
    void exchange();

    Document &m_document;
    std::shared_ptr<Edit> m_edit;     ///< never null
    int m_skips = 0;                  ///< the number of calls that must do nothing
    bool m_keeps = false;             ///< whether both selections are remembered
    std::optional<Selection> m_other; ///< the one that the document has, if it differs from that in the edit
};

/// Does an edit, and returns the way back, which also brings back the selection. No value if the edit changes nothing
/// but the selection, since that is no step.
std::optional<Edit> doEdit(Document &document, Edit edit);

/// Does an edit as a part of the step that was done last. If the step then leads back to its start, it is removed.
void goOnWithStep(QUndoStack &stack, Document &document, Edit edit);

} // namespace suffuse
