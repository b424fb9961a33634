// Rows of the Edit menu, and what of its steps is kept in the file.
#include "app/session/commands/session_rows.h"

#include "app/session/commands/selection_commands.h"
#include "app/session/files/clipboard.h"

#include <QLocale>

namespace suffuse {

namespace {

QString keepHistoryText(const Editor &editor)
{
    const qint64 bytes = editor.historyBytes();
    return bytes > 0 ? Commands::tr("Keep Undo &History in the File (%1)").arg(QLocale().formattedDataSize(bytes))
                     : Commands::tr("Keep Undo &History in the File");
}

} // namespace

void addEditRows(Commands &table, OpenPainting &open)
{
    using enum Command;
    Editor &editor = open.editor;
    const auto selected = anySelected(editor);
    const auto keys = [](QKeySequence::StandardKey key) { return QKeySequence::keyBindings(key); };
    const auto say = [&table](const QString &leftOut) {
        constexpr int shownMs = 8'000;
        if (!leftOut.isEmpty())
            emit table.said(leftOut, shownMs);
    };
    table.add(Cut, "cut", Commands::tr("Cu&t"), "cut", keys(QKeySequence::Cut))
        .when(selected)
        .runs([&editor, say] { say(clipboard::cut(editor)); })
        .action->setAutoRepeat(false); // A key that is held does not cut what was left.
    table.add(Copy, "copy", Commands::tr("&Copy"), "copy", keys(QKeySequence::Copy))
        .when(selected)
        .runs([&editor, say] { say(clipboard::copy(editor)); });
    table.add(Duplicate, "duplicate", Commands::tr("Dup&licate"), "duplicate", {QKeySequence(Commands::tr("Ctrl+D"))})
        .when(selected)
        .runs([&editor, say] { say(commands::duplicateSelected(editor)); });
    table.add(Deselect, "deselect", Commands::tr("D&eselect"), "", {QKeySequence(Commands::tr("Ctrl+Shift+A"))})
        .when(selected)
        .runs([&editor] { editor.document().setSelection({}); });
    table
        .add(KeepHistory, "keepHistory", Commands::tr("Keep Undo &History in the File"), "", {},
             Commands::tr("Whoever opens the file can go on undoing. Take it out before you give a file away"))
        .checkedWhen([&editor] { return editor.keepsHistory(); })
        .named([&editor] { return keepHistoryText(editor); })
        .runs([&table, &editor] { editor.setKeepsHistory(table[KeepHistory].isChecked()); });
}

} // namespace suffuse
