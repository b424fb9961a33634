// Tools that look at every stroke.
#include "app/tools/nodes/node_tool.h"
#include "app/tools/shaping/eraser_tool.h"
#include "app/tools/shaping/push_tool.h"
#include "model/shaping/curves/split.h"
#include "tests/bench/editing/editing_benches.h"
#include "undo/node_edits.h"

#include <cmath>

namespace suffuse {

namespace {

/// A drag of the left button with the tool in use, along a wave from left to right.
DragTimes wave(EditingSession &s, int events)
{
    const View view = s.canvas().view();
    const auto at = [&](int i) {
        const double x = double(i + 1) / (events + 2);
        return Point{view.width * (0.2 + 0.6 * x), view.height * (0.5 + 0.3 * std::sin(9 * x))};
    };
    s.mouse(QEvent::MouseButtonPress, at(-1));
    s.holdStill();
    const DragTimes times = s.paced(events, [&](int i) { s.mouse(QEvent::MouseMove, at(i)); });
    return times;
}

Row nodeAmongAllSelected(EditingSession &s, const QString &name, int events)
{
    const SegmentRef middle = middleSegment(s.painting());
    s.window().action(Command::SelectAll).trigger();
    s.window().action(Command::Segments).trigger();
    static_cast<NodeTool *>(s.canvas().tool())->selectNodes({{middle.stroke, middle.segment}});
    const StrokePtr stroke = s.painting().find(middle.stroke);
    const Point start = s.canvas().view().toPixels(nodePosition(*stroke, middle.segment));
    s.mouse(QEvent::MouseButtonPress, start);
    s.rest();
    const auto at = [&](int i) { return start + Point{14 * std::sin(0.21 * i), 14 * std::cos(0.21 * i)}; };
    const Row row = rowOf(name, s.paced(events, [&](int i) { s.mouse(QEvent::MouseMove, at(i)); }));
    s.mouse(QEvent::MouseButtonRelease, at(events));
    return row;
}

/// A wash of 10,000 segments, back and forth over the middle of the canvas.
StrokePtr washOfManySegments(const Painting &painting, StrokeId id)
{
    constexpr int rows = 50, inRow = 200;
    const Point middle{0.5 * painting.canvas.width, 0.5 * painting.canvas.height};
    const double width = 0.8 * painting.canvas.width, height = 0.8 * painting.canvas.height;
    auto stroke = std::make_shared<Stroke>();
    stroke->id = id;
    stroke->origin = middle;
    const auto at = [&](int k) {
        const int row = k / inRow, step = k % inRow;
        const double x = double(row % 2 ? inRow - step : step) / inRow;
        return Point{width * (x - 0.5), height * ((row + double(step) / inRow) / rows - 0.5)};
    };
    for (int k = 0; k < rows * inRow; ++k) {
        const Point a = at(k), b = at(k + 1);
        Segment s;
        s.bezier = toOffsets({{a, a + (1.0 / 3) * (b - a), b - (1.0 / 3) * (b - a), b}});
        if (k > 0)
            s.bezier[0] = stroke->segments.back().bezier[3];
        s.diffusion = float(height * height / 3e4);
        s.density = float(height / 60);
        s.born = k * 1000;
        stroke->segments.push_back(s);
    }
    return stroke;
}

/// Pushes one stroke of very many segments.
Row pushOfMany(EditingSession &s, const QString &name, int events)
{
    s.editor().push(addStrokes(s.document(), {washOfManySegments(s.painting(), s.document().takeStrokeId())}, true),
                    "wash");
    s.editor().clock().setTime(s.painting().end());
    s.settle();
    s.window().action(Command::Push).trigger();
    auto &push = *static_cast<PushTool *>(s.canvas().tool());
    push.setRadius(60 / s.canvas().view().scale);
    const Row row = rowOf(name, wave(s, events));
    s.mouse(QEvent::MouseButtonRelease, {s.canvas().view().width * 0.8, s.canvas().view().height * 0.5});
    return row;
}

} // namespace

Report measureTools(EditingSession &s, int events, const QString &wanted)
{
    Report report{"Tools among all strokes, at 60 events a second: event to the screen, ms", {}};
    const Point corner{s.canvas().view().width * 0.8, s.canvas().view().height * 0.5};
    const auto undoAll = [&s] {
        while (s.editor().undoStack().canUndo())
            s.editor().undoStack().undo();
        s.document().setSelection({});
        s.settle();
    };
    s.document().setSelection({});
    struct Sweep {
        QString name;
        Command tool;
        Command before; ///< what is selected
        EraserMode mode = EraserMode::Lift;
    };
    for (const auto &[name, tool, before, mode] :
         {Sweep{"knife", Command::Knife, Command::Deselect}, Sweep{"push", Command::Push, Command::Deselect},
          Sweep{"eraser, lifting", Command::Eraser, Command::Deselect},
          Sweep{"eraser, lifting, all strokes selected", Command::Eraser, Command::SelectAll},
          Sweep{"eraser, cutting", Command::Eraser, Command::Deselect, EraserMode::Cut},
          Sweep{"eraser, cutting, all strokes selected", Command::Eraser, Command::SelectAll, EraserMode::Cut}}) {
        if (!name.contains(wanted))
            continue;
        s.window().action(before).trigger();
        s.window().action(tool).trigger();
        if (auto *eraser = qobject_cast<EraserTool *>(s.canvas().tool())) {
            EraserChoice choice = eraser->choice();
            choice.mode = mode;
            eraser->setChoice(choice);
        }
        report.rows.push_back(rowOf(name, wave(s, events)));
        s.mouse(QEvent::MouseButtonRelease, corner);
        undoAll();
    }
    if (const QString name = "a node, all strokes selected"; name.contains(wanted)) {
        report.rows.push_back(nodeAmongAllSelected(s, name, events));
        undoAll();
    }
    if (const QString name = "push on 10,000 segments"; name.contains(wanted)) {
        report.rows.push_back(pushOfMany(s, name, events));
        undoAll();
    }
    return report;
}

} // namespace suffuse
