// Other widgets around the same paintings.
#pragma once

namespace suffuse {

class MainWindow;

/// Puts a new window in the place of each main window, in the language and with the ways of drawing that the settings
/// ask for now. Paintings, undo steps, selection, moment, view, tool and journals live on. `front`, or else the active
/// window, stays before the others. Must not be called out of one of those windows: use rebuildWindowsSoon() there.
void rebuildWindows(const MainWindow *front = nullptr);
/// When what happens now is over; `front` is the window in which it was asked for.
void rebuildWindowsSoon(const MainWindow &front);

} // namespace suffuse
