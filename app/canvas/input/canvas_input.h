// Mouse, pen, fingers, wheel and keys of the canvas.
#pragma once

#include "app/canvas/input/canvas_pen.h"
#include "app/canvas/input/hand.h"
#include "app/canvas/input/held_keys.h"
#include "app/canvas/input/keyboard_pen.h"
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

/// Makes reports of the events that the canvas' widget gets, by which either the view is moved or the tool works. The
/// widget calls it for each event, and deals itself with what it does not use.
class CanvasInput : public QObject {
    Q_OBJECT

public:
    CanvasInput(QWidget &canvas, CanvasView &view, CanvasHandles &handles, const PaintingClock &clock);

    Hand &hand() { return m_hand; }
    const Hand &hand() const { return m_hand; }
    CanvasPen &pen() { return m_pen; }
    const CanvasPen &pen() const { return m_pen; }
    KeyboardPen &keyboardPen() { return m_keyboardPen; }
    const KeyboardPen &keyboardPen() const { return m_keyboardPen; }
    KeysDown &keys() { return m_keys; }
    const KeysDown &keys() const { return m_keys; }
    /// From now on a drag of the left button moves the view.
    void setLooksOnly() { m_looksOnly = true; }
    /// Sets keys that belong to the window even where the tool wants them.
    void setWindowKeys(const QList<QKeySequence> &keys) { m_windowKeys = keys; }
    /// The modifier keys that were held at the last event.
    Qt::KeyboardModifiers modifiers() const { return m_modifiers; }
    /// Where the pointer is, in device pixels; no value where it is not over the canvas.
    std::optional<Point> pointer() const;
    QCursor cursor() const;

    /// Takes an event before all others see it. Returns true if nothing else is to be done with the event.
    bool take(QEvent *event);
    /// Takes a key that was pressed. Returns false if it means nothing to the canvas.
    bool keyPress(QKeyEvent *event);
    /// Takes a key that was released. Returns false if it means nothing to the canvas.
    bool keyRelease(const QKeyEvent &event);
    /// Whether a key means the tool, even where it is the shortcut of a command.
    bool isToolKey(const QKeyEvent &event) const;
    void mousePress(const QMouseEvent &event);
    void mouseMove(const QMouseEvent &event);
    void mouseRelease(const QMouseEvent &event);
    void tablet(const QTabletEvent &event);
    void wheel(const QWheelEvent &event);
    void enter(const QPointF &position);
    void leave();
    /// Takes the loss of the keyboard. Where a menu or a dialog has taken it, the pointer's release goes there, too, so
    /// what is in hand is finished as if it had been let go.
    void focusOut(Qt::FocusReason reason);
    /// Ends what is in hand as the release of the button would.
    void finish();
    /// Emits `busyChanged` if something has come into the tool's hand, has left it, or is pressed no more, since it was
    /// last emitted.
    void noteBusy();

signals:
    void modifiersChanged();
    void busyChanged(); ///< something has come into the tool's hand, has left it, or is pressed no more
    void cursorChanged();
    void overlayChanged(); ///< what lies over the picture has changed
    void fitWanted();
    void pointerLeft();
    void penTurned(bool eraser); ///< emitted before the first report of the pen's other end

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
    void finishHand(PointerDevice device);

    QWidget &m_canvas;
    CanvasView &m_view;
    const CanvasHandles &m_handles;
    const PaintingClock &m_clock;
    Hand m_hand;
    KeyboardPen m_keyboardPen;
    CanvasPen m_pen;
    KeysDown m_keys;
    TouchInput m_touch;
    QList<QKeySequence> m_windowKeys;
    Qt::KeyboardModifiers m_modifiers;
    bool m_looksOnly = false;
    bool m_pressedHere = false; ///< whether the last press of the mouse in the program was on the canvas
    bool m_pointerInside = false;
    std::optional<QPoint> m_leftAt; ///< where the pointer rests on the screen, though it was said to leave
    int m_busy = 0;           ///< what the last `busyChanged` said: 1: something is in hand; 2: and the tool is pressed
    quint64 m_pressStamp = 0; ///< milliseconds of the device's clock
    Microseconds m_pressTime = 0; ///< the document time of the press
};

} // namespace suffuse
