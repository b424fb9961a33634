// How painting and time feel: the real window with a painting in it, a pen at its own pace, and the screen.
//   bench_time [--painting FILE] [--only pen,spreading,scrubbing,film] [--json]
// Prints a line a figure.
#include "app/panels/timeline/timeline_panel.h"
#include "app/panels/timeline/timeline_view.h"
#include "model/brush/brush.h"
#include "model/document/timelapse.h"
#include "render/backends.h"
#include "render/film/film_writer.h"
#include "render/sequence.h"
#include "tests/app/pen_hand.h"
#include "tests/bench/bench_start.h"
#include "tests/bench/editing/editing_report.h"
#include "undo/edits.h"

#include <QDockWidget>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTextStream>
#include <QTimer>

#include <cmath>
#include <ctime>
#include <deque>
#include <thread>

using namespace suffuse;

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Knows when a frame that was drawn for a moment stands on the screen.
class Screen {
public:
    using Seen = std::function<void(const FrameInfo &)>;

    Screen(Application &application, CanvasWidget &canvas, Seen seen)
        : m_application(application), m_before(application.painted), m_seen(std::move(seen))
    {
        m_connection = QObject::connect(&canvas, &CanvasWidget::framePresented, [this](const FrameInfo &frame) {
            m_frame = frame;
            m_new = !frame.stats.dirty.empty();
            if (!m_new) // the picture stays
                m_seen(m_frame);
        });
        m_application.painted = [this] {
            m_before();
            if (std::exchange(m_new, false))
                m_seen(m_frame);
        };
    }
    ~Screen()
    {
        m_application.painted = m_before;
        QObject::disconnect(m_connection);
    }

private:
    Application &m_application;
    std::function<void()> m_before;
    Seen m_seen;
    QMetaObject::Connection m_connection;
    FrameInfo m_frame;
    bool m_new = false;
};

