// Steps as the program does them.
#pragma once

#include "undo/history/edit_command.h"

#include <QUndoStack>

namespace suffuse {

/// The step that edits go on with, one after the other, while nothing else is done.
using StepRun = std::weak_ptr<Edit>;

/// Does an edit, as a step of its own or as a part of the run's.
inline void pushStep(QUndoStack &stack, Document &document, Edit edit, const QString &text = QStringLiteral("edit"),
                     StepRun *run = nullptr)
{
    const auto last = [&stack] { return dynamic_cast<const EditCommand *>(stack.command(stack.index() - 1)); };
    const std::shared_ptr<Edit> step = run ? run->lock() : nullptr;
    if (step && last() && last()->sharedEdit() == step && !stack.canRedo()) {
        goOnWithStep(stack, document, std::move(edit));
    } else if (std::optional<Edit> back = doEdit(document, std::move(edit))) {
        stack.push(new EditCommand(document, std::move(*back), text));
        if (run)
            *run = last()->sharedEdit();
    }
}

} // namespace suffuse
