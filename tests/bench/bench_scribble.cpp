// What a painter meets who fills a scribble that crosses itself all over: the window's own time, by each thing they do.
// bench_scribble [--segments N] [--samples N]
#include "tests/bench/bench_start.h"
#include "tests/bench/editing/editing_session.h"
#include "tests/bench/filled_shapes.h"

#include <QElapsedTimer>
#include <QTextStream>

using namespace suffuse;
using namespace suffuse::baseline;

namespace {

QTextStream &out()
{
    static QTextStream stream(stdout);
    return stream;
}

void tell(const QString &name, double gui, double wall)
{
    out() << name.leftJustified(52) << QString::number(gui, 'f', 1).rightJustified(11)
          << QString::number(wall, 'f', 1).rightJustified(11) << Qt::endl;
}

/// What the window computes and how long it takes until `act` has returned, and until what it did has been painted.
void measure(EditingSession &s, const QString &name, const std::function<void()> &act)
{
    QElapsedTimer timer;
    timer.start();
    const double before = computedMs();
    act();
    tell(name, computedMs() - before, 1e-6 * double(timer.nsecsElapsed()));
    double gui = 0;
    const double wall = s.untilPainted([&] { s.canvas().updateOverlay(); }, &gui);
    tell("    its overlay", gui, wall);
}

void drawLasso(EditingSession &s, int samples)
{
    s.window().action(Command::LassoFill).trigger();
    s.settle();
    std::vector<Point> way;
    for (const Cubic &curve : scribbleCurves(samples / 3))
        for (const double t : {0.0, 1 / 3.0, 2 / 3.0})
            way.push_back(s.canvas().view().toPixels(curve.at(t)));
    s.mouse(QEvent::MouseButtonPress, way.front());
    const std::size_t last = way.size() - 2;
    for (std::size_t i = 1; i <= last; ++i) {
        const bool told = i == last || (i & (i - 1)) == 0;
        const auto act = [&] { s.mouse(QEvent::MouseMove, way[i]); };
        if (told && i >= 256)
            measure(s, QString("lasso, sample %1").arg(i), act);
        else if (i % 16 == 0 || told) // the ones between come in one event
            act();
    }
    measure(s, "lasso, its end", [&] { s.mouse(QEvent::MouseButtonRelease, way.back()); });
    QElapsedTimer timer;
    timer.start();
    s.settle();
    tell("    until it is seen", 0, 1e-6 * double(timer.nsecsElapsed()));
}

void handle(EditingSession &s)
{
    const auto pixel = [&](Point p) { return s.canvas().view().toPixels(p); };
    const Point on = pixel({512, 384});
    const auto drag = [&](const QString &name, Point from) {
        measure(s, name + ", press", [&] { s.mouse(QEvent::MouseButtonPress, from); });
        for (int i = 1; i <= 3; ++i)
            measure(s, name + QString(", move %1").arg(i), [&] {
                s.mouse(QEvent::MouseMove, from + Point{7.0 * i, 5.0 * i});
            });
        measure(s, name + ", release", [&] { s.mouse(QEvent::MouseButtonRelease, from + Point{21, 15}); });
        QElapsedTimer timer;
        timer.start();
        s.settle();
        tell("    until it is seen", 0, 1e-6 * double(timer.nsecsElapsed()));
    };
    s.document().setSelection({});
    s.window().action(Command::Select).trigger();
    measure(s, "Select, hover", [&] { s.mouse(QEvent::MouseMove, on); });
    drag("Select, drag", on);
    s.window().action(Command::Segments).trigger();
    measure(s, "Segments, hover", [&] { s.mouse(QEvent::MouseMove, on + Point{30, 0}); });
    drag("Segments, drag", on + Point{30, 10});
    measure(s, "zoom", [&] { s.window().action(Command::ZoomIn).trigger(); });
    QElapsedTimer timer;
    timer.start();
    s.settle();
    tell("    until it is seen", 0, 1e-6 * double(timer.nsecsElapsed()));
    measure(s, "undo", [&] { s.window().action(Command::Undo).trigger(); });
}

} // namespace

int main(int argc, char **argv)
{
    const QTemporaryDir folder;
    useOwnSettings(folder);
    Application application(argc, argv);
    QCommandLineParser parser;
    parser.addOption({"segments", "Segments of the scribble that is handled (default 10000).", "N", "10000"});
    parser.addOption({"samples", "Samples of the lasso (default 4096).", "N", "4096"});
    parser.process(application);
    settings::setThreads(2);
    auto empty = std::make_shared<Painting>();
    empty->canvas.width = 1024, empty->canvas.height = 768;
    out() << QString("ms").leftJustified(52) << "     window       wall\n";
    if (const int samples = parser.value("samples").toInt(); samples > 256) {
        EditingSession session(application, empty);
        drawLasso(session, samples);
        handle(session);
    }
    if (const int segments = parser.value("segments").toInt(); segments > 2) {
        QElapsedTimer timer;
        timer.start();
        EditingSession session(application, scribble(segments, 8));
        tell(QString("%1 segments, until they are seen").arg(segments), 0, 1e-6 * double(timer.nsecsElapsed()));
        handle(session);
    }
    return 0;
}
