// What fingers do on the canvas.
#pragma once

#include "model/geometry/geometry.h"

#include <map>

class QTouchEvent;
class QWidget;

namespace suffuse {

class CanvasView;
class Hand;
class PaintingClock;
class CanvasPen;
struct PointerEvent;

/// Two fingers move the view. One finger paints or, where only the pen is to paint, moves the view.
class TouchInput {
public:
    TouchInput(QWidget &canvas, Hand &hand, CanvasView &view, const CanvasPen &pen, const PaintingClock &clock);

    /// Returns false if the event is not for the canvas: a touchpad's moves the mouse.
    bool take(const QTouchEvent &event);

private:
    std::map<int, Point> placesIn(const QTouchEvent &event) const;
    PointerEvent report(const QTouchEvent &event, Point pixel) const;
    void giveUp();
    void moveView(const std::map<int, Point> &now);

    QWidget &m_canvas;
    Hand &m_hand;
    CanvasView &m_view;
    const CanvasPen &m_pen;
    const PaintingClock &m_clock;
    std::map<int, Point> m_fingers; ///< the fingers that are down, by the device's numbers, and where they were last
    bool m_paints = false;          ///< whether one of them holds the tool
};

} // namespace suffuse
