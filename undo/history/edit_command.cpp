#include "undo/history/edit_command.h"

#include "undo/history/back_edit.h"

#include <QUndoStack>

#include <utility>

namespace suffuse {

EditCommand::EditCommand(Document &document, Edit edit, const QString &text, State state)
    : QUndoCommand(text), m_document(document), m_edit(std::make_shared<Edit>(std::move(edit))),
      m_skips(state == State::Done ? 1 : 2)
{}

void EditCommand::redo()
{
    exchange();
}

void EditCommand::undo()
{
    exchange();
}

void EditCommand::exchange()
{
    if (m_skips > 0) {
        --m_skips;
        return;
    }
    m_document.exchange(*m_edit);
    if (!m_keeps)
        return;
    const Selection &now = m_document.selection();
    m_edit->selection = m_other ? std::exchange(*m_other, now) : now;
}

void EditCommand::keepSelection()
{
    m_keeps = true;
    m_other.reset();
    if (m_edit->selection != m_document.selection())
        m_other = m_document.selection();
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
    auto *step = dynamic_cast<EditCommand *>(const_cast<QUndoCommand *>(stack.command(last)));
    Q_ASSERT_X(step && !stack.canRedo(), "goOnWithStep", "there is no step to go on with");
    document.exchange(edit);
    const std::shared_ptr<Edit> back = step->sharedEdit();
    extendBack(*back, std::move(edit), *document.painting());
    step->keepSelection();
    if (!changesNothing(*back, *document.painting())) {
        emit stack.indexChanged(stack.index()); // The stack's step does something else now.
        return;
    }
    // A stack removes an obsolete step without calling it.
    step->setObsolete(true);
    stack.undo();
}

} // namespace suffuse
