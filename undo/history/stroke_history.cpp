#include "undo/history/stroke_history.h"

#include "undo/edits.h"
#include "undo/history/edit_command.h"

#include <QUndoStack>

#include <algorithm>

namespace suffuse {

namespace {

const EditCommand *commandAt(const QUndoStack &stack, int index)
{
    return dynamic_cast<const EditCommand *>(stack.command(index));
}

/// Whether a step changed no picture, but swatches or what is selected.
bool changesNoPicture(const Edit &edit)
{
    return edit.strokes.empty() && !edit.reorders() && !edit.canvas && !edit.groups && !edit.underlay;
}

/// Whether a step altered strokes of the set and nothing else that is seen.
bool onlyAlters(const Edit &edit, const std::set<StrokeId> &strokes)
{
    if (edit.strokes.empty() || edit.reorders() || edit.canvas || edit.groups || edit.underlay)
        return false;
    return std::all_of(edit.strokes.begin(), edit.strokes.end(),
                       [&](const auto &entry) { return entry.second && strokes.contains(entry.first); });
}

} // namespace

std::vector<StrokeState> statesOf(const QUndoStack &stack, const Document &document, StrokeId id)
{
    StrokePtr state = document.painting()->find(id);
    if (!state)
        return {};
    std::vector<StrokeState> states;
    for (int i = stack.index() - 1; i >= 0; --i) {
        const EditCommand *command = commandAt(stack, i);
        if (!command)
            continue;
        const auto it = command->edit().strokes.find(id);
        if (it == command->edit().strokes.end())
            continue;
        if (state)
            states.push_back({command->text(), state});
        state = it->second;
    }
    if (state)
        states.push_back({{}, state});
    std::reverse(states.begin(), states.end());
    return states;
}

Edit putBack(const Document &document, const Stroke &state)
{
    return changeStrokes(document, {state.id}, [&](Stroke &stroke) {
        const bool locked = stroke.locked;
        stroke = state;
        stroke.locked = locked;
    });
}

bool endsWithEditOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided)
{
    if (undecided && !changesNoPicture(*undecided))
        return onlyAlters(*undecided, document.selection().strokes);
    for (int i = stack.index() - 1; i >= 0; --i) {
        const EditCommand *command = commandAt(stack, i);
        if (!command || !changesNoPicture(command->edit()))
            return command && onlyAlters(command->edit(), document.selection().strokes);
    }
    return false;
}

PaintingPtr beforeEditsOfSelection(const QUndoStack &stack, const Document &document, const Edit *undecided)
{
    std::map<StrokeId, StrokePtr> before;
    const auto goBack = [&](const Edit &edit) {
        if (changesNoPicture(edit))
            return true;
        if (!onlyAlters(edit, document.selection().strokes))
            return false;
        for (const auto &[id, stroke] : edit.strokes)
            before[id] = stroke;
        return true;
    };
    bool goesBack = !undecided || goBack(*undecided);
    for (int i = stack.index() - 1; i >= 0 && goesBack; --i) {
        const EditCommand *command = commandAt(stack, i);
        goesBack = command && goBack(command->edit());
    }
    if (before.empty())
        return nullptr;
    auto painting = std::make_shared<Painting>(*document.painting());
    const StrokeList &now = document.painting()->strokes;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (const auto it = before.find(now[i]->id); it != before.end())
            painting->strokes[i] = it->second;
    return painting;
}

} // namespace suffuse
