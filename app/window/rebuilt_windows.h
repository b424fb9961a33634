// Other widgets around the same paintings.
#pragma once

namespace suffuse {

/// Puts a new window in the place of each main window, in the language and with the ways of drawing that the settings
/// ask for now. Paintings, undo steps, selection, moment, view, tool and journals live on. Must not be called out of
/// one of those windows: use rebuildWindowsSoon() there.
void rebuildWindows();
/// When what happens now is over.
void rebuildWindowsSoon();

} // namespace suffuse
