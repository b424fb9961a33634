// Drags of a node, a slider and selections.
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/selecting/pick.h"
#include "app/tools/nodes/node_tool.h"
#include "app/tools/select/select_tool.h"
#include "app/widgets/numbers/bar_slider.h"
#include "model/painting/influence.h"
#include "tests/bench/editing/editing_benches.h"
#include "undo/node_edits.h"

#include <cmath>

namespace suffuse {

namespace {

/// A point of the canvas widget that goes round from `start`, so that no two reports are the same.
Point around(Point start, int i, double radius)
{
    const double angle = 0.21 * i;
    return start + Point{radius * std::sin(angle), radius * (1 - std::cos(angle))};
}

/// Pixels that the influence of what differs covers, before and after.
double influencedPixels(const Painting &before, const Painting &after, const View &view, Microseconds time)
{
    std::vector<char> covered(std::size_t(view.width) * std::size_t(view.height));
    const auto cover = [&](const Stroke &stroke, const Segment &segment) {
        const Rect box = influenceOf(stroke, segment, time);
        if (box.isEmpty())
            return;
        const Point a = view.toPixels({box.left, box.top}), b = view.toPixels({box.right, box.bottom});
        const int left = std::max(0, int(std::floor(a.x))), right = std::min(view.width, int(std::ceil(b.x)));
        const int top = std::max(0, int(std::floor(a.y))), bottom = std::min(view.height, int(std::ceil(b.y)));
        for (int y = top; y < bottom && left < right; ++y)
            std::fill_n(covered.begin() + std::ptrdiff_t(y) * view.width + left, right - left, 1);
    };
    before.strokes.forEachDifference(after.strokes, [&](std::size_t i) {
        const Stroke &a = *before.strokes[i], &b = *after.strokes[i];
        const bool alike = a.segments.size() == b.segments.size() && a.origin == b.origin;
        for (std::size_t k = 0; k < std::max(a.segments.size(), b.segments.size()); ++k) {
            if (alike && a.segments[k] == b.segments[k])
                continue;
            if (k < a.segments.size())
                cover(a, a.segments[k]);
            if (k < b.segments.size())
                cover(b, b.segments[k]);
        }
    });
    return double(std::count(covered.begin(), covered.end(), 1));
}

/// A drag of one kind: press, reports, release.
struct Drag {
    QString name;
    std::function<void()> press;
    std::function<void(int)> move;
    std::function<void()> release;
};

Row measureDrag(EditingSession &s, const Drag &drag, int events)
{
    drag.press();
    s.rest();
    const DragTimes times = s.paced(events, drag.move);
    Row row = rowOf(drag.name, times);
    s.settle();
    double evaluated = 0, influenced = 0;
    for (int i = events; i < events + std::min(events, 20); ++i) { // one by one, for the pixels
        const PaintingPtr before = s.document().painting();
        s.takeEvaluatedPixels();
        (void)s.untilShown([&] { drag.move(i); });
        if (s.editor().unsettled().painting() == before)
            s.settle(); // it floats
        evaluated += s.takeEvaluatedPixels();
        influenced += influencedPixels(*before, s.painting(), s.canvas().view(), s.editor().clock().time());
    }
    row.values.push_back({"evaluated/influence", evaluated / std::max(influenced, 1.0)});
    drag.release();
    s.settle();
    s.editor().undoStack().undo();
    s.settle();
    return row;
}

Drag dragOfNode(EditingSession &s, const SegmentRef &middle)
{
    const auto at = [&s, middle] {
        const StrokePtr stroke = s.painting().find(middle.stroke);
        return s.canvas().view().toPixels(nodePosition(*stroke, middle.segment));
    };
    const auto start = std::make_shared<Point>();
    return {"drag a node",
            [&s, middle, at, start] {
                s.window().action(Command::Segments).trigger();
                s.document().setSelection({{middle.stroke}, {}});
                static_cast<NodeTool *>(s.canvas().tool())->selectNodes({{middle.stroke, middle.segment}});
                *start = at();
                s.mouse(QEvent::MouseButtonPress, *start);
            },
            [&s, start](int i) { s.mouse(QEvent::MouseMove, around(*start, i + 4, 14)); },
            [&s, start] { s.mouse(QEvent::MouseButtonRelease, around(*start, 3, 14)); }};
}

Drag dragOfSlider(EditingSession &s, const SegmentRef &middle)
{
    BarSlider *slider = s.window().findChild<InspectorPanel *>()->segmentSection()->diffusion()->slider();
    const auto start = std::make_shared<double>();
    // No two reports give the same value, where it turns neither: an event without a change would measure nothing.
    const auto at = [slider, start](int i) {
        return Point{*start + 15 * std::sin(0.21 * i + 0.5) + 0.4 * (i % 2), 0.5 * slider->height()};
    };
    return {"drag the slider of D, one segment",
            [&s, middle, slider, start, at] {
                s.window().action(Command::Segments).trigger();
                s.document().setSelection({{middle.stroke}, {middle}});
                s.settle();
                *start = 8 + double(slider->value()) / BarSlider::steps * (slider->width() - 16);
                s.mouse(*slider, QEvent::MouseButtonPress, at(0));
            },
            [&s, slider, at](int i) { s.mouse(*slider, QEvent::MouseMove, at(i + 1)); },
            [&s, slider, at] { s.mouse(*slider, QEvent::MouseButtonRelease, at(0)); }};
}

Drag dragOfSelection(EditingSession &s, const QString &name, std::size_t count, const SegmentRef &middle)
{
    const auto start = std::make_shared<Point>();
    return {name,
            [&s, count, middle, start] {
                s.window().action(Command::Select).trigger();
                const StrokePtr grabbed = s.painting().find(middle.stroke);
                const Point point = grabbed->cubicOf(grabbed->segments[std::size_t(middle.segment)]).at(0.5);
                Selection selection;
                if (const auto hit = pickTopmost(s.painting(), s.editor().clock().time(), point, 3))
                    selection.strokes.insert(hit->stroke);
                for (const StrokePtr &stroke : s.painting().strokes)
                    if (selection.strokes.size() < count)
                        selection.strokes.insert(stroke->id);
                s.document().setSelection(std::move(selection));
                *start = s.canvas().view().toPixels(point);
                s.mouse(QEvent::MouseButtonPress, *start);
            },
            [&s, start](int i) { s.mouse(QEvent::MouseMove, around(*start, i + 4, 30)); },
            [&s, start] { s.mouse(QEvent::MouseButtonRelease, around(*start, 3, 30)); }};
}

Drag dragOfHandle(EditingSession &s, const QString &name)
{
    const auto start = std::make_shared<Point>();
    return {name,
            [&s, start] {
                s.window().action(Command::Select).trigger();
                s.window().action(Command::SelectAll).trigger();
                const auto *tool = static_cast<SelectTool *>(s.canvas().tool());
                *start = tool->handles().place({TransformHandle::Kind::Scale, 1, 1}, s.canvas().view(), 1);
                s.mouse(QEvent::MouseButtonPress, *start);
            },
            [&s, start](int i) { s.mouse(QEvent::MouseMove, around(*start, i + 4, 30)); },
            [&s, start] { s.mouse(QEvent::MouseButtonRelease, around(*start, 3, 30)); }};
}

} // namespace

Report measureDrags(EditingSession &s, int events, const QString &wanted)
{
    const SegmentRef middle = middleSegment(s.painting());
    Report report{"Drags at 60 events a second: event to frame on the screen, ms", {}};
    const std::size_t count = s.painting().strokes.size();
    for (const Drag &drag :
         {dragOfNode(s, middle), dragOfSlider(s, middle), dragOfSelection(s, "drag one stroke", 1, middle),
          dragOfSelection(s, "drag 20 strokes", 20, middle),
          dragOfSelection(s, QStringLiteral("drag all %1 strokes").arg(count), count, middle),
          dragOfHandle(s, QStringLiteral("scale all %1 strokes").arg(count))})
        if (drag.name.contains(wanted))
            report.rows.push_back(measureDrag(s, drag, events));
    return report;
}

} // namespace suffuse
