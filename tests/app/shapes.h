// Strokes that tests of tools work on, and the mouse as a hand moves it over them.
#pragma once

#include "model/shaping/nodes/reshape.h"
#include "tests/app/session.h"
#include "undo/edits.h"

namespace suffuse {

/// Four segments of 100 units through (x, y), (x + 100, y + 40), (x + 200, y) …, with level handles of a third; dry.
inline StrokePtr wave(StrokeId id, double x, double y)
{
    Stroke stroke;
    stroke.id = id;
    stroke.style = {StyleKind::Feathering, {0.4f, 1, 0}};
    const auto node = [=](int k) { return Point{x + 100 * k, y + (k % 2 ? 40 : 0)}; };
    for (int k = 0; k < 4; ++k) {
        const Point a = node(k), b = node(k + 1), third{100.0 / 3, 0};
        Segment segment;
        segment.bezier = {toOffset(a, {}), toOffset(a + third, {}), toOffset(b - third, {}), toOffset(b, {})};
        segment.colour = {0.9f, 0.1f, 0.7f, 1};
        segment.diffusion = 60;
        segment.density = 20;
        stroke.segments.push_back(segment);
    }
    return std::make_shared<const Stroke>(stroke);
}

/// A session with a wave from (200, 300), selected, all dry, 1 pixel a unit.
struct WaveSession : Session {
    StrokeId id = 0;

    WaveSession()
    {
        use(Command::Zoom100);
        id = addWave(200, 300, true);
    }
    StrokeId addWave(double x, double y, bool select)
    {
        const StrokeId added = editor().document().takeStrokeId();
        editor().push(addStrokes(editor().document(), {wave(added, x, y)}, select), "wave");
        editor().clock().setTime(painting().end());
        return added;
    }
    const Stroke &stroke() { return *painting().find(id); }
    const Stroke &stroke(StrokeId which) { return *painting().find(which); }
    int steps() { return editor().undoStack().count(); }

    /// Where the pointer is when it is sent to a place: whole logical pixels.
    Point sent(Point place)
    {
        const QPoint logical = at(place);
        const double dpr = canvas().devicePixelRatioF();
        return canvas().view().toCanvas({logical.x() * dpr, logical.y() * dpr});
    }
    void hover(Point to, Qt::KeyboardModifiers modifiers = {}) { report(to, Qt::NoButton, modifiers); }
    void move(Point to, Qt::KeyboardModifiers modifiers = {}) { report(to, Qt::LeftButton, modifiers); }
    void report(Point to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers)
    {
        const QPointF where = at(to);
        QMouseEvent event(QEvent::MouseMove, where, canvas().mapToGlobal(where), Qt::NoButton, buttons, modifiers);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    /// In five reports, with the same modifiers all the way; the button stays down unless `lift`.
    void drag(Point from, Point to, Qt::KeyboardModifiers modifiers = {}, bool lift = true)
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, at(from));
        for (int i = 1; i <= 5; ++i)
            move(from + (i / 5.0) * (to - from), modifiers);
        if (lift)
            QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, at(to));
    }
    QImage pictureNow()
    {
        dry();
        return canvas().picture();
    }
};

/// The largest difference of a channel, in levels.
inline int largestDifference(const QImage &a, const QImage &b)
{
    if (a.size() != b.size())
        return 256;
    int most = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            most = std::max(
                {most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return most;
}

} // namespace suffuse
