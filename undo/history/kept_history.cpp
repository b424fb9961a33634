#include "undo/history/kept_history.h"

#include "undo/history/edit_command.h"

#include <QUndoStack>

namespace suffuse {

namespace {

const EditCommand *editAt(const QUndoStack &stack, int index)
{
    return dynamic_cast<const EditCommand *>(stack.command(index));
}

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
        const HistoryStep &step = history.steps[k];
        const auto state = k < history.done ? EditCommand::State::Done : EditCommand::State::Undone;
        stack.push(new EditCommand(document, step.edit, step.text, state));
    }
    stack.setIndex(int(history.done));
    stack.setClean();
}

} // namespace suffuse
