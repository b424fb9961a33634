#include "app/window/palette_entries.h"

#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/window/actions.h"
#include "app/window/main_window.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>
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
            }};
}

} // namespace

std::vector<PaletteEntry> paletteEntries(MainWindow &window, const Actions &actions)
{
    std::vector<PaletteEntry> entries;
    for (QAction *action : actions.runnable())
        if (action->isVisible() && action != &actions[Command::FindCommand])
            entries.push_back(entryOf(*action));
    for (QAction *toggle : actions.docksMenu()->actions())
        if (!toggle->isSeparator())
            entries.push_back(entryOf(*toggle));
    for (const Brush &brush : BrushLibrary::instance().brushes())
        entries.push_back({under(words(QT_TRANSLATE_NOOP("suffuse::CommandPalette", "Brush")), brushTitle(brush.name)),
                           brush.name,
                           {},
                           {},
                           true,
                           [&window, name = brush.name] {
                               BrushLibrary::instance().use(window.editor(), name);
                               window.action(Command::Brush).setChecked(true);
                           }});
    for (const QString &path : settings::recentFiles())
        entries.push_back(
            {under(words(QT_TRANSLATE_NOOP("suffuse::CommandPalette", "Open Recent")), QFileInfo(path).fileName()),
             path,
             {},
             {},
             true,
             [&window, path] { window.openFile(path); }});
    return entries;
}

} // namespace suffuse
