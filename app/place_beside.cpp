#include "app/place_beside.h"

#include <QGuiApplication>
#include <QScreen>
#include <QStyle>
#include <QWidget>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int gap = 16;

} // namespace

QPoint placeBeside(QSize size, const QRect &what, const QRect &screen)
{
    const QPoint middle = what.center() - QPoint(size.width() / 2, size.height() / 2);
    const QPoint wishes[] = {{what.right() + gap, middle.y()},
                             {what.left() - gap - size.width(), middle.y()},
                             {middle.x(), what.bottom() + gap},
                             {middle.x(), what.top() - gap - size.height()}};
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
    // The frame that it will have is not known yet.
    const QSize frame(0, window.style()->pixelMetric(QStyle::PM_TitleBarHeight));
    window.move(placeBeside(window.size() + frame, what, screen->availableGeometry()));
}

void showLike(QWidget &window, const QWidget &other)
{
    constexpr int step = 28;
    const QRect normal = other.isMaximized() || other.isFullScreen() ? other.normalGeometry() : other.geometry();
    // What is around the contents; where that is not known, at least a title.
    const QRect framed = other.frameGeometry(), inner = other.geometry();
    const int title = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
    const QMargins frame(inner.left() - framed.left(), std::max(inner.top() - framed.top(), title),
                         framed.right() - inner.right(), framed.bottom() - inner.bottom());
    const QRect wish = (normal.isEmpty() ? inner : normal).translated(step, step).marginsAdded(frame);
    window.setGeometry(placeWithin(wish, other.screen()->availableGeometry()).marginsRemoved(frame));
    if (other.isMaximized())
        window.showMaximized();
    else
        window.show();
}

} // namespace suffuse
