#include "app/window/palette_entries.h"

#include "app/session/commands/session_rows.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/widgets/menu_titles.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>

namespace suffuse {

namespace {

QString words(const char *text)
{
    return QCoreApplication::translate("suffuse::CommandPalette", text);
}

QString under(const QString &heading, const QString &name)
{
    return heading + QStringLiteral(" ▸ ") + name;
}

PaletteEntry entryOf(QAction &action)
{
    const QPointer<QAction> kept = &action;
    return {titleWithMenus(action),
            action.objectName(),
            action.shortcut().toString(QKeySequence::NativeText),
            action.icon(),
            action.isEnabled(),
            [kept] {
                if (kept)
                    kept->trigger();
            },
            action.isEnabled() ? QString() : action.statusTip()};
}

} // namespace

std::vector<PaletteEntry> paletteEntries(Editor &editor, const Commands &table, const QList<QAction *> &docks,
                                         const QList<QAction *> &extensions,
                                         const std::function<void(QAction &toggle)> &toggleDock,
                                         const std::function<void(const QString &path)> &openFile)
{
    std::vector<PaletteEntry> entries;
    for (QAction *action : table.runnable())
        if (action->isVisible() && action != &table[Command::FindCommand])
            entries.push_back(entryOf(*action));
    for (QAction *toggle : docks)
        if (!toggle->isSeparator()) {
            entries.push_back(entryOf(*toggle));
            entries.back().run = [toggleDock, toggle] { toggleDock(*toggle); };
        }
    for (QAction *extension : extensions)
        entries.push_back(entryOf(*extension));
    for (const Brush &brush : BrushLibrary::instance().brushes())
        entries.push_back({under(words(QT_TRANSLATE_NOOP("suffuse::CommandPalette", "Brush")), brushTitle(brush.name)),
                           brush.name,
                           {},
                           {},
                           true,
                           [&editor, &table, name = brush.name] {
                               BrushLibrary::instance().use(editor, name);
                               takeToPaint(table, editor);
                           }});
    for (const QString &path : settings::recentFiles())
        entries.push_back(
            {under(words(QT_TRANSLATE_NOOP("suffuse::CommandPalette", "Open Recent")), QFileInfo(path).fileName()),
             path,
             {},
             {},
             true,
             [openFile, path] { openFile(path); }});
    return entries;
}

} // namespace suffuse
