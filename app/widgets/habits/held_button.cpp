#include "app/widgets/habits/held_button.h"

#include <QApplication>
#include <QDrag>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWidget>

namespace suffuse {

namespace {

/// Follows the button that one widget holds. While there is none, it listens to that widget alone.
class HeldButton : public QObject {
public:
    explicit HeldButton(QWidget &widget) : QObject(&widget), m_widget(widget) { widget.installEventFilter(this); }

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (isHeld() && event->type() == QEvent::Show && covers(*watched))
            letGo();
        if (isHeld() && event->type() == QEvent::KeyPress && walks(*static_cast<const QKeyEvent *>(event)))
            return true;
        if (watched != &m_widget)
            return QObject::eventFilter(watched, event);
        const auto mouse = [event]() -> const QMouseEvent & { return *static_cast<const QMouseEvent *>(event); };
        switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            if (!isHeld())
                take(mouse());
            break;
        case QEvent::MouseMove:
            if (isHeld() && !(mouse().buttons() & m_button))
                letGo();
            follow(mouse());
            break;
        case QEvent::MouseButtonRelease:
            if (mouse().button() == m_button)
                forget();
            break;
        default:
            break;
        }
        return QObject::eventFilter(watched, event);
    }

    void letGo()
    {
        if (!isHeld())
            return;
        QMouseEvent release(QEvent::MouseButtonRelease, m_at, m_onScreen, m_button, Qt::NoButton,
                            QApplication::keyboardModifiers());
        forget();
        QApplication::sendEvent(&m_widget, &release);
    }

private:
    bool isHeld() const { return m_button != Qt::NoButton; }

    /// Whether a window that opens takes the mouse.
    static bool covers(const QObject &watched)
    {
        const auto *widget = qobject_cast<const QWidget *>(&watched);
        return widget && widget->isWindow() && (widget->isModal() || widget->windowType() == Qt::Popup);
    }

    /// Whether a key takes the keyboard elsewhere, where the next keys would do what nobody means in a drag.
    static bool walks(const QKeyEvent &key) { return key.key() == Qt::Key_Tab || key.key() == Qt::Key_Backtab; }

    void take(const QMouseEvent &mouse)
    {
        m_button = mouse.button();
        follow(mouse);
        qApp->installEventFilter(this);
    }

    void follow(const QMouseEvent &mouse)
    {
        m_at = mouse.position();
        m_onScreen = mouse.globalPosition();
    }

    void forget()
    {
        m_button = Qt::NoButton;
        qApp->removeEventFilter(this);
    }

    QWidget &m_widget;
    Qt::MouseButton m_button = Qt::NoButton;
    QPointF m_at, m_onScreen;
};

} // namespace

void endDragsWhenCovered(QWidget &dragged)
{
    new HeldButton(dragged); // belongs to the widget
}

void endDragsIn(const QWidget &panel)
{
    for (QObject *child : panel.findChildren<QObject *>())
        if (auto *held = dynamic_cast<HeldButton *>(child))
            held->letGo();
}

KeysEndDrag::KeysEndDrag() : KeysEndDrag(&QDrag::cancel) {}

KeysEndDrag::KeysEndDrag(std::function<void()> end) : m_end(std::move(end))
{
    // The filter that comes last is asked first, and QDrag adds its own when it begins.
    QTimer::singleShot(0, this, [this] { qApp->installEventFilter(this); });
}

bool KeysEndDrag::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || !givesUpDrag(*static_cast<QKeyEvent *>(event)))
        return QObject::eventFilter(watched, event);
    m_end();
    return true;
}

bool givesUpDrag(const QKeyEvent &key)
{
    return key.key() == Qt::Key_Escape || key.key() == Qt::Key_Delete || key.matches(QKeySequence::Undo);
}

} // namespace suffuse
