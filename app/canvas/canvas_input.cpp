// Mouse, pen, wheel, touch and keys of the canvas: either they move the view, or the tool gets them.
#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QScopeGuard>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>

#include <chrono>
#include <numbers>

namespace suffuse {

namespace {

constexpr double zoomPerNotch = 1.25;
constexpr double notch = 120;         ///< eighths of a degree, as QWheelEvent counts
constexpr double pixelsPerNotch = 60; ///< logical pixels that a notch pans

Microseconds wallClock()
{
    using namespace std::chrono;
    return duration_cast<microseconds>(steady_clock::now().time_since_epoch()).count();
}

} // namespace

Point CanvasWidget::toPixels(const QPointF &logical) const
{
    const double dpr = devicePixelRatioF();
    return {logical.x() * dpr, logical.y() * dpr};
}

PointerEvent CanvasWidget::pointerEvent(const QSinglePointEvent &event, PointerDevice device) const
{
    PointerEvent e;
    e.pixel = toPixels(event.position());
    e.point = view().toCanvas(e.pixel);
    e.button = event.button();
    e.buttons = event.buttons();
    e.modifiers = event.modifiers();
    e.device = device;
    e.doubleClick = event.type() == QEvent::MouseButtonDblClick;
    e.time = m_editor.clock().time();
    // Reports come in bunches: the device's own stamps keep their pace.
    if (!m_editor.clock().isManual() && m_pressed && event.timestamp() >= m_pressStamp && m_pressStamp > 0) {
        const Microseconds stamped = m_pressTime + Microseconds(event.timestamp() - m_pressStamp) * 1000;
        if (std::abs(stamped - e.time) < mostLag)
            e.time = stamped;
    }
    return e;
}

CanvasWidget::Navigation CanvasWidget::navigationFor(const QSinglePointEvent &event) const
{
    if (m_panKey && event.button() == Qt::LeftButton)
        return event.modifiers() & Qt::ShiftModifier ? Navigation::Rotate : Navigation::Pan;
    if (m_turnKey && event.button() == Qt::LeftButton)
        return Navigation::Rotate;
    if (event.button() == Qt::MiddleButton)
        return Navigation::Pan;
    return Navigation::None;
}

void CanvasWidget::pointerPress(const PointerEvent &event, Navigation navigation)
{
    m_lastPixel = event.pixel;
    if (m_navigation != Navigation::None || m_pressed)
        return; // a second button changes nothing of what the first one began
    m_pressButton = event.button;
    if (navigation != Navigation::None) {
        m_navigation = navigation;
        refreshCursor();
    } else if (m_tool && event.button == Qt::LeftButton) {
        m_pressed = true;
        m_tool->press(event);
    }
}

void CanvasWidget::pointerMove(const PointerEvent &event)
{
    if (m_navigation != Navigation::None)
        navigate(event.pixel);
    else if (m_tool && m_pressed)
        m_tool->move(event);
    else if (m_tool)
        m_tool->hover(event);
    m_lastPixel = event.pixel;
    emit pointerMoved(event.point.x, event.point.y);
}

void CanvasWidget::pointerRelease(const PointerEvent &event)
{
    m_lastPixel = event.pixel;
    if (event.button != m_pressButton)
        return;
    m_pressButton = Qt::NoButton;
    if (m_navigation != Navigation::None) {
        m_navigation = Navigation::None;
        refreshCursor();
        updateOverlay(); // the angle goes
    } else if (m_pressed) {
        m_pressed = false;
        if (m_tool)
            m_tool->release(event);
    }
}

void CanvasWidget::navigate(Point pixel)
{
    if (m_navigation == Navigation::Pan) {
        m_transform.panBy(pixel - m_lastPixel);
    } else {
        const Point centre = m_transform.centrePixel();
        const Point a = m_lastPixel - centre, b = pixel - centre;
        m_transform.rotateAt(centre, std::atan2(cross(a, b), dot(a, b)));
    }
    moveByHand();
}

void CanvasWidget::mousePressEvent(QMouseEvent *event)
{
    if (m_penDown || event->source() != Qt::MouseEventNotSynthesized)
        return;
    PointerEvent e = pointerEvent(*event, PointerDevice::Mouse);
    m_pressStamp = event->timestamp();
    m_pressTime = e.time;
    pointerPress(e, navigationFor(*event));
}

void CanvasWidget::mouseMoveEvent(QMouseEvent *event)
{
    if (!m_penDown && event->source() == Qt::MouseEventNotSynthesized)
        pointerMove(pointerEvent(*event, PointerDevice::Mouse));
}

void CanvasWidget::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_penDown && event->source() == Qt::MouseEventNotSynthesized)
        pointerRelease(pointerEvent(*event, PointerDevice::Mouse));
}

