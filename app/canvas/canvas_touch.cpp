// The pen's coming and going, and fingers on the canvas: two move the view; one paints, or moves the view where only
// the pen paints.
#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"

#include <QTabletEvent>
#include <QTouchEvent>

namespace suffuse {

void CanvasWidget::setPenSettings(const PenSettings &settings)
{
    m_penSettings = settings;
    m_penPressure.setCurve(settings.pressure);
}

void CanvasWidget::turnPen(bool eraser)
{
    if (eraser == m_penTurned || m_pressed)
        return;
    m_penTurned = eraser;
    emit penTurned(eraser);
}

void CanvasWidget::lostPen()
{
    m_penDown = false;
    if (m_pressButton == Qt::NoButton)
        return;
    PointerEvent event;
    event.pixel = m_lastPixel;
    event.point = view().toCanvas(m_lastPixel);
    event.pressure = 0;
    event.time = m_editor.clock().time();
    event.button = m_pressButton;
    event.device = m_penTurned ? PointerDevice::Eraser : PointerDevice::Pen;
    pointerRelease(event);
}

bool CanvasWidget::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::TabletEnterProximity) {
        m_penNear = true;
        const auto *tablet = static_cast<QTabletEvent *>(event);
        if (isActiveWindow())
            turnPen(tablet->pointerType() == QPointingDevice::PointerType::Eraser);
    } else if (event->type() == QEvent::TabletLeaveProximity) {
        m_penNear = false;
        if (m_penDown)
            lostPen();
        if (m_tool)
            m_tool->leave();
    }
    return QWidget::eventFilter(watched, event);
}

PointerEvent CanvasWidget::fingerEvent(const QTouchEvent &event, Point pixel) const
{
    PointerEvent e;
    e.pixel = pixel;
    e.point = view().toCanvas(pixel);
    e.time = m_editor.clock().time();
    e.button = event.type() == QEvent::TouchUpdate ? Qt::NoButton : Qt::LeftButton;
    e.buttons = event.type() == QEvent::TouchEnd ? Qt::NoButton : Qt::LeftButton;
    e.modifiers = event.modifiers();
    return e;
}

void CanvasWidget::giveUpFinger()
{
    if (!m_fingerPaints)
        return;
    m_fingerPaints = m_pressed = false;
    m_pressButton = Qt::NoButton;
    if (m_tool)
        m_tool->cancel();
}

bool CanvasWidget::touch(const QTouchEvent &event)
{
    if (event.device()->type() == QInputDevice::DeviceType::TouchPad)
        return false; // it moves the mouse
    const bool otherAtWork = !m_fingerPaints && (m_pressed || m_navigation != Navigation::None);
    if (event.type() == QEvent::TouchCancel || m_penNear || m_penDown || otherAtWork) {
        giveUpFinger(); // it was the hand that holds the pen
        m_fingers.clear();
        return true;
    }
    std::map<int, Point> now;
    for (const QEventPoint &point : event.points()) {
        if (point.state() == QEventPoint::Released && event.points().size() > 1)
            continue;
        // One that stands still does not always say the truth about where.
        const auto last = m_fingers.find(point.id());
        const bool still = point.state() == QEventPoint::Stationary && last != m_fingers.end();
        now[point.id()] = still ? last->second : toPixels(point.position());
    }
    if (event.type() == QEvent::TouchBegin && now.size() == 1 && !m_penSettings.fingersMoveView) {
        m_fingerPaints = true;
        setFocus(Qt::MouseFocusReason);
        pointerPress(fingerEvent(event, now.begin()->second), Navigation::None);
    } else if (m_fingerPaints && now.size() > 1) {
        giveUpFinger();
    } else if (m_fingerPaints && event.type() == QEvent::TouchEnd) {
        m_fingerPaints = false;
        pointerRelease(fingerEvent(event, m_lastPixel));
    } else if (m_fingerPaints) {
        pointerMove(fingerEvent(event, now.begin()->second));
    } else {
        moveByFingers(now);
    }
    m_fingers = event.type() == QEvent::TouchEnd ? std::map<int, Point>() : now;
    return true;
}

void CanvasWidget::moveByFingers(const std::map<int, Point> &now)
{
    std::vector<std::pair<Point, Point>> moved; // from, to
    for (const auto &[id, to] : now)
        if (const auto from = m_fingers.find(id); from != m_fingers.end())
            moved.emplace_back(from->second, to);
    if (moved.empty())
        return;
    const auto &[from, to] = moved.front();
    if (moved.size() == 1) {
        m_transform.panBy(to - from);
    } else {
        const auto &[from2, to2] = moved[1];
        const Point centre = 0.5 * (to + to2), before = from2 - from, after = to2 - to;
        m_transform.panBy(centre - 0.5 * (from + from2));
        if (length(before) > 1 && length(after) > 1) {
            m_transform.zoomAt(centre, length(after) / length(before));
            m_transform.rotateAt(centre, std::atan2(cross(before, after), dot(before, after)));
        }
    }
    moveByHand();
}

} // namespace suffuse
