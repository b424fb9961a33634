#include "undo/kept_history.h"

#include "undo/edit_command.h"

#include <QUndoStack>

namespace suffuse {

namespace {

const EditCommand *editAt(const QUndoStack &stack, int index)
{
    return dynamic_cast<const EditCommand *>(stack.command(index));
}

/// A step of an earlier session. A stack does what is pushed on it, and undoes what is to be undone; the document has
/// been through that already.
class KeptCommand : public EditCommand {
public:
    KeptCommand(Document &document, const HistoryStep &step, bool isDone)
        : EditCommand(document, step.edit, step.text), m_skips(isDone ? 1 : 2)
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

} // namespace suffuse
