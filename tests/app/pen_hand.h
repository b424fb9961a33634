// A pen that draws by itself, at the pace of a device.
#pragma once

#include "model/geometry/geometry.h"

#include <QCoreApplication>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWidget>

namespace suffuse {

/// One report of a pen: where in the widget, and how it is held.
struct PenReport {
    QEvent::Type type = QEvent::TabletMove;
    Point at; ///< logical pixels of the widget
    double pressure = 0;
    double xTilt = 0, yTilt = 0; ///< degrees
    quint64 stamp = 0;           ///< milliseconds, the device's clock
};

/// A pen with pressure and tilt that no driver knows of.
class PenHand {
public:
    PenHand()
        : m_device("hand", 71, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                   QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                       QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt,
                   1, 1)
    {}

    void send(QWidget &widget, const PenReport &report)
    {
        const QPointF at(report.at.x, report.at.y);
        const bool moves = report.type == QEvent::TabletMove, down = report.type != QEvent::TabletRelease;
        QTabletEvent event(report.type, &m_device, at, widget.mapToGlobal(at), report.pressure, float(report.xTilt),
                           float(report.yTilt), 0, 0, 0, {}, moves ? Qt::NoButton : Qt::LeftButton,
                           down ? Qt::LeftButton : Qt::NoButton);
        event.setTimestamp(report.stamp);
        QCoreApplication::sendEvent(&widget, &event);
    }

private:
    QPointingDevice m_device;
};

} // namespace suffuse
