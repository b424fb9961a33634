#include "app/session/commands/session_rows.h"

namespace suffuse {

CommandRow::Predicate anySelected(Editor &editor)
{
    return [&editor] { return !editor.document().selection().isEmpty(); };
}

CommandRow::Predicate anyStrokes(Editor &editor)
{
    return [&editor] { return !editor.document().painting()->strokes.empty(); };
}

void addSessionRows(Commands &table, OpenPainting &open)
{
    addEditRows(table, open);
    addObjectRows(table, open);
    addLayerRows(table, open);
    addAreaRows(table, open);
    addReshapeRows(table, open);
    addRestyleRows(table, open);
    addColourRows(table, open);
    addAlignRows(table, open);
    addTimeRows(table, open);
    addBrushRows(table, open);
    Editor &editor = open.editor;
    const auto isWaiting = [&editor] { return editor.laterChanges().isWaiting(); };
    const auto follow = [&table, isWaiting] {
        if (!isWaiting()) // else it comes with what waits
            table.update();
    };
    table.updatesComeBy(isWaiting);
    QObject::connect(&editor.laterChanges(), &LaterChanges::changed, &table, [&table] { table.update(); });
    QObject::connect(&editor.undoStack(), &QUndoStack::indexChanged, &table, follow);
    QObject::connect(&editor, &Editor::dragEnded, &table, follow);
    QObject::connect(&editor, &Editor::fileChanged, &table, follow);
    QObject::connect(&open.playback, &Playback::stateChanged, &table, [&table] { table.update(); });
}

} // namespace suffuse
