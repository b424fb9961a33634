// Where a window goes that must not cover what it is about.
#pragma once

#include <QPoint>
#include <QRect>

class QWidget;

namespace suffuse {

/// The top left corner of a window of this size that lies within `screen` and, where there is room, beside `what`: to
/// the right, else to the left, below or above; where there is none, where it covers least. Logical pixels.
QPoint placeBeside(QSize size, const QRect &what, const QRect &screen);

/// A rectangle as near to what is wished as can be that lies within `screen`.
QRect placeWithin(const QRect &wish, const QRect &screen);

/// Moves a window that has not been shown, on the screen on which `what` is. Does nothing for an empty rectangle.
void moveBeside(QWidget &window, const QRect &what);

/// Shows a window for the first time: as large as another one and a little off it, on the same screen; maximised where
/// that one is.
void showLike(QWidget &window, const QWidget &other);

} // namespace suffuse
