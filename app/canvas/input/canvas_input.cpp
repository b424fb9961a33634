#include "app/canvas/input/canvas_input.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/handles/canvas_handles.h"
#include "app/canvas/tool.h"
#include "app/session/painting_clock.h"
#include "app/widgets/habits/floating_card.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>

#include <numbers>

namespace suffuse {

namespace {

constexpr double zoomPerNotch = 1.25;
constexpr double notch = 120;         ///< a notch of the wheel in eighths of a degree, as QWheelEvent counts
constexpr double pixelsPerNotch = 60; ///< logical pixels by which a notch pans

bool isSynthesized(const QMouseEvent &event)
{
    return event.source() != Qt::MouseEventNotSynthesized;
}

} // namespace

CanvasInput::CanvasInput(QWidget &canvas, CanvasView &view, CanvasHandles &handles, const PaintingClock &clock)
    : m_canvas(canvas), m_view(view), m_handles(handles), m_clock(clock), m_hand(view, handles),
      m_keyboardPen(canvas, m_hand, view, clock), m_touch(canvas, m_hand, view, m_pen, clock)
{
    qApp->installEventFilter(this); // The filter hears when the pen comes near the tablet, and where clicks are meant.
    connect(&m_hand, &Hand::handleChanged, this, &CanvasInput::cursorChanged);
    connect(&m_hand, &Hand::navigationChanged, this, [this] {
        emit cursorChanged();
        if (m_hand.navigation() == Navigation::None)
            emit overlayChanged(); // The angle beside the pointer disappears.
    });
    connect(&m_keyboardPen, &KeyboardPen::overlayChanged, this, [this] {
        emit overlayChanged();
        noteBusy();
    });
}

std::optional<Point> CanvasInput::pointer() const
{
    return m_pointerInside ? std::optional(m_hand.lastPixel()) : std::nullopt;
}

QCursor CanvasInput::cursor() const
{
    if (m_hand.navigation() == Navigation::Pan)
        return Qt::ClosedHandCursor;
    if (m_keys.pans())
        return Qt::OpenHandCursor;
    if (m_hand.navigation() == Navigation::Rotate || m_keys.turns())
        return Qt::SizeAllCursor;
    if (!m_hand.isPressed())
        if (const std::optional<QCursor> handle = m_handles.cursorAt(m_hand.lastPixel()))
            return *handle;
    if (m_looksOnly)
        return Qt::OpenHandCursor;
    return m_hand.tool() ? m_hand.tool()->cursor() : QCursor(Qt::ArrowCursor);
}

bool CanvasInput::isBusy() const
{
    return m_hand.tool() && m_hand.tool()->isBusy();
}

void CanvasInput::noteBusy()
{
    // Some tools have something in hand between two presses, too.
    const int busy = isBusy() ? 1 + m_hand.isPressed() : 0;
    if (std::exchange(m_busy, busy) != busy)
        emit busyChanged();
}

PointerEvent CanvasInput::report(const QSinglePointEvent &event, PointerDevice device) const
{
    PointerEvent e;
    e.pixel = devicePixels(m_canvas, event.position());
    e.point = m_view.view().toCanvas(e.pixel);
    e.button = event.button();
    e.buttons = event.buttons();
    e.modifiers = event.modifiers();
    e.device = device;
    e.doubleClick = event.type() == QEvent::MouseButtonDblClick;
    e.time = m_clock.time();
    // Reports arrive in bunches, so their times are taken from the stamps of the device.
    if (!m_clock.isManual() && m_hand.isPressed() && event.timestamp() >= m_pressStamp && m_pressStamp > 0) {
        const Microseconds stamped = m_pressTime + Microseconds(event.timestamp() - m_pressStamp) * 1000;
        if (std::abs(stamped - e.time) < mostLag)
            e.time = stamped;
    }
    return e;
}

Navigation CanvasInput::navigationFor(const QSinglePointEvent &event) const
{
    if (event.button() == Qt::LeftButton) {
        const Navigation held = m_keys.navigation(event.modifiers());
        return m_looksOnly && held == Navigation::None ? Navigation::Pan : held;
    }
    return event.button() == Qt::MiddleButton ? Navigation::Pan : Navigation::None;
}

void CanvasInput::mousePress(const QMouseEvent &event)
{
    if (m_pen.isDown() || m_keyboardPen.isDown() || isSynthesized(event))
        return;
    if (event.type() == QEvent::MouseButtonPress)
        m_pressedHere = true;
    else if (!m_pressedHere)
        return; // The first click of the two was for a window that it closed.
    const PointerEvent e = report(event, PointerDevice::Mouse);
    m_pressStamp = event.timestamp();
    m_pressTime = e.time;
    m_hand.press(e, navigationFor(event));
}

void CanvasInput::mouseMove(const QMouseEvent &event)
{
    if (!m_pen.isDown() && !m_keyboardPen.isDown() && !isSynthesized(event))
        m_hand.move(report(event, PointerDevice::Mouse));
}

void CanvasInput::mouseRelease(const QMouseEvent &event)
{
    if (!m_pen.isDown() && !m_keyboardPen.isDown() && !isSynthesized(event))
        m_hand.release(report(event, PointerDevice::Mouse));
}

void CanvasInput::tablet(const QTabletEvent &event)
{
    const Microseconds late = m_pen.lateness(event.timestamp());
    if (!m_hand.isFree() && !m_pen.isDown())
        return; // The mouse or a finger holds the tool.
    const bool eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
    turnPen(eraser);
    PointerEvent e = report(event, eraser ? PointerDevice::Eraser : PointerDevice::Pen);
    const bool press = event.type() == QEvent::TabletPress && !m_pen.isDown();
    const bool sensitive = event.device()->hasCapability(QInputDevice::Capability::Pressure);
    e.pressure = m_pen.pressure(event.pressure(), press, sensitive);
    e.tiltX = event.xTilt();
    e.tiltY = event.yTilt();
    switch (event.type()) {
    case QEvent::TabletPress:
        pressPen(event, e, late);
        break;
    case QEvent::TabletMove:
        if (m_pen.isDown() && event.buttons() == Qt::NoButton && event.pressure() == 0)
            lostPen(); // The pen was lifted where no report could tell of it.
        m_hand.move(e);
        break;
    case QEvent::TabletRelease:
        m_pen.setDown(event.buttons() != Qt::NoButton);
        m_hand.release(e);
        break;
    default:
        break;
    }
}

void CanvasInput::pressPen(const QTabletEvent &event, PointerEvent report, Microseconds late)
{
    if (m_pen.isDown() && !m_hand.isFree())
        return m_hand.move(report); // Some drivers repeat a press.
    m_pen.setDown(true);
    m_canvas.setFocus(Qt::MouseFocusReason);
    m_pressStamp = event.timestamp();
    report.late = m_clock.isManual() ? 0 : late;
    m_pressTime = report.time = m_clock.momentBefore(report.late);
    m_hand.press(report, navigationFor(event));
}

void CanvasInput::turnPen(bool eraser)
{
    if (eraser == m_pen.isTurned() || m_hand.isPressed())
        return;
    m_pen.setTurned(eraser);
    emit penTurned(eraser);
}

/// Makes the release of a pen that was lifted without a report.
void CanvasInput::lostPen()
{
    m_pen.setDown(false);
    finishHand(m_pen.isTurned() ? PointerDevice::Eraser : PointerDevice::Pen);
}

/// Makes a release that no device has reported, where the pointer was last.
void CanvasInput::finishHand(PointerDevice device)
{
    if (m_hand.button() == Qt::NoButton)
        return;
    PointerEvent event;
    event.pixel = m_hand.lastPixel();
    event.point = m_view.view().toCanvas(event.pixel);
    if (device != PointerDevice::Mouse)
        event.pressure = 0;
    event.time = m_clock.time();
    event.button = m_hand.button();
    event.device = device;
    m_hand.release(event);
    noteBusy();
}

void CanvasInput::finish()
{
    if (m_pen.isDown())
        lostPen();
    else if (m_keyboardPen.isDown())
        m_keyboardPen.finish();
    else if (!m_hand.isFree())
        finishHand(PointerDevice::Mouse);
}

bool CanvasInput::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::TabletEnterProximity) {
        m_pen.setNear(true);
        const auto *tablet = static_cast<QTabletEvent *>(event);
        if (m_canvas.isActiveWindow())
            turnPen(tablet->pointerType() == QPointingDevice::PointerType::Eraser);
    } else if (event->type() == QEvent::TabletLeaveProximity) {
        m_pen.setNear(false);
        if (m_pen.isDown())
            lostPen();
        m_hand.leave();
    } else if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType() && watched != &m_canvas) {
        m_pressedHere = false;
    }
    return QObject::eventFilter(watched, event);
}

