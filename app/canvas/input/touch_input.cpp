#include "app/canvas/input/touch_input.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/input/canvas_pen.h"
#include "app/canvas/input/hand.h"
#include "app/session/painting_clock.h"

#include <QTouchEvent>
#include <QWidget>

#include <vector>

namespace suffuse {

TouchInput::TouchInput(QWidget &canvas, Hand &hand, CanvasView &view, const CanvasPen &pen, const PaintingClock &clock)
    : m_canvas(canvas), m_hand(hand), m_view(view), m_pen(pen), m_clock(clock)
{}

PointerEvent TouchInput::report(const QTouchEvent &event, Point pixel) const
{
    PointerEvent e;
    e.pixel = pixel;
    e.point = m_view.view().toCanvas(pixel);
    e.time = m_clock.time();
    e.button = event.type() == QEvent::TouchUpdate ? Qt::NoButton : Qt::LeftButton;
    e.buttons = event.type() == QEvent::TouchEnd ? Qt::NoButton : Qt::LeftButton;
    e.modifiers = event.modifiers();
    return e;
}

void TouchInput::giveUp()
{
    if (!m_paints)
        return;
    m_paints = false;
    m_hand.cancel();
}

/// The places of the fingers in device pixels, by the device's numbers.
std::map<int, Point> TouchInput::placesIn(const QTouchEvent &event) const
{
    std::map<int, Point> now;
    for (const QEventPoint &point : event.points()) {
        if (point.state() == QEventPoint::Released && event.points().size() > 1)
            continue;
        // The place that is reported for a finger that stands still is not reliable, so its last place counts.
        const auto last = m_fingers.find(point.id());
        const bool still = point.state() == QEventPoint::Stationary && last != m_fingers.end();
        now[point.id()] = still ? last->second : devicePixels(m_canvas, point.position());
    }
    return now;
}

bool TouchInput::take(const QTouchEvent &event)
{
    if (event.device()->type() == QInputDevice::DeviceType::TouchPad)
        return false; // Fingers on a touchpad move the mouse.
    const bool otherAtWork = !m_paints && !m_hand.isFree();
    if (event.type() == QEvent::TouchCancel || m_pen.isNear() || m_pen.isDown() || otherAtWork) {
        giveUp(); // It was the hand that holds the pen.
        m_fingers.clear();
        return true;
    }
    const std::map<int, Point> now = placesIn(event);
    if (event.type() == QEvent::TouchBegin && now.size() == 1 && !m_pen.settings().fingersMoveView) {
        m_paints = true;
        m_canvas.setFocus(Qt::MouseFocusReason);
        m_hand.press(report(event, now.begin()->second), Navigation::None);
    } else if (m_paints && now.size() > 1) {
        giveUp();
    } else if (m_paints && event.type() == QEvent::TouchEnd) {
        m_paints = false;
        m_hand.release(report(event, m_hand.lastPixel()));
    } else if (m_paints) {
        m_hand.move(report(event, now.begin()->second));
    } else {
        moveView(now);
    }
    m_fingers = event.type() == QEvent::TouchEnd ? std::map<int, Point>() : now;
    return true;
}

void TouchInput::moveView(const std::map<int, Point> &now)
{
    std::vector<std::pair<Point, Point>> moved; // places from which and to which fingers have moved
    for (const auto &[id, to] : now)
        if (const auto from = m_fingers.find(id); from != m_fingers.end())
            moved.emplace_back(from->second, to);
    if (moved.size() == 1)
        m_view.panBy(moved[0].second - moved[0].first);
    else if (moved.size() > 1)
        m_view.pinch(moved[0].first, moved[0].second, moved[1].first, moved[1].second);
}

} // namespace suffuse
