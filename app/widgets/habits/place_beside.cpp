#include "app/widgets/habits/place_beside.h"

#include "app/widgets/habits/lay_out.h"

#include <QApplication>
#include <QDialog>
#include <QGuiApplication>
#include <QScreen>
#include <QStyle>
#include <QWidget>

#include <algorithm>
#include <cstdlib>

namespace suffuse {

namespace {

constexpr int gapBeside = 16;

/// The frame that a window manager puts around a window's contents. Where it is not known, at least a title is assumed.
QMargins frameOf(const QWidget &window)
{
    const QRect framed = window.frameGeometry(), inner = window.geometry();
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
    return QMargins(inner.left() - framed.left(), std::max(inner.top() - framed.top(), title),
                    framed.right() - inner.right(), framed.bottom() - inner.bottom());
}

/// The window over which a dialog opens; null: none.
const QWidget *windowBehind(const QDialog &dialog)
{
    return dialog.parentWidget() ? dialog.parentWidget()->window() : nullptr;
}

const QScreen *screenOf(const QDialog &dialog)
{
    const QWidget *parent = windowBehind(dialog);
    return parent ? parent->screen() : dialog.screen();
}

/// The dialog's own frame is not known before it is shown.
QMargins frameOfDialog(const QDialog &dialog)
{
    const QWidget *parent = windowBehind(dialog);
    return frameOf(parent && !parent->isFullScreen() ? *parent : dialog);
}

} // namespace

QPoint placeBeside(QSize size, const QRect &what, const QRect &screen)
{
    const QPoint middle = what.center() - QPoint(size.width() / 2, size.height() / 2);
    const QPoint wishes[] = {{what.right() + gapBeside, middle.y()},
                             {what.left() - gapBeside - size.width(), middle.y()},
                             {middle.x(), what.bottom() + gapBeside},
                             {middle.x(), what.top() - gapBeside - size.height()}};
    const auto within = [&](QPoint wish) {
        return QPoint(std::max(screen.left(), std::min(wish.x(), screen.right() + 1 - size.width())),
                      std::max(screen.top(), std::min(wish.y(), screen.bottom() + 1 - size.height())));
    };
    const auto covered = [&](QPoint wish) {
        const QRect both = QRect(within(wish), size) & what;
        return qint64(both.width()) * both.height();
    };
    return within(*std::min_element(std::begin(wishes), std::end(wishes),
                                    [&](QPoint a, QPoint b) { return covered(a) < covered(b); }));
}

QRect placeWithin(const QRect &wish, const QRect &screen)
{
    const QSize size = wish.size().boundedTo(screen.size());
    return {QPoint(std::clamp(wish.left(), screen.left(), screen.right() + 1 - size.width()),
                   std::clamp(wish.top(), screen.top(), screen.bottom() + 1 - size.height())),
            size};
}

void moveBeside(QWidget &window, const QRect &what)
{
    const QScreen *screen = QGuiApplication::screenAt(what.center());
    if (what.isEmpty() || !(screen || (screen = window.screen())))
        return;
    window.adjustSize();
    // The frame that the window will have is not known yet.
    const QSize frame(0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight));
    window.move(placeBeside(window.size() + frame, what, screen->availableGeometry()));
}

QRect placeOver(QSize size, const QRect &owner, const QRect &screen)
{
    QRect wish(QPoint(), size.boundedTo(screen.size()));
    wish.moveCenter(owner.center());
    return placeWithin(wish, screen);
}

QSize roomFor(const QDialog &dialog)
{
    const QScreen *screen = screenOf(dialog);
    return screen ? screen->availableGeometry().marginsRemoved(frameOfDialog(dialog)).size() : QSize();
}

void placeDialog(QDialog &dialog)
{
    const QWidget *parent = windowBehind(dialog);
    const QScreen *screen = screenOf(dialog);
    if (!screen)
        return;
    const QRect room = screen->availableGeometry();
    const QMargins frame = frameOfDialog(dialog);
    // The dialog's children have been polished just now. A dialog that grew after it is shown would be sent to the
    // place where Qt believes it to be, which is wrong while a window manager puts its frame around it: sometimes that
    // is the corner of the screen.
    layOutNow(dialog);
    const QSize size = dialog.size().expandedTo(dialog.minimumSizeHint()).boundedTo(dialog.maximumSize());
    const QRect framed = QRect(dialog.geometry().topLeft(), size).marginsAdded(frame);
    const QRect place = dialog.testAttribute(Qt::WA_Moved)
                            ? placeWithin(framed, room)
                            : placeOver(framed.size(), parent ? parent->frameGeometry() : room, room);
    dialog.setGeometry(place.marginsRemoved(frame)); // this tells the window manager, too
}

void keepOnScreen(QWidget &window)
{
    if (!window.screen() || window.windowState() & (Qt::WindowMaximized | Qt::WindowFullScreen))
        return;
    QMargins frame = frameOf(window);
    if (window.frameGeometry() == window.geometry()) { // not known yet: there may be a border, too
        const int border = window.style()->pixelMetric(QStyle::PM_MdiSubWindowFrameWidth);
        frame += QMargins(border, 0, border, border);
    }
    const QRect framed = window.geometry().marginsAdded(frame);
    const QRect place = placeWithin(framed, window.screen()->availableGeometry());
    if (place.size() != framed.size())
        window.resize(place.marginsRemoved(frame).size());
    // A window that has no place yet gets it from the window manager.
    if (place.topLeft() != framed.topLeft() && window.testAttribute(Qt::WA_Moved))
        window.setGeometry(place.marginsRemoved(frame));
}

QRect placeCascaded(const QRect &from, const QRect &screen, QSize least, const QList<QRect> &taken)
{
    constexpr int step = 28, most = 100; // logical pixels, and tries
    const auto isFree = [&](QPoint corner) {
        return std::ranges::none_of(taken, [&](const QRect &other) {
            const QPoint apart = other.topLeft() - corner;
            return std::abs(apart.x()) < step / 2 && std::abs(apart.y()) < step / 2;
        });
    };
    QPoint corner = from.topLeft();
    int rounds = 0;
    for (int i = 0; i < most; ++i) {
        corner += QPoint(step, step);
        QRect place = QRect(corner, from.size()) & screen;
        if (place.width() < least.width() || place.height() < least.height()) {
            corner = screen.topLeft() + QPoint(step * rounds++, 0);
            place = QRect(corner, from.size()) & screen;
        }
        if (isFree(corner) && place.width() >= least.width() && place.height() >= least.height())
            return place;
    }
    return placeWithin(from.translated(step, step), screen);
}

void showLike(QWidget &window, const QWidget &other)
{
    const QRect normal = other.isMaximized() || other.isFullScreen() ? other.normalGeometry() : other.geometry();
    const QMargins frame = frameOf(other);
    const QRect from = (normal.isEmpty() ? other.geometry() : normal).marginsAdded(frame);
    QList<QRect> taken = {from};
    for (const QWidget *shown : QApplication::topLevelWidgets())
        if (shown != &window && shown->isVisible() && shown->windowType() == Qt::Window)
            taken.append(shown->geometry().marginsAdded(frame));
    const QSize least =
        (window.minimumSizeHint().grownBy(frame)).expandedTo(from.size() * 3 / 5).boundedTo(from.size());
    window.setGeometry(placeCascaded(from, other.screen()->availableGeometry(), least, taken).marginsRemoved(frame));
    if (other.isMaximized())
        window.showMaximized();
    else
        window.show();
}

} // namespace suffuse
