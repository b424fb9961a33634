#include "undo/history/edit_command.h"

#include "undo/history/back_edit.h"

#include <QUndoStack>

namespace suffuse {

EditCommand::EditCommand(Document &document, Edit edit, const QString &text, State state)
    : QUndoCommand(text), m_document(document), m_edit(std::make_shared<Edit>(std::move(edit))),
      m_skips(state == State::Done ? 1 : 2)
{}

void EditCommand::redo()
{
    if (m_skips > 0)
        --m_skips;
    else
        m_document.exchange(*m_edit);
}

void EditCommand::undo()
{
    if (m_skips > 0)
        --m_skips;
    else
        m_document.exchange(*m_edit);
}

std::optional<Edit> doEdit(Document &document, Edit edit)
{
    if (!edit.selection)
        edit.selection = document.selection();
    document.exchange(edit);
    if (changesNothing(edit, *document.painting()))
        return {};
    return edit;
}

void goOnWithStep(QUndoStack &stack, Document &document, Edit edit)
{
    const int last = stack.index() - 1;
    const auto *step = dynamic_cast<const EditCommand *>(stack.command(last));
    Q_ASSERT_X(step && !stack.canRedo(), "goOnWithStep", "there is no step to go on with");
    document.exchange(edit);
    const std::shared_ptr<Edit> back = step->sharedEdit();
    extendBack(*back, std::move(edit), *document.painting());
    if (!changesNothing(*back, *document.painting())) {
        emit stack.indexChanged(stack.index()); // The stack's step does something else now.
        return;
    }
    // A stack removes an obsolete step without calling it.
    const_cast<EditCommand *>(step)->setObsolete(true);
    stack.undo();
}

} // namespace suffuse
