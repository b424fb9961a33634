// A pen whose every event a test chooses.
#pragma once

#include "session.h"

#include <QCoreApplication>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWidget>

#include <vector>

namespace suffuse {

/// A pen that says what a test wants it to.
class SyntheticPen {
public:
    explicit SyntheticPen(QPointingDevice::PointerType end = QPointingDevice::PointerType::Pen, bool sensitive = true)
        : m_device("pen", 70 + int(end), QInputDevice::DeviceType::Stylus, end,
                   sensitive ? QInputDevice::Capability::Position | QInputDevice::Capability::Pressure
                             : QInputDevice::Capabilities(QInputDevice::Capability::Position),
                   1, 3)
    {}
    void press(QWidget &widget, QPointF at, double pressure)
    {
        send(widget, QEvent::TabletPress, at, pressure, Qt::LeftButton, Qt::LeftButton);
    }
    void move(QWidget &widget, QPointF at, double pressure)
    {
        send(widget, QEvent::TabletMove, at, pressure, Qt::NoButton, Qt::LeftButton);
    }
    void hover(QWidget &widget, QPointF at) { send(widget, QEvent::TabletMove, at, 0, Qt::NoButton, Qt::NoButton); }
    void release(QWidget &widget, QPointF at)
    {
        send(widget, QEvent::TabletRelease, at, 0, Qt::LeftButton, Qt::NoButton);
    }
    void proximity(bool near)
    {
        QTabletEvent event(near ? QEvent::TabletEnterProximity : QEvent::TabletLeaveProximity, &m_device, {}, {}, 0, 0,
                           0, 0, 0, 0, {}, Qt::NoButton, Qt::NoButton);
        QCoreApplication::sendEvent(qApp, &event);
    }
    /// A straight line at these pressures, a report an interval.
    void line(Session &s, double y, const std::vector<double> &pressures, bool lift = true)
    {
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            const QPointF at = s.at({200 + 20.0 * double(i), y});
            if (i == 0)
                press(s.canvas(), at, pressures[i]);
            else
                move(s.canvas(), at, pressures[i]);
            s.advance(interval);
        }
        if (lift)
            release(s.canvas(), s.at({200 + 20.0 * double(pressures.size() - 1), y}));
    }

private:
    void send(QWidget &widget, QEvent::Type type, QPointF at, double pressure, Qt::MouseButton button,
              Qt::MouseButtons buttons)
    {
        QTabletEvent event(type, &m_device, at, widget.mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {}, button, buttons);
        QCoreApplication::sendEvent(&widget, &event);
    }

    QPointingDevice m_device;
};

/// The greatest density of its segments.
inline float strongest(const Stroke &stroke)
{
    float most = 0;
    for (const Segment &s : stroke.segments)
        most = std::max(most, s.density);
    return most;
}

} // namespace suffuse
