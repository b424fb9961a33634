#include "undo/kept_history.h"

#include "undo/edit_command.h"

#include <QSignalBlocker>
#include <QUndoStack>

namespace suffuse {

namespace {

const EditCommand *editAt(const QUndoStack &stack, int index)
{
    return dynamic_cast<const EditCommand *>(stack.command(index));
}

/// A step of an earlier session, or one that was kept. A stack does what is pushed on it, and undoes what is to be
/// undone; the document has been through that already.
class KeptCommand : public EditCommand {
public:
    KeptCommand(Document &document, const HistoryStep &step, bool isDone)
        : EditCommand(document, step.edit, step.text), m_skips(isDone ? 1 : 2)
    {}
    /// One that is to be undone.
    KeptCommand(Document &document, std::shared_ptr<Edit> edit, const QString &text)
        : EditCommand(document, std::move(edit), text), m_skips(2)
    {}

    void redo() override
    {
        if (!skip())
            EditCommand::redo();
    }
    void undo() override
    {
        if (!skip())
            EditCommand::undo();
    }

private:
    bool skip() { return m_skips > 0 && m_skips-- > 0; }

    int m_skips; ///< calls that are not to do anything
};

} // namespace

UndoHistory historyOf(const QUndoStack &stack)
{
    int first = stack.index(), end = stack.index();
    while (first > 0 && editAt(stack, first - 1))
        --first;
    while (end < stack.count() && editAt(stack, end))
        ++end;
    UndoHistory history;
    history.done = std::size_t(stack.index() - first);
    for (int k = first; k < end; ++k)
        history.steps.push_back({stack.text(k), editAt(stack, k)->edit()});
    return history;
}

void restoreHistory(QUndoStack &stack, Document &document, const UndoHistory &history)
{
    for (std::size_t k = 0; k < history.steps.size(); ++k) {
        document.reserve(history.steps[k].edit);
        stack.push(new KeptCommand(document, history.steps[k], k < history.done));
    }
    stack.setIndex(int(history.done));
    stack.setClean();
}

void UndoneSteps::keep(const QUndoStack &stack)
{
    if (!stack.canRedo())
        return;
    m_steps.clear();
    m_begin = stack.index();
    m_clean = stack.cleanIndex() > m_begin ? stack.cleanIndex() : -1;
    for (int k = m_begin; k < stack.count(); ++k) {
        const EditCommand *command = editAt(stack, k);
        if (!command) // of another kind: those after it would not be redone rightly
            break;
        m_steps.push_back({command->text(), command->sharedEdit()});
    }
}

bool UndoneSteps::putBack(QUndoStack &stack, Document &document)
{
    if (stack.index() > m_begin + 1)
        m_steps.clear(); // more was done since: they are gone for good
    if (m_steps.empty() || stack.index() != m_begin || stack.canRedo())
        return false;
    {
        const QSignalBlocker once(stack); // who follows the stack hears of it at the end
        for (Step &step : m_steps)
            stack.push(new KeptCommand(document, std::move(step.edit), step.text));
        if (m_clean > m_begin && m_clean <= stack.count()) {
            stack.setIndex(m_clean);
            stack.setClean();
        }
    }
    stack.setIndex(m_begin);
    m_steps.clear();
    return true;
}

} // namespace suffuse
