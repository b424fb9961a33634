// Windows in which nothing moves that nobody moves.
#pragma once

namespace suffuse {

/// Whether the setting or, where that leaves it to the desktop, the desktop wants no animations.
bool motionIsReduced();

/// Lets docks and bars jump to their places, and carets stand without blinking, or move as usual, in all windows that there
/// are. Paint that spreads and a painting that is played are what was asked for, and go on. Desktops of which only a program
/// tells are asked aside, and followed when it has answered. Needs a QApplication; may be called again.
void applyMotion();

} // namespace suffuse
