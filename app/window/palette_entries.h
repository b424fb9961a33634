// What a window's command palette finds.
#pragma once

#include "app/dialogs/command_palette.h"

#include <QList>

#include <functional>
#include <vector>

class QAction;

namespace suffuse {

class Commands;
class Editor;

/// The commands in the order of the table, `docks` (the entries of their menu, which `toggleDock` runs), the entries of
/// `extensions`, brushes, and files that were open before, which are opened by `openFile`.
std::vector<PaletteEntry> paletteEntries(Editor &editor, const Commands &table, const QList<QAction *> &docks,
                                         const QList<QAction *> &extensions,
                                         const std::function<void(QAction &toggle)> &toggleDock,
                                         const std::function<void(const QString &path)> &openFile);

} // namespace suffuse