/// Lets the event loop run until `done`, or for as long as `patience`.
template <typename Done>
void runUntil(Done done, std::chrono::milliseconds patience)
{
    QTimer awake;
    awake.start(1);
    for (const Clock::time_point start = Clock::now(); !done() && Clock::now() - start < patience;)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

// --- The pen
// -----------------------------------------------------------------------------------------------------------

/// A wave across the canvas, the pressure swelling, at 125 reports a second.
std::vector<PenReport> strokeOf(int number, int reports, QSize size)
{
    std::vector<PenReport> stroke;
    const double width = size.width(), height = size.height();
    for (int i = 0; i < reports; ++i) {
        const double way = double(i) / reports;
        PenReport report;
        report.type = i == 0 ? QEvent::TabletPress : i + 1 < reports ? QEvent::TabletMove : QEvent::TabletRelease;
        report.at = {width * (0.25 + 0.5 * way),
                     height * (0.2 + 0.6 * std::fmod(0.37 * number, 1.0) + 0.06 * std::sin(12 * way + number))};
        report.pressure = report.type == QEvent::TabletRelease ? 0 : 0.2 + 0.6 * std::sin(3 * way);
        stroke.push_back(report);
    }
    return stroke;
}

/// From a report of the pen to the first frame that shows its segment at an age above 0.
Times penTimes(Application &application, EditingSession &s, int strokes, int reports)
{
    struct Waiting {
        Clock::time_point at;
        Microseconds born;
        quint64 serial;
    };
    std::deque<Waiting> waiting;
    Times times;
    const Screen screen(application, s.canvas(), [&](const FrameInfo &frame) {
        std::erase_if(waiting, [&](const Waiting &w) {
            if (frame.serial < w.serial || frame.time <= w.born)
                return false;
            times.ms.push_back(since(w.at));
            return true;
        });
    });
    PenHand pen;
    constexpr std::chrono::milliseconds pace(8);
    for (int k = 0; k < strokes; ++k) {
        const std::vector<PenReport> stroke = strokeOf(k, reports, s.canvas().size());
        std::atomic<int> taken = 0;
        const Clock::time_point start = Clock::now() + pace;
        std::thread hand([&] {
            for (const PenReport &report : stroke) {
                const Clock::time_point at = start + pace * (&report - stroke.data());
                std::this_thread::sleep_until(at);
                PenReport stamped = report;
                stamped.stamp =
                    quint64(std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count());
                const Clock::time_point sent = Clock::now();
                QMetaObject::invokeMethod(
                    &application,
                    [&, stamped, sent] {
                        pen.send(s.canvas(), stamped);
                        if (const StrokePtr &draft = s.document().draft())
                            waiting.push_back({sent, draft->segments.back().born, s.canvas().neededFrame()});
                        ++taken;
                    },
                    Qt::QueuedConnection);
            }
        });
        runUntil([&] { return taken == reports && waiting.empty(); }, std::chrono::seconds(60));
        hand.join();
        runUntil([] { return false; }, std::chrono::milliseconds(200)); // as long as a hand needs to the next stroke
    }
    return times;
}

Report measurePen(Application &application, EditingSession &s, int strokes)
{
    Report report{"pen to frame, ms", {}};
    constexpr int reports = 75;
    s.window().action(Command::Brush).trigger();
    for (const char *name : {"ink-wash", "watercolour-edge", "dry-chalk"}) {
        const auto &brushes = builtinBrushes();
        const auto brush = std::ranges::find(brushes, QLatin1String(name), &Brush::name);
        if (brush == brushes.end())
            continue;
        s.editor().setBrush(*brush);
        s.settle();
        const Times times = penTimes(application, s, strokes, reports);
        report.rows.push_back(rowOf(QLatin1String(name), times));
        report.rows.back().values.emplace_back("reports", double(times.ms.size()));
        while (s.editor().undoStack().canUndo())
            s.editor().undoStack().undo();
        s.editor().clock().setTime(s.painting().end());
        s.settle();
    }
    return report;
}

// --- Spreading
// ---------------------------------------------------------------------------------------------------------

/// Strokes painted within the next half second that spread for ten.
StrokeList spreadingStrokes(Document &document, Microseconds now)
{
    bench::PaintingOptions options;
    options.strokes = 20;
    options.segments = 1000;
    options.width = document.painting()->canvas.width;
    options.height = document.painting()->canvas.height;
    options.seed = 7;
    constexpr float seconds = 10;
    StrokeList strokes;
    for (const StrokePtr &one : bench::makePainting(options).strokes) {
        auto stroke = std::make_shared<Stroke>(*one);
        stroke->id = document.takeStrokeId();
        stroke->group = 0;
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            Segment &segment = stroke->segments[k];
            segment.diffusion *= segment.maxAge / seconds;
            segment.maxAge = seconds;
            segment.born = now + Microseconds(10'000 * k);
        }
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

Report measureSpreading(Application &application, EditingSession &s)
{
    std::size_t segments = 0;
    const StrokeList strokes = spreadingStrokes(s.document(), s.editor().clock().time());
    for (const StrokePtr &stroke : strokes)
        segments += stroke->segments.size();
    const Edit edit = addStrokes(s.document(), {strokes.begin(), strokes.end()}, false);
    Times apart;
    {
        std::optional<Clock::time_point> last;
        const Screen screen(application, s.canvas(), [&](const FrameInfo &) {
            if (last)
                apart.ms.push_back(since(*last));
            last = Clock::now();
        });
        s.editor().push(edit, "spread");
        runUntil([] { return false; }, std::chrono::seconds(8));
    }
    double sum = 0;
    for (const double ms : apart.ms)
        sum += ms;
    Report report{"spreading, from frame to frame, ms", {}};
    report.rows.push_back(
        rowOf(QStringLiteral("%1 strokes of %2 segments").arg(strokes.size()).arg(segments / strokes.size()), apart));
    report.rows.back().values.emplace_back("frames/s", 1e3 * double(apart.ms.size()) / sum);
    s.editor().undoStack().undo();
    s.editor().clock().setTime(s.painting().end());
    s.settle();
    return report;
}

// --- Scrubbing
// ---------------------------------------------------------------------------------------------------------

Report measureScrubbing(EditingSession &s, int events)
{
    Report report{QStringLiteral("scrubbing, from event to frame, ms; %1 events").arg(events), {}};
    TimelinePanel *panel = s.window().findChild<TimelinePanel *>();
    qobject_cast<QDockWidget *>(panel->parentWidget())->show();
    QCoreApplication::processEvents();
    TimelineView &view = *panel->view();
    view.fit();
    s.settle();
    const double from = view.xOf(0), to = view.xOf(s.painting().end());
    const auto measure = [&](const QString &name, const std::function<double(int)> &share) {
        const auto at = [&](int i) { return Point{from + (to - from) * share(i), 5}; };
        s.mouse(*view.viewport(), QEvent::MouseButtonPress, at(0));
        s.settle();
        const DragTimes times = s.paced(events, [&](int i) { s.mouse(*view.viewport(), QEvent::MouseMove, at(i)); });
        s.mouse(*view.viewport(), QEvent::MouseButtonRelease, at(events - 1));
        s.settle();
        report.rows.push_back(rowOf(name, times));
    };
    measure("drag over all of it", [=](int i) { return double(i) / events; });
    measure("drag back in the last fifth", [=](int i) { return 1 - 0.2 * i / events; });
    measure("to and fro", [=](int i) { return 0.7 + 0.25 * std::sin(0.1 * i); });
    measure("jumps anywhere", [=](int i) { return std::fmod(0.618034 * (i + 1), 1.0); });
    measure("jumps in the last fifth", [=](int i) { return 0.8 + 0.2 * std::fmod(0.618034 * (i + 1), 1.0); });
    s.editor().clock().setTime(s.painting().end());
    s.settle();
    return report;
}

// --- Films
// -------------------------------------------------------------------------------------------------------------

/// Every frame drawn; written where there is a writer. Milliseconds.
Result<double> drawFilm(const std::vector<std::unique_ptr<Renderer>> &renderers, const RenderRequest &request,
                        const std::vector<Microseconds> &moments, FilmWriter *writer, SequenceStats &stats)
{
    const Clock::time_point start = Clock::now();
    const auto drawn = renderSequence(renderers, request, moments, 2, [&](std::size_t i, const FloatPicture &picture) {
        return writer ? writer->write(i, picture) : Result<void>();
    });
    if (!drawn)
        return Error{drawn.error()};
    if (writer)
        if (const Result<void> kept = writer->commit(); !kept)
            return Error{kept.error()};
    stats = *drawn;
    return since(start);
}

std::vector<Report> measureFilm(const Painting &painting)
{
    constexpr int width = 1024, height = 768, frames = 300;
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(painting);
    request.time = painting.end();
    request.view = View::ofArea(painting.canvas.area(), width, height);
    RendererOptions options;
    options.backend = Backend::Cpu;
    options.threads = 2;
    const auto renderers = makeRenderers(options);
    if (!renderers)
        qFatal("%s", qPrintable(renderers.error()));
    Times full;
    FloatPicture picture;
    for (int i = 0; i < 15; ++i) {
        renderers->front()->invalidate();
        const Clock::time_point start = Clock::now();
        if (!renderers->front()->render(request, picture, nullptr))
            qFatal("no picture");
        full.ms.push_back(since(start));
    }
    Report render{"a picture, ms", {rowOf("full render, 1024 × 768", full)}};
    Report films{"a film of 300 frames", {}};
    const QTemporaryDir folder;
    const FilmOptions file{
        .path = folder.filePath("%05d.png"), .frames = frames, .width = width, .height = height, .image = {}};
    const std::vector<Microseconds> moments = timelapseMoments(painting, {frames, 0.5});
    for (const bool writes : {false, true}) {
        auto writer = writes ? openFilm(file) : Result<std::unique_ptr<FilmWriter>>(nullptr);
        SequenceStats stats;
        const Result<double> made =
            writer ? drawFilm(*renderers, request, moments, writer->get(), stats) : Error{writer.error()};
        if (!made) { // as where the module that writes images is missing
            QTextStream(stderr) << made.error() << '\n';
            continue;
        }
        films.rows.push_back({writes ? "PNG files" : "drawn",
                              {{"s", 1e-3 * *made},
                               {"full renders", *made / full.at(0.5)},
                               {"tiles %", 100.0 * double(stats.tilesEvaluated) / double(stats.tiles)}}});
    }
    return {render, films};
}

} // namespace

int main(int argc, char *argv[])
{
    const QTemporaryDir folder;
    useOwnSettings(folder);
    Application application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"painting", "A document; without it one of the size of the paper's figure 11f.", "file"},
                       {"strokes", "A generated painting of so many strokes of ten segments.", "count"},
                       {"events", "Events of a drag, ten for each stroke of the pen (300).", "count", "300"},
                       {"only", "Parts, separated by commas: pen, spreading, scrubbing, film.", "parts"},
                       {"json", "For programs."}});
    parser.process(application);
    const int events = std::max(parser.value("events").toInt(), 10);
    const Result<Painting> painting = paintingFrom(parser);
    if (!painting) {
        QTextStream(stderr) << painting.error() << '\n';
        return 1;
    }
    const QStringList only = parser.value("only").split(',', Qt::SkipEmptyParts);
    const auto wanted = [&only](const char *part) { return only.isEmpty() || only.contains(QLatin1String(part)); };
    settings::setThreads(2);
    QJsonArray json;
    const auto tell = [&](const Report &report) {
        if (parser.isSet("json"))
            json << jsonOf(report);
        else
            print(report);
    };
    {
        EditingSession session(application, std::make_shared<const Painting>(*painting));
        if (wanted("pen"))
            tell(measurePen(application, session, events / 10));
        if (wanted("spreading"))
            tell(measureSpreading(application, session));
        if (wanted("scrubbing"))
            tell(measureScrubbing(session, events));
    }
    if (wanted("film"))
        for (const Report &report : measureFilm(*painting))
            tell(report);
    if (parser.isSet("json"))
        QTextStream(stdout) << QJsonDocument(json).toJson();
    return 0;
}
