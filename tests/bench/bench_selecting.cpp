// How long selecting, the overlay and dragging take on the GUI thread, with a painting of many strokes.
//   bench_selecting [strokes]     10000 unless told; ten segments a stroke
// Prints a line a case: median and 99th percentile in milliseconds, by the clock on the wall and of the thread's own
// time (which a busy machine does not spoil).
#include "app/canvas/canvas_widget.h"
#include "app/canvas/overlay/selection_outline.h"
#include "app/session/selecting/pick.h"
#include "app/window/main_window.h"
#include "render/bench/generator.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPainter>

#include <cstdio>
#include <ctime>
#include <random>

using namespace suffuse;

namespace {

constexpr int width = 1920, height = 1080;

Painting paintingOf(int strokes)
{
    bench::PaintingOptions options;
    options.strokes = strokes;
    options.segments = 10 * strokes;
    options.width = width;
    options.height = height;
    return bench::makePainting(options);
}

/// Milliseconds that this thread has computed for.
double computed()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

template <typename Work>
void measure(const char *name, int times, Work work)
{
    std::vector<double> wall, own;
    for (int i = 0; i < times; ++i) {
        QElapsedTimer timer;
        timer.start();
        const double before = computed();
        work(i);
        own.push_back(computed() - before);
        wall.push_back(double(timer.nsecsElapsed()) * 1e-6);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(own.begin(), own.end());
    const std::size_t middle = wall.size() / 2, high = std::size_t(0.99 * double(wall.size() - 1));
    std::printf("%-44s %9.3f %9.3f %9.3f %9.3f\n", name, wall[middle], wall[high], own[middle], own[high]);
    std::fflush(stdout);
}

Point randomPoint()
{
    static std::mt19937 random(1);
    std::uniform_real_distribution<double> x(0, width), y(0, height);
    return {x(random), y(random)};
}

void measurePicking(const Painting &painting)
{
    const Microseconds end = painting.end();
    measure("click: topmost paint under the pointer", 300,
            [&](int) { (void)pickTopmost(painting, end, randomPoint(), 3); });
    measure("Alt+click: all paint under the pointer", 300,
            [&](int) { (void)pickAll(painting, end, randomPoint(), 3); });
    measure("click where nothing is", 300, [&](int) {
        (void)pickTopmost(painting, end, randomPoint() - Point{width + 100.0, 0}, 3);
    });
    measure("rubber band over all", 20, [&](int) {
        (void)strokesWithin(painting, painting.end(), View::ofArea(Rect::of(0, 0, width, height), width, height),
                            Rect::of(0, 0, width, height));
    });
    const auto shared = std::make_shared<const Painting>(painting);
    measure("touch path: its start", 20, [&](int) { PathTouch(shared, end, 3, {0, 100}); });
    PathTouch path(shared, end, 3, {0, 100});
    measure("touch path: 20 pixels on", 100, [&](int i) { path.goOn({20.0 * i, 100 + 9.0 * i}); });
}

void measureOutline(const Painting &painting)
{
    const Selection all{selectableStrokes(painting, painting.end()), {}};
    const OverlayColours colours{Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta};
    SelectionOutline outline;
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    View view = View::ofArea(Rect::of(0, 0, width, height), width, height);
    const auto paint = [&](const Selection &selection) {
        QPainter painter(&image);
        outline.paint(painter, view, painting, selection, colours, 1);
    };
    measure("overlay, all selected, the view moved", 30, [&](int) {
        view.centre.x += 1;
        paint(all);
    });
    measure("overlay, all selected, nothing moved", 100, [&](int) { paint(all); });
    view.scale = 4;
    measure("overlay, all selected, zoomed in, moved", 30, [&](int) {
        view.centre.x += 1;
        paint(all);
    });
    Selection some;
    for (const StrokeId id : all.strokes)
        if (some.strokes.size() < 100)
            some.strokes.insert(id);
    view.scale = 1;
    measure("overlay, 100 selected, the view moved", 30, [&](int) {
        view.centre.x += 1;
        paint(some);
    });
    measure("overlay, 100 selected, nothing moved", 100, [&](int) { paint(some); });
}

void send(CanvasWidget &canvas, QEvent::Type type, Point at)
{
    const QPointF p(at.x, at.y);
    QMouseEvent event(type, p, canvas.mapToGlobal(p), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&canvas, &event);
}

/// From the event to the return of its handlers.
void measureEvents(const Painting &painting)
{
    MainWindow window;
    window.resize(width, height);
    window.show();
    window.editor().document().reset(std::make_shared<const Painting>(painting));
    window.editor().clock().setTime(painting.end());
    window.action(Command::Select).trigger();
    CanvasWidget &canvas = window.canvas();
    measure("mouse click on the canvas, all panels open", 50, [&](int) {
        const Point at = canvas.view().toPixels(randomPoint());
        send(canvas, QEvent::MouseButtonPress, at);
        send(canvas, QEvent::MouseButtonRelease, at);
    });
    const auto drag = [&](const char *name, std::size_t count) {
        Selection selection;
        for (const StrokePtr &stroke : painting.strokes)
            if (selection.strokes.size() < count)
                selection.strokes.insert(stroke->id);
        const Stroke &first = **painting.strokes.begin();
        const StrokePtr grabbed = first.segments.empty() ? nullptr : *painting.strokes.begin();
        canvas.setZoom(1);
        Point at = canvas.view().toPixels(grabbed->cubicOf(grabbed->segments[5 % grabbed->segments.size()]).at(0.5));
        const auto hit = pickTopmost(painting, painting.end(), canvas.view().toCanvas(at), 3);
        if (hit)
            selection.strokes.insert(hit->stroke);
        window.editor().document().setSelection(selection);
        send(canvas, QEvent::MouseButtonPress, at);
        measure(name, 60, [&](int) {
            at = at + Point{1, 1};
            send(canvas, QEvent::MouseMove, at);
        });
        send(canvas, QEvent::MouseButtonRelease, at);
        window.editor().undoStack().undo();
    };
    drag("a move of a drag, one stroke", 1);
    drag("a move of a drag, 100 strokes", 100);
    drag("a move of a drag, all strokes", painting.strokes.size());
    measure("select all", 20, [&](int i) { window.action(i % 2 ? Command::SelectAll : Command::Deselect).trigger(); });
}

} // namespace

int main(int argc, char *argv[])
{
    qputenv("SUFFUSE_PRESENTER", "raster");
    QApplication application(argc, argv);
    const int strokes = argc > 1 ? std::max(std::atoi(argv[1]), 10) : 10'000;
    const Painting painting = paintingOf(strokes);
    std::printf("%d strokes, %zu segments; ms: median, 99th percentile; own median, 99th\n", strokes,
                painting.segmentCount());
    measurePicking(painting);
    measureOutline(painting);
    measureEvents(painting);
    return 0;
}
