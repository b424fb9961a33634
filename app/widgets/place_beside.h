// Where a window goes that must not cover what it is about.
#pragma once

#include <QPoint>
#include <QRect>

class QDialog;
class QWidget;

namespace suffuse {

/// The top left corner of a window of this size that lies within `screen` and, where there is room, beside `what`: to
/// the right, else to the left, below or above; where there is none, where it covers least. Logical pixels.
QPoint placeBeside(QSize size, const QRect &what, const QRect &screen);

/// A rectangle as near to what is wished as can be that lies within `screen`.
QRect placeWithin(const QRect &wish, const QRect &screen);

/// Moves a window that has not been shown, on the screen on which `what` is. Does nothing for an empty rectangle.
void moveBeside(QWidget &window, const QRect &what);

/// The place of a dialog of this size, frame included: in the middle of `owner`, within `screen`, and no larger than
/// it.
QRect placeOver(QSize size, const QRect &owner, const QRect &screen);

/// Puts a dialog that is about to be shown over its parent's window (without one, in the middle of the screen). One
/// that has a place already keeps it as far as it lies on the screen.
void placeDialog(QDialog &dialog);

/// Shows a window for the first time: as large as another one and a little off it, on the same screen; maximised where
/// that one is.
void showLike(QWidget &window, const QWidget &other);

} // namespace suffuse