void CanvasWidget::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event); // quick dots are dots; a tool may look at PointerEvent::doubleClick
}

void CanvasWidget::tabletEvent(QTabletEvent *event)
{
    event->accept(); // so that no mouse events are made of it
    const Microseconds late = m_penLag.take(event->timestamp(), wallClock());
    const bool atWork = m_pressed || m_navigation != Navigation::None;
    if (atWork && !m_penDown)
        return; // the mouse or a finger is
    const bool eraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
    turnPen(eraser);
    PointerEvent e = pointerEvent(*event, eraser ? PointerDevice::Eraser : PointerDevice::Pen);
    const bool press = event->type() == QEvent::TabletPress && !m_penDown;
    const bool sensitive = event->device()->hasCapability(QInputDevice::Capability::Pressure);
    e.pressure = m_penPressure.take(event->pressure(), press, sensitive);
    e.tiltX = event->xTilt();
    e.tiltY = event->yTilt();
    switch (event->type()) {
    case QEvent::TabletPress:
        if (m_penDown && atWork)
            return pointerMove(e); // some drivers repeat it
        m_penDown = true;
        setFocus(Qt::MouseFocusReason);
        m_pressStamp = event->timestamp();
        e.late = m_editor.clock().isManual() ? 0 : late;
        m_pressTime = e.time = m_editor.clock().momentBefore(e.late);
        pointerPress(e, navigationFor(*event));
        break;
    case QEvent::TabletMove:
        if (m_penDown && event->buttons() == Qt::NoButton && event->pressure() == 0)
            lostPen(); // it was lifted where nobody heard of it
        pointerMove(e);
        break;
    case QEvent::TabletRelease:
        m_penDown = event->buttons() != Qt::NoButton;
        pointerRelease(e);
        break;
    default:
        break;
    }
}

void CanvasWidget::wheelEvent(QWheelEvent *event)
{
    event->accept();
    const bool touchpad = !event->pixelDelta().isNull() && event->phase() != Qt::NoScrollPhase;
    const Qt::KeyboardModifiers modifiers = event->modifiers();
    const double dpr = devicePixelRatioF();
    if (touchpad && !(modifiers & Qt::ControlModifier)) {
        m_transform.panBy({event->pixelDelta().x() * dpr, event->pixelDelta().y() * dpr});
        moveByHand();
        return;
    }
    const QPoint angle = event->angleDelta();
    const bool sideways = angle.y() == 0; // a wheel that tilts
    const double notches = (sideways ? angle.x() : angle.y()) / notch;
    const double pan = notches * pixelsPerNotch * dpr;
    if (!touchpad && modifiers.testFlags(Qt::ControlModifier | Qt::ShiftModifier))
        m_transform.panBy({0, pan});
    else if (sideways || modifiers & Qt::ShiftModifier)
        m_transform.panBy({pan, 0});
    else
        m_transform.zoomAt(toPixels(event->position()), std::pow(zoomPerNotch, notches));
    moveByHand();
}

bool CanvasWidget::nativeGesture(QNativeGestureEvent *event)
{
    const Point at = toPixels(event->position());
    switch (event->gestureType()) {
    case Qt::ZoomNativeGesture:
        m_transform.zoomAt(at, 1 + event->value());
        break;
    case Qt::RotateNativeGesture:
        m_transform.rotateAt(at, event->value() * std::numbers::pi / 180);
        break;
    case Qt::SmartZoomNativeGesture:
        fit();
        return true;
    default:
        return false;
    }
    moveByHand();
    return true;
}

void CanvasWidget::noteModifiers(const QInputEvent &event)
{
    Qt::KeyboardModifiers now = event.modifiers();
    if (event.type() == QEvent::KeyPress || event.type() == QEvent::KeyRelease) { // these tell of those held before
        const int key = static_cast<const QKeyEvent &>(event).key();
        const Qt::KeyboardModifier own = key == Qt::Key_Shift     ? Qt::ShiftModifier
                                         : key == Qt::Key_Control ? Qt::ControlModifier
                                         : key == Qt::Key_Alt     ? Qt::AltModifier
                                                                  : Qt::NoModifier;
        now.setFlag(own, event.type() == QEvent::KeyPress);
    }
    if (now == m_modifiers)
        return;
    m_modifiers = now;
    emit modifiersChanged();
}

void CanvasWidget::noteBusy()
{
    const bool busy = m_tool && m_tool->isBusy();
    if (std::exchange(m_busy, busy) != busy)
        emit busyChanged();
}

