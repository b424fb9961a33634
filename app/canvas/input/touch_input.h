// Fingers on the canvas.
#pragma once

#include "model/painting/geometry.h"

#include <map>

class QTouchEvent;
class QWidget;

namespace suffuse {

class CanvasView;
class Hand;
class PaintingClock;
class CanvasPen;
struct PointerEvent;

/// Two fingers move the view; one paints, or moves the view where only the pen paints.
class TouchInput {
public:
    TouchInput(QWidget &canvas, Hand &hand, CanvasView &view, const CanvasPen &pen, const PaintingClock &clock);

    /// False if the event is another's: the touchpad's.
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
    std::map<int, Point> m_fingers; ///< that are down, by the device's numbers, and where they were last
    bool m_paints = false;          ///< one of them holds the tool
};

} // namespace suffuse
