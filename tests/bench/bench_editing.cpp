// How fluid editing is: the real window, events as a hand sends them, and the time until the screen shows what they did.
#include "app/panels/bar_slider.h"
#include "app/panels/inspector_panel.h"
#include "app/panels/segment_section.h"
#include "app/settings.h"
#include "app/tools/node_tool.h"
#include "app/tools/pick.h"
#include "model/formats/files.h"
#include "model/influence.h"
#include "render/bench/generator.h"
#include "tests/bench/editing_session.h"
#include "undo/edits.h"
#include "undo/node_edits.h"
#include "undo/transform_edits.h"

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTextStream>

#include <malloc.h>
#include <numbers>

using namespace suffuse;

namespace {

constexpr double all = 1e9;

/// One line of the report, with the names and the values of its columns.
struct Row {
    QString name;
    std::vector<std::pair<QString, double>> values;
};

struct Report {
    QString title;
    std::vector<Row> rows;
};

Row rowOf(const QString &name, const Times &times)
{
    return {name, {{"median", times.at(0.5)}, {"p99", times.at(0.99)}, {"max", times.at(1)}}};
}

/// A point of the canvas widget that goes round from `start`, so that no two reports are the same.
Point around(Point start, int i, double radius)
{
    const double angle = 0.21 * i;
    return start + Point{radius * std::sin(angle), radius * (1 - std::cos(angle))};
}

/// The segment whose middle lies nearest to the middle of the canvas, of a stroke with some on either side.
SegmentRef middleSegment(const Painting &painting)
{
    SegmentRef best;
    double least = all;
    for (const StrokePtr &stroke : painting.strokes)
        for (int k = 2; k + 2 < int(stroke->segments.size()); ++k) {
            const Point middle = stroke->cubicOf(stroke->segments[std::size_t(k)]).at(0.5);
            if (const double d = length(middle - painting.canvas.area().centre()); d < least) {
                least = d;
                best = {stroke->id, k};
            }
        }
    return best;
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
    s.settle();
    const DragTimes times = s.paced(events, drag.move);
    Row row = rowOf(drag.name, times.toFrame);
    row.values.insert(row.values.end(), {{"frames/s", times.framesASecond},
                                         {"GUI ms", times.guiMs},
                                         {"all ms", times.allMs},
                                         {"skipped", double(times.skipped)}});
    s.settle();
    double evaluated = 0, influenced = 0;
    for (int i = events; i < events + 20; ++i) { // one by one, for the pixels
        const PaintingPtr before = s.document().painting();
        s.takeEvaluatedPixels();
        (void)s.untilShown([&] { drag.move(i); });
        evaluated += s.takeEvaluatedPixels();
        influenced += influencedPixels(*before, s.painting(), s.canvas().view(), s.editor().time());
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
    const auto at = [slider, start](int i) { return Point{*start + 15 * std::sin(0.21 * i + 0.5), 0.5 * slider->height()}; };
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
                if (const auto hit = pickTopmost(s.painting(), s.editor().time(), point, 3))
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

Report measureDrags(EditingSession &s, int events, const QString &wanted)
{
    const SegmentRef middle = middleSegment(s.painting());
    Report report{"Drags at 60 events a second: event to frame on the screen, ms", {}};
    const std::size_t count = s.painting().strokes.size();
    for (const Drag &drag :
         {dragOfNode(s, middle), dragOfSlider(s, middle), dragOfSelection(s, "drag one stroke", 1, middle),
          dragOfSelection(s, "drag 20 strokes", 20, middle),
          dragOfSelection(s, QStringLiteral("drag all %1 strokes").arg(count), count, middle)})
        if (drag.name.contains(wanted))
            report.rows.push_back(measureDrag(s, drag, events));
    return report;
}

Report measureViews(EditingSession &s, int events)
{
    Report report{"Moving the view at 60 events a second: event to frame on the screen, ms", {}};
    const auto pan = [&](const QString &name) {
        int moves = 0;
        const DragTimes times = s.paced(events, [&](int) { s.canvas().panBy({moves++ % 40 < 20 ? 2.0 : -2.0, 1.0}); });
        Row row = rowOf(name, times.toFrame);
        row.values.insert(row.values.end(), {{"frames/s", times.framesASecond},
                                             {"GUI ms", times.guiMs},
                                             {"all ms", times.allMs},
                                             {"skipped", double(times.skipped)}});
        report.rows.push_back(row);
        s.canvas().fit();
        s.settle();
    };
    s.document().setSelection({});
    pan("pan, nothing selected");
    s.window().action(Command::SelectAll).trigger();
    pan("pan, all selected");
    s.document().setSelection({});
    return report;
}

Report measureSelecting(EditingSession &s, int events)
{
    Report report{"Selecting: event to selection and overlay on the screen, ms", {}};
    s.window().action(Command::Select).trigger();
    const auto measure = [&](const QString &name, int times, const std::function<void(int)> &act) {
        Times result;
        for (int i = 0; i < times; ++i) {
            s.settle();
            result.ms.push_back(s.untilPainted([&] { act(i); }));
        }
        report.rows.push_back(rowOf(name, result));
    };
    const View view = s.canvas().view();
    const auto place = [&](int i) {
        const Rect area = s.painting().canvas.area();
        return view.toPixels({area.width() * (0.1 + 0.8 * std::fmod(0.618 * i, 1)),
                              area.height() * (0.1 + 0.8 * std::fmod(0.414 * i, 1))});
    };
    measure("click", events, [&](int i) {
        s.mouse(QEvent::MouseButtonPress, place(i));
        s.mouse(QEvent::MouseButtonRelease, place(i));
    });
    measure("Tab", events, [&](int) { s.key(Qt::Key_Tab); });
    Times bands;
    for (int i = 0; i < events / 3; ++i) { // the release selects
        const Point from{4, 4}, to{view.width * 0.5 + i, view.height * 0.5 + i};
        s.mouse(QEvent::MouseButtonPress, from);
        s.mouse(QEvent::MouseMove, to);
        s.settle();
        bands.ms.push_back(s.untilPainted([&] { s.mouse(QEvent::MouseButtonRelease, to); }));
    }
    report.rows.push_back(rowOf("band over a quarter", bands));
    measure("select all, select none", events / 3, [&](int i) {
        s.window().action(i % 2 == 0 ? Command::SelectAll : Command::Deselect).trigger();
    });
    s.document().setSelection({});
    return report;
}

std::set<StrokeId> firstStrokes(const Painting &painting, std::size_t count)
{
    std::set<StrokeId> strokes;
    for (const StrokePtr &stroke : painting.strokes)
        if (strokes.size() < count)
            strokes.insert(stroke->id);
    return strokes;
}

Edit restyle(const Document &document, float xi)
{
    return changeStrokes(document, document.selection().strokes,
                         [xi](Stroke &stroke) { stroke.style = {StyleKind::Uniform, {xi, 0.5f * xi, 0}}; });
}

Report measureUndo(EditingSession &s, int times)
{
    Report report{"Undo and redo: in the call, and to the frame on the screen, ms", {}};
    QUndoStack &stack = s.editor().undoStack();
    const auto measure = [&](const QString &name) {
        for (const bool undoes : {true, false}) {
            Times call, frame;
            for (int i = 0; i < times; ++i) {
                s.settle();
                frame.ms.push_back(s.untilShown([&] {
                    QElapsedTimer timer;
                    timer.start();
                    undoes ? stack.undo() : stack.redo();
                    call.ms.push_back(double(timer.nsecsElapsed()) * 1e-6);
                }));
                s.settle();
                undoes ? stack.redo() : stack.undo();
            }
            if (undoes)
                stack.undo();
            Row row{(undoes ? "undo " : "redo ") + name, {}};
            for (const auto &[what, t] : {std::pair("call ", &call), std::pair("frame ", &frame)})
                for (const auto &[column, value] : rowOf({}, *t).values)
                    row.values.push_back({what + column, value});
            report.rows.push_back(row);
        }
        s.settle();
    };
    const SegmentRef middle = middleSegment(s.painting());
    s.document().setSelection({{middle.stroke}, {}});
    s.editor().push(moveNodes(s.document(), {{middle.stroke, middle.segment}}, {7, 5}), "move");
    measure("of a moved node");
    s.document().setSelection({firstStrokes(s.painting(), 100), {}});
    s.editor().push(restyle(s.document(), 0.3f), "restyle");
    measure("of 100 strokes restyled");
    s.document().setSelection({});
    return report;
}

double allocated()
{
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks + info.hblkhd);
}

double bytesOf(const Stroke &stroke)
{
    return double(sizeof(Stroke) + stroke.segments.size() * sizeof(Segment));
}

/// Bytes that a step of the undo stack keeps; the window's own caches left out.
Report measureMemory(const Painting &painting, int steps)
{
    Report report{"Memory of a step of the undo stack, bytes", {}};
    const auto measure = [&](const QString &name, const std::set<StrokeId> &selected,
                             const std::function<Edit(Document &, int)> &edit) {
        Editor editor;
        Document &document = editor.document();
        document.reset(std::make_shared<const Painting>(painting));
        document.setSelection({selected, {}});
        const auto push = [&](int from, int to) {
            for (int i = from; i < to; ++i)
                editor.push(edit(document, i), "step");
        };
        push(0, 10);
        const double before = allocated();
        const int first = editor.undoStack().count();
        push(10, 10 + steps);
        const int made = editor.undoStack().count() - first;
        double changed = 0;
        for (const StrokeId id : selected)
            changed += bytesOf(*document.painting()->find(id));
        const double each = (allocated() - before) / made;
        report.rows.push_back({name, {{"bytes", each}, {"changed strokes", changed}, {"ratio", each / changed}}});
    };
    const auto longest = std::max_element(painting.strokes.begin(), painting.strokes.end(), [](auto &a, auto &b) {
        return a->segments.size() < b->segments.size();
    });
    const StrokeId id = (*longest)->id;
    const auto move = [](Document &document, int i) {
        return transformSelection(document, Affine::translation({i % 2 ? 1.5 : -1.25, 0.5}), SpreadRule::Scales);
    };
    const auto segmentEdit = [&](Document &document, int i) {
        return changeSegments(document, {{id, 1}}, [i](Segment &segment) { segment.density = float(1 + i % 7); });
    };
    measure(QStringLiteral("one segment of a stroke of %1").arg((*longest)->segments.size()), {id}, segmentEdit);
    measure("one stroke moved", {id}, move);
    measure("100 strokes moved", firstStrokes(painting, 100), move);
    measure("one stroke raised", {id}, [](Document &document, int i) {
        return arrangeSelection(document, i % 2 ? Arrange::Raise : Arrange::Lower);
    });
    measure("one stroke painted", {id}, [&](Document &document, int) {
        Stroke stroke = **longest;
        stroke.id = document.takeStrokeId();
        return addStrokes(document, {std::make_shared<const Stroke>(std::move(stroke))}, false);
    });
    return report;
}

void print(const Report &report)
{
    QTextStream out(stdout);
    if (report.rows.empty())
        return;
    out << "\n" << report.title << "\n" << QString().leftJustified(34);
    for (const auto &[column, value] : report.rows.front().values)
        out << ' ' << column.rightJustified(std::max(9, int(column.size())));
    out << '\n';
    for (const Row &row : report.rows) {
        out << row.name.leftJustified(34);
        for (const auto &[column, value] : row.values)
            out << ' ' << QString::number(value, 'f', std::abs(value) < 1e4 ? 2 : 0)
                              .rightJustified(std::max(9, int(column.size())));
        out << '\n';
    }
}

QJsonObject jsonOf(const Report &report)
{
    QJsonArray rows;
    for (const Row &row : report.rows) {
        QJsonObject values{{"name", row.name}};
        for (const auto &[column, value] : row.values)
            values[column] = value;
        rows << values;
    }
    return {{"title", report.title}, {"rows", rows}};
}

Result<Painting> paintingFrom(const QCommandLineParser &parser)
{
    if (parser.isSet("painting"))
        return loadPainting(parser.value("painting"));
    bench::PaintingOptions options;
    if (parser.isSet("strokes")) {
        options.strokes = std::max(parser.value("strokes").toInt(), 1);
        options.segments = 10 * options.strokes;
    }
    return bench::makePainting(options);
}

} // namespace

int main(int argc, char *argv[])
{
    QTemporaryDir folder; // settings of its own: two threads, no window that was left anywhere
    qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
    if (qEnvironmentVariableIsEmpty("SUFFUSE_BACKEND"))
        qputenv("SUFFUSE_BACKEND", "cpu");
    if (qEnvironmentVariableIsEmpty("SUFFUSE_PRESENTER"))
        qputenv("SUFFUSE_PRESENTER", "raster");
    Application application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"painting", "A document; without it one of the size of the paper's figure 11f.", "file"},
                       {"strokes", "A generated painting of so many strokes of ten segments.", "count"},
                       {"events", "Events of a drag (300).", "count", "300"},
                       {"only", "Parts, separated by commas: drags, views, selecting, undo, memory.", "parts"},
                       {"drag", "Only drags that have this in their names.", "text"},
                       {"json", "For programs."}});
    parser.process(application);
    const int events = std::max(parser.value("events").toInt(), 3);
    const Result<Painting> painting = paintingFrom(parser);
    if (!painting) {
        QTextStream(stderr) << painting.error() << '\n';
        return 1;
    }
    const QStringList only = parser.value("only").split(',', Qt::SkipEmptyParts);
    settings::setThreads(2);
    EditingSession session(application, std::make_shared<const Painting>(*painting));
    const std::pair<const char *, std::function<Report()>> parts[] = {
        {"drags", [&] { return measureDrags(session, events, parser.value("drag")); }},
        {"views", [&] { return measureViews(session, events); }},
        {"selecting", [&] { return measureSelecting(session, events); }},
        {"undo", [&] { return measureUndo(session, std::max(events / 6, 3)); }},
        {"memory", [&] { return measureMemory(*painting, 3 * events); }}};
    QJsonArray json;
    for (const auto &[name, measure] : parts) {
        if (!only.isEmpty() && !only.contains(QLatin1String(name)))
            continue;
        const Report report = measure();
        if (parser.isSet("json"))
            json << jsonOf(report);
        else
            print(report);
    }
    if (parser.isSet("json"))
        QTextStream(stdout) << QJsonDocument(json).toJson();
    return 0;
}
