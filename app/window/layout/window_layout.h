// Where the window and its docks stood when the program ended.
#pragma once

#include <QString>

class QMainWindow;

namespace suffuse::window_layout {

/// Stores geometry and docks with a version and a checksum.
void save(const QMainWindow &window);
/// Puts back what `save` stored; call it once all docks exist. Returns false, and leaves the window alone, where nothing
/// fit is stored, or where the last start that restored a layout did not come up (Qt's own readers crash or hang on
/// damaged bytes). The start counts as up once the event loop runs with the window shown.
bool restore(QMainWindow &window);
/// Where docks and tool bars stand, as a text with a checksum.
QString sealed(const QMainWindow &window);
/// Puts them there. Returns false, and leaves the window alone, where the text is not exactly one that `sealed` gave.
bool restoreSealed(QMainWindow &window, const QString &text);
/// Forgets the stored layout (`--reset-layout`).
void reset();
/// There is one to restore.
bool isStored();

} // namespace suffuse::window_layout
