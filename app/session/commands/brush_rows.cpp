// Rows of the favourite brushes, a key each.
#include "app/session/commands/session_rows.h"

#include "app/session/colour/colour_target.h"
#include "app/session/settings/brush_library.h"

namespace suffuse {

namespace {

/// Empty where there are not so many.
QString favourite(int i)
{
    return BrushLibrary::instance().favourites().value(i);
}

} // namespace

void takeToPaint(const Commands &table, Editor &editor)
{
    if (!editor.colourTarget().isToolPainting())
        table[Command::Brush].setChecked(true);
}

void addBrushRows(Commands &table, OpenPainting &open)
{
    Editor &editor = open.editor;
    for (int i = 0; i < BrushLibrary::keys; ++i)
        table
            .add(Command(int(Command::Favourite1) + i), QStringLiteral("favourite%1").arg(i + 1),
                 Commands::tr("Favourite Brush %1").arg(i + 1), "", {QKeySequence(Qt::Key_1 + i)})
            .shownWhen([i] { return !favourite(i).isEmpty(); })
            .named([i] {
                const QString name = favourite(i);
                return name.isEmpty() ? Commands::tr("Favourite Brush %1").arg(i + 1)
                                      : brushTitle(name).replace('&', QStringLiteral("&&"));
            })
            .runs([&table, &editor, i] {
                if (favourite(i).isEmpty())
                    return;
                BrushLibrary::instance().use(editor, favourite(i));
                takeToPaint(table, editor);
            });
    QObject::connect(&BrushLibrary::instance(), &BrushLibrary::changed, &table, [&table] { table.update(); });
}

} // namespace suffuse
