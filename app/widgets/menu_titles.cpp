#include "app/widgets/menu_titles.h"

#include "app/session/commands/commands.h"

#include <QMenu>

namespace suffuse {

namespace {

/// The menu that an action is in; none: null. An action may be in tool bars, too, and in the nameless menu that a menu
/// bar without room has at its end.
const QMenu *menuOf(const QAction &action)
{
    for (const QObject *place : action.associatedObjects())
        if (const auto *menu = qobject_cast<const QMenu *>(place); menu && !menu->title().isEmpty())
            return menu;
    return nullptr;
}

} // namespace

QString titleWithMenus(const QAction &action)
{
    QString title = plainTitle(action.iconText());
    for (const QMenu *menu = menuOf(action); menu; menu = menuOf(*menu->menuAction()))
        title.prepend(plainTitle(menu->title()) + QStringLiteral(" ▸ "));
    return title;
}

} // namespace suffuse
