// A window as a test drives it, and a pen without a pen.
#pragma once

#include "app/canvas/canvas_widget.h"
#include "app/window/main_window.h"

#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>

namespace suffuse {

inline constexpr int waitMs = 30'000;
inline constexpr Microseconds interval = 16'000;

/// A window whose clock moves only when the test says so.
struct Session {
    MainWindow window;

    explicit Session(MakeRenderer make = makeRenderer) : window(nullptr, std::move(make))
    {
        window.resize(1100, 760);
        window.show();
        window.editor().clock().setManual(true);
        if (window.editor().brush() == firstBrush()) // tests count on a round, blunt stroke that no speed changes
            window.editor().setBrush(builtinBrushes().front());
    }
    Editor &editor() { return window.editor(); }
    CanvasWidget &canvas() { return window.canvas(); }
    const Painting &painting() { return *editor().document().painting(); }
    const Selection &selection() { return editor().document().selection(); }

    QPoint at(Point canvasPoint)
    {
        const Point p = canvas().view().toPixels(canvasPoint);
        const double dpr = canvas().devicePixelRatioF();
        return QPoint(qRound(p.x / dpr), qRound(p.y / dpr));
    }
    void advance(Microseconds by) { editor().clock().setTime(editor().clock().time() + by); }

    /// Drags the mouse along a straight line in twenty reports.
    void paintLine(Point from, Point to)
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, {}, at(from));
        for (int i = 1; i <= 20; ++i) {
            advance(interval);
            QTest::mouseMove(&canvas(), at(from + (i / 20.0) * (to - from)));
        }
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at(to));
    }
    void click(Point where, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&canvas(), Qt::LeftButton, modifiers, at(where));
    }
    void dry()
    {
        editor().clock().setTime(painting().end());
        QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs);
    }
    void use(Command command) { window.action(command).trigger(); }
};

class Pen {
public:
    Pen()
        : m_device("test pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                   QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1)
    {}
    void send(QWidget &widget, QEvent::Type type, QPointF at, double pressure)
    {
        const bool down = type != QEvent::TabletRelease;
        QTabletEvent event(type, &m_device, at, widget.mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {},
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           down ? Qt::LeftButton : Qt::NoButton);
        QCoreApplication::sendEvent(&widget, &event);
    }

private:
    QPointingDevice m_device;
};

} // namespace suffuse
