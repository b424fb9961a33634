// A window with the Select tool in hand, and the mouse with modifier keys.
#pragma once

#include "app/tools/select/select_tool.h"
#include "model/paint/half_width.h"
#include "tests/app/session.h"

namespace suffuse {

inline constexpr Qt::KeyboardModifiers none = Qt::NoModifier, shift = Qt::ShiftModifier, ctrl = Qt::ControlModifier,
                                       alt = Qt::AltModifier;

inline StrokePtr line(StrokeId id, Point from, Point to, int segments = 4)
{
    Stroke stroke;
    stroke.id = id;
    stroke.origin = from;
    stroke.style = {StyleKind::Uniform, {0.4f, 0.1f, 0}};
    for (int k = 0; k < segments; ++k) {
        Segment segment;
        segment.diffusion = 25;
        segment.density = 20;
        for (int i = 0; i < 4; ++i)
            segment.bezier[std::size_t(i)] = toOffset((k + i / 3.0) / segments * (to - from), {0, 0});
        stroke.segments.push_back(segment);
    }
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// A window with strokes in it and the Select tool in hand.
struct Selecting : Session {
    explicit Selecting(StrokeList strokes, MakeRenderer make = makeRenderer) : Session(std::move(make))
    {
        auto painting = std::make_shared<Painting>();
        painting->strokes = std::move(strokes);
        editor().document().reset(painting);
        editor().clock().setTime(this->painting().end());
        use(Command::Select);
    }
    SelectTool &tool() { return *static_cast<SelectTool *>(canvas().tool()); }
    const Stroke &stroke(StrokeId id) { return *painting().find(id); }
    int steps() { return editor().undoStack().count(); }
    void select(std::set<StrokeId> strokes) { editor().document().setSelection({std::move(strokes), {}}); }
    std::set<StrokeId> selected() { return selection().strokes; }

    void send(QEvent::Type type, QPointF at, Qt::KeyboardModifiers modifiers)
    {
        const bool move = type == QEvent::MouseMove;
        QMouseEvent event(type, at, canvas().mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    QPointF logical(Point pixel)
    {
        const double dpr = canvas().devicePixelRatioF();
        return {pixel.x / dpr, pixel.y / dpr};
    }
    void pressAndMove(const std::vector<Point> &path, Qt::KeyboardModifiers modifiers)
    {
        const View view = canvas().view();
        send(QEvent::MouseButtonPress, logical(view.toPixels(path.front())), modifiers);
        for (std::size_t i = 1; i < path.size(); ++i)
            for (int k = 1; k <= 5; ++k)
                send(QEvent::MouseMove, logical(view.toPixels(path[i - 1] + (k / 5.0) * (path[i] - path[i - 1]))),
                     modifiers);
    }
    void drag(const std::vector<Point> &path, Qt::KeyboardModifiers modifiers = {})
    {
        const View view = canvas().view();
        pressAndMove(path, modifiers);
        send(QEvent::MouseButtonRelease, logical(view.toPixels(path.back())), modifiers);
    }
    /// From the middle of a handle by canvas units.
    void dragHandle(TransformHandle handle, Point by, Qt::KeyboardModifiers modifiers = {})
    {
        const View view = canvas().view();
        const Point from = view.toCanvas(tool().handles().place(handle, view, canvas().devicePixelRatioF()));
        drag({from, from + by}, modifiers);
    }
    Rect box(StrokeId id) { return curveBox(stroke(id)); }
    /// Of the paint that is seen.
    Rect seen(StrokeId id) { return seenBox(stroke(id)); }
};

inline bool near(double a, double b, double tolerance = 1e-3)
{
    return std::abs(a - b) <= tolerance;
}

using Kind = TransformHandle::Kind;

} // namespace suffuse
