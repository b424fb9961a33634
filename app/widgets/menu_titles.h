// What entries of menus are called: with the menus that lead to them, and by which letters.
#pragma once

#include <QString>

class QAction;
class QMenu;

namespace suffuse {

/// With the menus that lead to it, as the name alone may stand in several: "Object ▸ Align ▸ Left Edges". For undo
/// without the step's name.
QString titleWithMenus(const QAction &action);

/// Gives the entries that a menu made itself other letters where those that it shares, or its own before them, have
/// theirs. Where no letter of the text is free, an entry has none.
void makeMnemonicsDistinct(QMenu &menu);

} // namespace suffuse
