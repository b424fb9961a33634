// A pen that is moved by keys, for who has no mouse and no tablet in the hand.
#pragma once

#include "app/canvas/input/pointer_event.h"

#include <QObject>

class QKeyEvent;
class QPainter;

namespace suffuse {

class CanvasView;
class Hand;
class PaintingClock;

/// While it is on, arrow keys move a crosshair over the canvas, and Space or Return presses it down and lifts it. What
/// it does goes through the hand, so that every tool takes it as it takes a mouse. The digits of the keypad move it, too,
/// those in its corners aslant. Two arrow keys that are held move it aslant as well. Plus and minus change the pressure.
/// Esc gives up what is in hand, and puts the pen away where nothing is.
class KeyboardPen : public QObject {
    Q_OBJECT

public:
    KeyboardPen(QWidget &canvas, Hand &hand, CanvasView &view, const PaintingClock &clock, QObject *parent = nullptr);

    bool isOn() const { return m_on; }
    /// Takes the pen to the hand or puts it away. What it has drawn so far is finished then. It begins at a pixel of the
    /// canvas widget, device pixels.
    void setOn(bool on, Point pixel);
    /// Whether it is pressed down.
    bool isDown() const;
    /// Where it is, canvas units.
    Point point() const { return m_point; }
    /// [0.1, 1], with which it presses.
    double pressure() const { return m_tenths / 10.0; }
    /// Lifts it where it is, as if its key had been pressed.
    void finish();

    /// Lifts it so that nothing becomes of what is in hand. To be called while it is pressed down.
    void giveUp();

    /// Whether a key means the pen at the moment.
    bool wantsKey(const QKeyEvent &event) const;
    /// Takes a key that means the pen.
    void keyPress(const QKeyEvent &event);
    void keyRelease(const QKeyEvent &event);
    /// Forgets which arrow keys are held: their releases go elsewhere.
    void forgetKeys() { m_held = {}; }

    /// Draws the crosshair, in device pixels.
    void paint(QPainter &painter, double dpr) const;

signals:
    void onChanged(bool on);
    void moved();           ///< by a key
    void lowered();         ///< it is pressed down now
    void lifted();          ///< the tool has done what it does on a release
    void gaveUp();          ///< nothing became of what was in hand
    void pressureChanged(); ///< of what is drawn next, and of what is in hand
    void overlayChanged();  ///< the crosshair looks another way, or stands elsewhere

private:
    PointerEvent report(Qt::KeyboardModifiers modifiers) const;
    void moveBy(Point pixels);
    void press(Qt::KeyboardModifiers modifiers);
    void lift(Qt::KeyboardModifiers modifiers);
    void stepPressure(int by);

    QWidget &m_canvas;
    Hand &m_hand;
    CanvasView &m_view;
    const PaintingClock &m_clock;
    bool m_on = false;
    bool m_down = false;
    int m_tenths = 10; ///< of the full pressure
    Point m_point;     ///< canvas units
    struct Held {
        bool left = false, right = false, up = false, down = false;
    } m_held;
};

} // namespace suffuse
