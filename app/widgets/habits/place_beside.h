// Places windows so that they do not cover what they are about.
#pragma once

#include <QList>
#include <QPoint>
#include <QRect>
#include <QSize>

class QDialog;
class QWidget;

namespace suffuse {

/// The top left corner for a window of this size. The window lies within `screen` and, where there is room, beside
/// `what`: to the right, else to the left, below or above. Where there is no room, it lies where it covers least.
/// Logical pixels.
QPoint placeBeside(QSize size, const QRect &what, const QRect &screen);

/// The rectangle within `screen` that comes nearest to the wished one.
QRect placeWithin(const QRect &wish, const QRect &screen);

/// Moves a window that has not been shown yet to that place, on the screen on which `what` is. Does nothing for an
/// empty rectangle.
void moveBeside(QWidget &window, const QRect &what);

/// The place of a dialog of this size, frame included: in the middle of `owner`, within `screen`, and no larger than
/// the screen.
QRect placeOver(QSize size, const QRect &owner, const QRect &screen);

/// The size that a dialog's contents can have on its screen, beside the window's frame.
QSize roomFor(const QDialog &dialog);

/// Puts a dialog that is about to be shown over its parent's window, or into the middle of the screen if it has no
/// parent. A dialog that has a place already keeps it as far as it lies on the screen.
void placeDialog(QDialog &dialog);

/// Makes a window that is neither maximised nor full screen no larger than its screen has room for, frame included, and
/// moves it there. The frame is known from a window that is shown; else a title and a border are assumed.
void keepOnScreen(QWidget &window);

/// The place of a window that opens from another one, frames included: as large and a little to the right and below, or
/// further, where its title would lie on that of a window in `taken`. A window that would reach beyond the screen gets
/// smaller, and where it would get smaller than `least`, windows begin again in the screen's corner.
QRect placeCascaded(const QRect &from, const QRect &screen, QSize least, const QList<QRect> &taken);

/// Shows a window for the first time: as large as another window and off it and all others, on the same screen; maximised
/// if the other one is.
void showLike(QWidget &window, const QWidget &other);

} // namespace suffuse
