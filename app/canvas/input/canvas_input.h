// Mouse, pen, fingers, wheel and keys of the canvas.
#pragma once

#include "app/canvas/input/canvas_pen.h"
#include "app/canvas/input/hand.h"
#include "app/canvas/input/held_keys.h"
#include "app/canvas/input/touch_input.h"

#include <QCursor>
#include <QObject>

#include <optional>

class QFocusEvent;
class QInputEvent;
class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QSinglePointEvent;
class QTabletEvent;
class QWheelEvent;

namespace suffuse {

/// Makes reports of the events of the canvas' widget: either they move the view, or the tool gets them. The widget
/// calls it; what it does not use is the widget's.
class CanvasInput : public QObject {
    Q_OBJECT

public:
    CanvasInput(QWidget &canvas, CanvasView &view, const PaintingClock &clock);

    Hand &hand() { return m_hand; }
    const Hand &hand() const { return m_hand; }
    CanvasPen &pen() { return m_pen; }
    const CanvasPen &pen() const { return m_pen; }
    KeysDown &keys() { return m_keys; }
    const KeysDown &keys() const { return m_keys; }
    /// Keys that stay the window's even where the tool wants them.
    void setWindowKeys(const QList<QKeySequence> &keys) { m_windowKeys = keys; }
    /// The modifier keys as the last event left them.
    Qt::KeyboardModifiers modifiers() const { return m_modifiers; }
    /// Where the pointer is, if it is over the canvas; device pixels.
    std::optional<Point> pointer() const;
    QCursor cursor() const;

    /// Events that come before all others; true if nothing else is to be done with it.
    bool take(QEvent *event);
    /// The same of a key.
    bool keyPress(QKeyEvent *event);
    bool keyRelease(const QKeyEvent &event);
    bool isToolKey(const QKeyEvent &event) const;
    void mousePress(const QMouseEvent &event);
    void mouseMove(const QMouseEvent &event);
    void mouseRelease(const QMouseEvent &event);
    void tablet(const QTabletEvent &event);
    void wheel(const QWheelEvent &event);
    void enter(const QPointF &position);
    void leave();
    void focusOut();
    /// Tells whether something is in the tool's hand, where that is new.
    void noteBusy();

signals:
    void modifiersChanged();
    void busyChanged(); ///< something is in the tool's hand, or no more
    void cursorChanged();
    void overlayChanged(); ///< other things lie over the picture
    void fitWanted();
    void pointerLeft();
    void penTurned(bool eraser); ///< before the first report of the pen's other end

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    PointerEvent report(const QSinglePointEvent &event, PointerDevice device) const;
    Navigation navigationFor(const QSinglePointEvent &event) const;
    void pressPen(const QTabletEvent &event, PointerEvent report, Microseconds late);
    bool nativeGesture(const QNativeGestureEvent &event);
    bool isBusy() const;
    void noteModifiers(const QInputEvent &event);
    void turnPen(bool eraser);
    void lostPen();

    QWidget &m_canvas;
    CanvasView &m_view;
    const PaintingClock &m_clock;
    Hand m_hand;
    CanvasPen m_pen;
    KeysDown m_keys;
    TouchInput m_touch;
    QList<QKeySequence> m_windowKeys;
    Qt::KeyboardModifiers m_modifiers;
    bool m_pointerInside = false;
    bool m_busy = false;          ///< as `busyChanged` told last
    quint64 m_pressStamp = 0;     ///< milliseconds, the device's clock
    Microseconds m_pressTime = 0; ///< document time of the press
};

} // namespace suffuse
