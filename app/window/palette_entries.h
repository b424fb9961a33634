// What a window's command palette finds.
#pragma once

#include "app/dialogs/command_palette.h"

#include <vector>

namespace suffuse {

class Actions;
class MainWindow;

/// Its commands in the order of the table, docks, brushes, and files that were open before.
std::vector<PaletteEntry> paletteEntries(MainWindow &window, const Actions &actions);

} // namespace suffuse
