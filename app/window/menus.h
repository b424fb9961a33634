// The menus and the tool bar of a window, of the actions that the table of commands holds.
#pragma once

class QMenu;
class QMenuBar;
class QToolBar;
class QWidget;

namespace suffuse {

class Commands;

/// Those that are filled by whoever knows what goes into them.
struct OpenMenus {
    QMenu *recent = nullptr; ///< files that were open before
    QMenu *docks = nullptr;
    QMenu *workspaces = nullptr; ///< those that were saved come behind those that are there
    QMenu *extensions = nullptr;
};

/// All rows must be in the table.
OpenMenus fillMenus(QMenuBar &bar, const Commands &table);
/// The tools, undo, and the zoom.
QToolBar *makeToolBar(const Commands &table, QWidget *parent);

} // namespace suffuse
