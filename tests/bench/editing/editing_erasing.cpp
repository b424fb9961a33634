// The eraser on one large wash.
#include "app/tools/shaping/eraser_tool.h"
#include "model/brush/stroke_builder.h"
#include "render/backends.h"
#include "tests/bench/editing/editing_benches.h"
#include "undo/edits.h"

#include <chrono>
#include <cmath>

namespace suffuse {

namespace {

constexpr int washRows = 30, washColumns = 20;

/// 600 segments to and fro over all of the canvas.
std::vector<PenSample> rowsOver(const Rect &area)
{
    std::vector<PenSample> samples;
    const auto at = [&](double x, double y) {
        return Point{area.left + x * area.width(), area.top + y * area.height()};
    };
    for (int row = 0; row < washRows; ++row)
        for (int k = 0; k < washColumns; ++k) {
            const double x = 0.06 + 0.88 * k / (washColumns - 1), y = 0.06 + 0.88 * row / (washRows - 1);
            samples.push_back({at(row % 2 ? 1 - x : x, y), Microseconds(samples.size()) * samplingInterval});
        }
    return samples;
}

Stroke washOver(const Rect &area, StrokeId id)
{
    Brush brush = builtinBrushes().front();
    brush.dynamics.clear();
    brush.taper = {};
    brush.jitter = {};
    brush.maxAge = 1;
    brush.setSpread(0.05 * area.height());
    Stroke wash = *buildStroke(brush, id, rowsOver(area));
    wash.segments.resize(std::min<std::size_t>(wash.segments.size(), washRows * washColumns));
    return wash;
}

/// The wash with so many lifting segments in it, in paths from top to bottom.
Stroke lifted(const Stroke &wash, const Rect &area, std::size_t count)
{
    Stroke result = wash;
    const Microseconds dry = wash.driesAt();
    for (int path = 0; result.segments.size() < wash.segments.size() + count; ++path) {
        SoftEraser eraser({0.02 * area.height(), 0.6, 1}, {std::make_shared<const Stroke>(result)}, dry);
        const double x = area.left + area.width() * (0.12 + 0.06 * path);
        for (int k = 0; k <= 40; ++k)
            eraser.add({{x, area.top + area.height() * (0.1 + 0.02 * k)}, dry + k * samplingInterval * 2});
        eraser.finish();
        result = eraser.erased(result);
    }
    result.segments.resize(wash.segments.size() + count);
    return result;
}

/// Milliseconds that a full frame of a stroke takes, with and without what takes paint away.
Times framesOf(EditingSession &s, const Stroke &stroke, int times)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas = s.painting().canvas;
    painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
    RenderRequest request;
    request.painting = painting;
    request.time = painting->end();
    request.view = s.canvas().view();
    Times result;
    for (int i = 0; i < times; ++i) {
        RendererOptions options;
        options.backend = Backend::Cpu;
        options.threads = 2;
        auto renderer = makeRenderer(options);
        Picture8 picture;
        const auto since = std::chrono::steady_clock::now();
        if (!renderer || !(*renderer)->render(request, picture))
            break;
        result.ms.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - since).count());
    }
    return result;
}

} // namespace

Report measureErasing(EditingSession &s, int events, const QString &wanted)
{
    Report report{"The eraser on a wash of 600 segments, at 60 events a second: event to the screen, ms", {}};
    const Painting before = s.painting();
    const Rect area = before.canvas.area();
    s.editor().newPainting(before.canvas);
    s.window().action(Command::Fit).trigger();
    auto &eraser = *s.window().findChild<EraserTool *>();
    eraser.setRadius(0.02 * area.height());
    const Stroke wash = washOver(area, 1), erased = lifted(wash, area, 200);
    for (const auto &[name, mode, stroke] :
         {std::tuple{"lift, none yet", EraserMode::Lift, &wash}, {"lift, 200 lifting ones", EraserMode::Lift, &erased},
          {"cut", EraserMode::Cut, &wash}}) {
        if (!QString(name).contains(wanted))
            continue;
        s.editor().newPainting(before.canvas);
        s.editor().push(addStrokes(s.document(), {std::make_shared<const Stroke>(*stroke)}, false), "wash");
        s.editor().clock().setTime(s.painting().end());
        s.settle();
        s.window().action(Command::Eraser).trigger();
        EraserChoice choice;
        choice.mode = mode;
        eraser.setChoice(choice);
        const View view = s.canvas().view();
        const auto at = [&](int i) {
            const double x = double(i + 1) / (events + 2);
            return Point{view.width * (0.2 + 0.6 * x), view.height * (0.5 + 0.3 * std::sin(9 * x))};
        };
        s.mouse(QEvent::MouseButtonPress, at(-1));
        s.holdStill();
        report.rows.push_back(rowOf(name, s.paced(events, [&](int i) { s.mouse(QEvent::MouseMove, at(i)); })));
        s.mouse(QEvent::MouseButtonRelease, at(events));
        s.settle();
    }
    if (QString("frames").contains(wanted)) {
        const int times = std::clamp(events / 10, 3, 20);
        for (const auto &[name, stroke] :
             {std::pair{"a whole frame, without lifting ones", &wash}, {"a whole frame, with 200", &erased}}) {
            Row row = rowOf(name, framesOf(s, *stroke, times));
            if (!report.rows.empty())
                row.values.resize(report.rows.front().values.size(), {"", 0});
            report.rows.push_back(row);
        }
    }
    eraser.setChoice({});
    s.editor().openRecovered(before, "bench", {}); // what the other parts measure
    s.settle();
    return report;
}

} // namespace suffuse
