#include "app/session/commands/session_rows.h"

namespace suffuse {

CommandRow::Condition anySelected(Editor &editor)
{
    const QString whyNot = Commands::tr("Nothing is selected: click paint with Select first.");
    return [&editor, whyNot] { return Usability(!editor.document().selection().isEmpty(), whyNot); };
}

CommandRow::Condition anyStrokes(Editor &editor)
{
    const QString whyNot = Commands::tr("Nothing is painted yet.");
    return [&editor, whyNot] { return Usability(!editor.document().painting()->strokes.empty(), whyNot); };
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
