// The one undo command: an Edit and its name.
#pragma once

#include "model/document/document.h"

#include <QUndoCommand>

#include <memory>

namespace suffuse {

/// A drag is a run: its edits merge into one command. 0 means "not in a run"; ids never repeat, so two drags never
/// merge.
using EditRun = int;
EditRun beginEditRun();

/// redo() and undo() are the same exchange; undo brings the selection back too. Commands of one run merge, each part
/// keeping its oldest state. An edit that changes nothing but the selection, and a run that comes back to its start,
/// become obsolete, and the stack drops them.
class EditCommand : public QUndoCommand {
public:
    EditCommand(Document &document, Edit edit, const QString &text, EditRun run = 0);
    /// Shares the edit with another command, which is not called any more.
    EditCommand(Document &document, std::shared_ptr<Edit> edit, const QString &text);

    void redo() override;
    void undo() override;
    int id() const override;
    bool mergeWith(const QUndoCommand *other) override;

    /// The state that the document does not have: the one before while the command is done, the one after while it is
    /// undone.
    const Edit &edit() const { return *m_edit; }
    const std::shared_ptr<Edit> &sharedEdit() const { return m_edit; }
    /// Undone once more, it is no step any more: the stack drops it.
    void giveUp() const { m_givenUp = true; }

private:
    Document &m_document;
    std::shared_ptr<Edit> m_edit; ///< never null
    EditRun m_run;
    bool m_done = false;
    mutable bool m_givenUp = false;
};

} // namespace suffuse
