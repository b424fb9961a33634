#include "app/widgets/habits/floating_card.h"

#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/theme.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QLineEdit>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace suffuse {

namespace {

constexpr double corner = 8;
constexpr int gapToEdge = 4; ///< logical pixels that stay between it and the window's edge

bool takesTab(const QWidget &widget, const QWidget &card)
{
    return widget.focusPolicy() & Qt::TabFocus && widget.isEnabled() && !widget.focusProxy() &&
           widget.isVisibleTo(&card);
}

} // namespace

FloatingCard::FloatingCard(QWidget &served) : QFrame(served.window()), m_served(served)
{
    setFocusPolicy(Qt::ClickFocus);
    setAttribute(Qt::WA_NoMousePropagation); // what is done on it is not done on the canvas below
    setCursor(Qt::ArrowCursor);
    hide();
}

void FloatingCard::openAt(QPoint global, QPoint anchor, QWidget *child)
{
    ensurePolished();
    if (layout())
        layout()->activate();
    resize(sizeHint().boundedTo(window()->size()));
    move(parentWidget()->mapFromGlobal(global) - anchor);
    keepInside();
    qApp->installEventFilter(this);
    show();
    raise();
    window()->setAttribute(Qt::WA_KeyboardFocusChange); // styles show where the keyboard is
    QWidget *first = child && child->isEnabled() ? child : nullptr;
    for (QLineEdit *field : findChildren<QLineEdit *>()) // keys must not go on to the canvas below
        first = !first && child && field->isEnabled() && field->isVisible() ? field : first;
    (first ? first : this)->setFocus(Qt::PopupFocusReason);
}

void FloatingCard::close()
{
    if (!isVisible())
        return;
    qApp->removeEventFilter(this);
    const bool had = isAncestorOf(QApplication::focusWidget()) || hasFocus();
    if (had)
        m_served.setFocus(Qt::PopupFocusReason); // a field that has been typed into takes what stands in it
    hide();
    emit closed();
}

bool FloatingCard::holds(const QWidget *widget)
{
    while (widget && !qobject_cast<const FloatingCard *>(widget))
        widget = widget->parentWidget();
    return widget;
}

void FloatingCard::keepInside()
{
    const QRect room = parentWidget()->rect().adjusted(gapToEdge, gapToEdge, -gapToEdge, -gapToEdge);
    setGeometry(placeWithin(geometry(), room));
}

void FloatingCard::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shape;
    shape.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
    painter.fillPath(shape, palette().color(QPalette::Window));
    painter.strokePath(shape, QPen(edgeOfColours(), 1));
}

bool FloatingCard::event(QEvent *event)
{
    const bool done = QFrame::event(event);
    if (event->type() == QEvent::LayoutRequest && isVisible()) {
        resize(sizeHint().boundedTo(window()->size()));
        keepInside();
    }
    return done;
}

bool FloatingCard::isOwnKey(const QKeyEvent &event) const
{
    const QKeySequence keys(QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, Qt::Key(event.key())));
    return std::ranges::any_of(actions(), [&](const QAction *action) { return action->shortcuts().contains(keys); });
}

void FloatingCard::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        close();
    event->accept(); // nothing that is typed here is a command of the canvas
}

bool FloatingCard::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
    case QEvent::TouchBegin: {
        const auto *widget = qobject_cast<const QWidget *>(watched);
        if (widget && widget->window() == window() && widget != this && !isAncestorOf(widget))
            close();
        break;
    }
    case QEvent::KeyPress: { // before a list takes the key for the first letter of a name
        const auto *widget = qobject_cast<const QWidget *>(watched);
        const bool here =
            widget && (widget == this || isAncestorOf(widget)) && !qobject_cast<const QLineEdit *>(widget);
        if (here && isOwnKey(*static_cast<const QKeyEvent *>(event))) {
            close();
            return true;
        }
        break;
    }
    case QEvent::Resize:
        if (watched == parentWidget())
            QMetaObject::invokeMethod(this, &FloatingCard::keepInside, Qt::QueuedConnection);
        break;
    case QEvent::FocusIn: { // by keys that go elsewhere
        const auto *widget = qobject_cast<const QWidget *>(watched);
        if (widget && widget->window() == window() && widget != window() && widget != this && !isAncestorOf(widget))
            QMetaObject::invokeMethod(this, &FloatingCard::close, Qt::QueuedConnection);
        break;
    }
    default:
        break;
    }
    return QFrame::eventFilter(watched, event);
}

/// Tab goes round within it.
bool FloatingCard::focusNextPrevChild(bool next)
{
    QWidget *from = QApplication::focusWidget();
    if (!from || (from != this && !isAncestorOf(from)))
        from = this;
    for (QWidget *w = from;;) {
        w = next ? w->nextInFocusChain() : w->previousInFocusChain();
        if (w == from)
            return true;
        if (w != this && isAncestorOf(w) && takesTab(*w, *this)) {
            w->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            return true;
        }
    }
}

} // namespace suffuse