void CanvasInput::wheel(const QWheelEvent &event)
{
    const bool touchpad = !event.pixelDelta().isNull() && event.phase() != Qt::NoScrollPhase;
    const Qt::KeyboardModifiers modifiers = event.modifiers();
    if (touchpad && !(modifiers & Qt::ControlModifier))
        return m_view.panBy(devicePixels(m_canvas, event.pixelDelta()));
    const QPoint angle = event.angleDelta();
    const bool sideways = angle.y() == 0; // A wheel that tilts scrolls sideways.
    const double notches = (sideways ? angle.x() : angle.y()) / notch;
    if (!sideways && !(modifiers & Qt::ControlModifier) && m_hand.isPressed() && m_hand.tool()->wheel(notches))
        return;
    const double pan = notches * pixelsPerNotch * m_canvas.devicePixelRatioF();
    if (!touchpad && modifiers.testFlags(Qt::ControlModifier | Qt::ShiftModifier))
        m_view.panBy({0, pan});
    else if (sideways || modifiers & Qt::ShiftModifier)
        m_view.panBy({pan, 0});
    else
        m_view.zoomAt(devicePixels(m_canvas, event.position()), std::pow(zoomPerNotch, notches));
}

bool CanvasInput::nativeGesture(const QNativeGestureEvent &event)
{
    const Point at = devicePixels(m_canvas, event.position());
    switch (event.gestureType()) {
    case Qt::ZoomNativeGesture:
        m_view.zoomAt(at, 1 + event.value());
        return true;
    case Qt::RotateNativeGesture:
        m_view.rotateAt(at, event.value() * std::numbers::pi / 180);
        return true;
    case Qt::SmartZoomNativeGesture:
        emit fitWanted();
        return true;
    default:
        return false;
    }
}

