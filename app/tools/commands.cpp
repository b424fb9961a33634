#include "app/tools/commands.h"

#include "app/tools/pick.h"

#include <QCoreApplication>

namespace suffuse::commands {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("Commands", text);
}

} // namespace

void deleteSelected(Editor &editor)
{
    const bool segments = !editor.document().selection().segments.empty();
    editor.push(deleteSelection(editor.document()), segments ? QCoreApplication::translate("Commands", "Delete segments")
                                                             : QCoreApplication::translate("Commands", "Delete strokes"));
}

void duplicateSelected(Editor &editor)
{
    editor.push(duplicateSelection(editor.document(), {0, 0}), QCoreApplication::translate("Commands", "Duplicate"));
}

void arrangeSelected(Editor &editor, Arrange how)
{
    const char *names[] = {QT_TRANSLATE_NOOP("Commands", "Raise"), QT_TRANSLATE_NOOP("Commands", "Lower"),
                           QT_TRANSLATE_NOOP("Commands", "Raise to top"), QT_TRANSLATE_NOOP("Commands", "Lower to bottom")};
    editor.push(arrangeSelection(editor.document(), how), tr(names[int(how)]));
}

void selectAll(Editor &editor)
{
    Selection selection;
    selection.strokes = selectableStrokes(*editor.document().painting());
    editor.document().setSelection(std::move(selection));
}

void deselect(Editor &editor)
{
    Selection selection = editor.document().selection();
    if (selection.segments.empty())
        selection.strokes.clear();
    selection.segments.clear();
    editor.document().setSelection(std::move(selection));
}

void moveSelected(Editor &editor, Point by, EditRun run)
{
    const Document &document = editor.document();
    editor.push(changeStrokes(document, document.selection().strokes,
                              [by](Stroke &stroke) { stroke.origin = stroke.origin + by; }),
                QCoreApplication::translate("Commands", "Move"), run);
}

} // namespace suffuse::commands