bool CanvasWidget::event(QEvent *event)
{
    const auto after = qScopeGuard([this] { noteBusy(); });
    if (event->isInputEvent())
        noteModifiers(static_cast<const QInputEvent &>(*event));
    if (event->type() == QEvent::NativeGesture && nativeGesture(static_cast<QNativeGestureEvent *>(event)))
        return true;
    switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        if (touch(static_cast<QTouchEvent &>(*event))) {
            event->accept();
            return true;
        }
        break;
    default:
        break;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        // Escape gives up what is in hand before it means anything else.
        const bool givesUp = key->key() == Qt::Key_Escape && m_tool && m_tool->isBusy();
        if (givesUp || heldFor(*key) != Navigation::None || isBareKey(*key) || isToolKey(*key)) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress && isToolKey(*static_cast<QKeyEvent *>(event))) {
        keyPressEvent(static_cast<QKeyEvent *>(event)); // before Tab moves the focus
        return true;
    }
    return QWidget::event(event);
}

bool CanvasWidget::isToolKey(const QKeyEvent &event) const
{
    return m_tool && m_tool->wantsKey(event) && !m_windowKeys.contains(QKeySequence(event.keyCombination()));
}

bool CanvasWidget::isBareKey(const QKeyEvent &event) const
{
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    return m_heldKeys.bare.contains(QKeySequence(QKeyCombination(modifiers, Qt::Key(event.key()))));
}

CanvasWidget::Navigation CanvasWidget::heldFor(const QKeyEvent &event) const
{
    const Qt::KeyboardModifiers modifiers = event.modifiers() & ~Qt::KeypadModifier;
    const auto with = [&](Qt::KeyboardModifiers m) { return QKeySequence(QKeyCombination(m, Qt::Key(event.key()))); };
    if (m_heldKeys.turn.contains(with(modifiers)))
        return Navigation::Rotate;
    return m_heldKeys.pan.contains(with(modifiers)) || m_heldKeys.pan.contains(with(modifiers & ~Qt::ShiftModifier))
               ? Navigation::Pan
               : Navigation::None;
}

void CanvasWidget::keyPressEvent(QKeyEvent *event)
{
    if (const Navigation held = heldFor(*event); held != Navigation::None && !m_pressed) {
        (held == Navigation::Pan ? m_panKey : m_turnKey) = event->key();
        refreshCursor();
    } else if (isBareKey(*event)) {
        m_bareKey = event->key();
        updateOverlay();
    } else if (event->key() == Qt::Key_Escape && m_tool && m_tool->isBusy()) {
        m_pressed = false;
        m_tool->cancel();
    } else if (!m_tool || !m_tool->keyPress(event)) {
        QWidget::keyPressEvent(event);
    }
}

void CanvasWidget::keyReleaseEvent(QKeyEvent *event)
{
    if (event->isAutoRepeat())
        return;
    if (event->key() == m_panKey)
        m_panKey = 0;
    else if (event->key() == m_turnKey)
        m_turnKey = 0;
    else if (event->key() == m_bareKey)
        m_bareKey = 0, updateOverlay();
    else
        QWidget::keyReleaseEvent(event);
    refreshCursor();
}

void CanvasWidget::enterEvent(QEnterEvent *event)
{
    m_pointerInside = true;
    m_lastPixel = toPixels(event->position());
    // Keys mean the canvas when the pointer is over it, unless something is being typed.
    const QWidget *focus = QApplication::focusWidget();
    const bool typing = qobject_cast<const QLineEdit *>(focus) || qobject_cast<const QAbstractSpinBox *>(focus);
    if (!typing && isActiveWindow())
        setFocus(Qt::MouseFocusReason);
}

void CanvasWidget::leaveEvent(QEvent *)
{
    m_pointerInside = false;
    if (m_tool)
        m_tool->leave();
    emit pointerLeft();
}

void CanvasWidget::focusOutEvent(QFocusEvent *event)
{
    m_panKey = m_turnKey = 0; // their release goes elsewhere
    if (std::exchange(m_bareKey, 0))
        updateOverlay();
    if (std::exchange(m_modifiers, Qt::NoModifier) != Qt::NoModifier)
        emit modifiersChanged();
    refreshCursor();
    QWidget::focusOutEvent(event);
}

bool CanvasWidget::focusNextPrevChild(bool next)
{
    const QKeyEvent key(QEvent::KeyPress, next ? Qt::Key_Tab : Qt::Key_Backtab,
                        next ? Qt::NoModifier : Qt::ShiftModifier);
    if (next || isToolKey(key))
        return false; // Tab hides the docks, or is the tool's
    return QWidget::focusNextPrevChild(next);
}

} // namespace suffuse
