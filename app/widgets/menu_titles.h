// What an action is called together with the menus that lead to it.
#pragma once

#include <QString>

class QAction;

namespace suffuse {

/// With the menus that lead to it, as the name alone may stand in several: "Object ▸ Align ▸ Left Edges". For undo
/// without the step's name.
QString titleWithMenus(const QAction &action);

} // namespace suffuse
