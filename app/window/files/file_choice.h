// Where and among which files people look for one to open.
#pragma once

#include <QString>

namespace suffuse {

class Editor;

/// Of file dialogs: all that can be opened, and each kind of it.
QString openFilter();
/// Where the painting lies, or the one that was opened last; empty: neither.
QString folderNear(const Editor &editor);

} // namespace suffuse