void CanvasInput::noteModifiers(const QInputEvent &event)
{
    Qt::KeyboardModifiers now = event.modifiers();
    // The event tells which modifier keys were held before it.
    if (event.type() == QEvent::KeyPress || event.type() == QEvent::KeyRelease) {
        const int key = static_cast<const QKeyEvent &>(event).key();
        const Qt::KeyboardModifier own = key == Qt::Key_Shift     ? Qt::ShiftModifier
                                         : key == Qt::Key_Control ? Qt::ControlModifier
                                         : key == Qt::Key_Alt     ? Qt::AltModifier
                                                                  : Qt::NoModifier;
        now.setFlag(own, event.type() == QEvent::KeyPress);
    }
    if (std::exchange(m_modifiers, now) != now)
        emit modifiersChanged();
}

bool CanvasInput::take(QEvent *event)
{
    if (event->isInputEvent())
        noteModifiers(static_cast<const QInputEvent &>(*event));
    switch (event->type()) {
    case QEvent::NativeGesture:
        return nativeGesture(static_cast<QNativeGestureEvent &>(*event));
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
        if (!m_touch.take(static_cast<QTouchEvent &>(*event)))
            return false;
        event->accept();
        return true;
    case QEvent::ShortcutOverride: {
        const auto &key = static_cast<QKeyEvent &>(*event);
        // Escape gives up what is in hand before it means anything else.
        const bool givesUp = key.key() == Qt::Key_Escape && (isBusy() || m_hand.holdsHandle());
        if (!givesUp && m_keys.navigationOf(key) == Navigation::None && !m_keys.isBareKey(key) && !isToolKey(key) &&
            !m_keyboardPen.wantsKey(key))
            return false;
        event->accept();
        return true;
    }
    case QEvent::KeyPress: { // The canvas needs the key before Tab moves the focus.
        auto *key = static_cast<QKeyEvent *>(event);
        const bool isTab = key->key() == Qt::Key_Tab || key->key() == Qt::Key_Backtab;
        if (!isToolKey(*key)) // While the tool is pressed, the keyboard stays.
            return isTab && m_hand.isPressed();
        if (!keyPress(key))
            key->ignore();
        return true;
    }
    default:
        return false;
    }
}

bool CanvasInput::isToolKey(const QKeyEvent &event) const
{
    return m_hand.tool() && m_hand.tool()->wantsKey(event) &&
           !m_windowKeys.contains(QKeySequence(event.keyCombination()));
}

bool CanvasInput::keyPress(QKeyEvent *event)
{
    if (m_hand.tool() && m_hand.tool()->takesText() && m_hand.tool()->keyPress(event))
        return true;
    if (m_keyboardPen.wantsKey(*event)) {
        m_keyboardPen.keyPress(*event);
        return true;
    }
    const Navigation held = m_keys.navigationOf(*event);
    if (held != Navigation::None && !m_hand.isPressed()) {
        m_keys.pressNavigation(held, event->key());
        emit cursorChanged();
    } else if (m_keys.isBareKey(*event)) {
        m_keys.pressBare(event->key());
        emit overlayChanged();
    } else if (event->key() == Qt::Key_Escape && (isBusy() || m_hand.holdsHandle())) {
        m_hand.cancel();
    } else {
        return m_hand.tool() && m_hand.tool()->keyPress(event);
    }
    return true;
}

bool CanvasInput::keyRelease(const QKeyEvent &event)
{
    m_keyboardPen.keyRelease(event);
    if (event.isAutoRepeat())
        return true;
    const bool wasBare = m_keys.isBare();
    const bool used = m_keys.release(event.key());
    if (wasBare && !m_keys.isBare())
        emit overlayChanged();
    emit cursorChanged();
    return used;
}

void CanvasInput::enter(const QPointF &position)
{
    m_pointerInside = true;
    m_hand.enter(devicePixels(m_canvas, position));
    // It is as if the pointer came where a menu closes that was opened by a key elsewhere, and covered the canvas.
    const QPoint at = m_canvas.mapToGlobal(position).toPoint();
    if (const auto left = std::exchange(m_leftAt, std::nullopt); left && (at - *left).manhattanLength() <= 1)
        return;
    // While the pointer is over the canvas, keys mean the canvas, unless something is being typed.
    const QWidget *focus = QApplication::focusWidget();
    const bool typing = qobject_cast<const QLineEdit *>(focus) || qobject_cast<const QAbstractSpinBox *>(focus);
    if (!typing && !FloatingCard::holds(focus) && m_canvas.isActiveWindow())
        m_canvas.setFocus(Qt::MouseFocusReason);
}

void CanvasInput::leave()
{
    m_pointerInside = false;
    m_leftAt.reset();
    if (const QPoint at = QCursor::pos(); m_canvas.rect().contains(m_canvas.mapFromGlobal(at)))
        m_leftAt = at; // It has not moved: something covers the canvas.
    m_hand.leave();
    emit pointerLeft();
}

void CanvasInput::focusOut(Qt::FocusReason reason)
{
    const bool opens = reason == Qt::PopupFocusReason || reason == Qt::MenuBarFocusReason ||
                       QApplication::activePopupWidget() || QApplication::activeModalWidget();
    if (opens && !m_hand.isFree()) // Later, since the tool itself may be opening something.
        QMetaObject::invokeMethod(this, &CanvasInput::finish, Qt::QueuedConnection);
    if (m_keyboardPen.isDown()) // Its keys go elsewhere now, and nothing else could lift it.
        QMetaObject::invokeMethod(this, &CanvasInput::finish, Qt::QueuedConnection);
    m_keyboardPen.forgetKeys();
    const bool wasBare = m_keys.isBare();
    m_keys.forget(); // The release of the keys will go elsewhere.
    if (wasBare)
        emit overlayChanged();
    if (std::exchange(m_modifiers, Qt::NoModifier) != Qt::NoModifier)
        emit modifiersChanged();
    emit cursorChanged();
}

} // namespace suffuse
