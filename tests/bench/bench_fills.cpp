// What fills cost: whole pictures, pictures whose fills are prepared anew, and the drag of a node, by all threads.
// bench_fills [--runs N] [--only TEXT] [--scribble N]
#include "render/backends.h"
#include "render/bench/rows.h"
#include "tests/bench/filled_shapes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

using namespace suffuse;
using namespace suffuse::baseline;

namespace {

/// What the names of the paintings that are measured contain.
QString &only()
{
    static QString text;
    return text;
}

struct Row {
    QString name;
    PaintingPtr painting;
    std::size_t dragged = 0; ///< the stroke of which a node is dragged
};

void measure(QTextStream &out, const Row &row, int runs)
{
    if (!row.name.contains(only()))
        return;
    const Rect sheet = Rect::of(0, 0, 1024, 768);
    const View view = View::ofArea(sheet, 1024, 768);
    Picture8 picture;
    std::vector<double> whole, anew, drag;
    const auto draw = [&](Renderer &renderer, const PaintingPtr &p, bool interactive) {
        QElapsedTimer timer;
        timer.start();
        (void)renderer.render({p, p->end(), view, false, interactive}, picture);
        return double(timer.nsecsElapsed()) * 1e-6;
    };
    auto renderer = std::move(*makeRenderer({Backend::Cpu}));
    for (int run = -1; run < runs; ++run) {
        auto fresh = std::move(*makeRenderer({Backend::Cpu}));
        const double first = draw(*fresh, row.painting, false);
        renderer->invalidate();
        const double again = draw(*renderer, row.painting, false);
        auto moved = std::make_shared<Painting>(*row.painting);
        Stroke s = *row.painting->strokes[row.dragged];
        s.segments[1].bezier[0].x += 0.25f * float(run + 2);
        s.segments[0].bezier[3] = s.segments[1].bezier[0];
        moved->strokes[row.dragged] = std::make_shared<const Stroke>(s);
        const double dragging = draw(*renderer, moved, true);
        if (run < 0)
            continue;
        anew.push_back(first), whole.push_back(again), drag.push_back(dragging);
    }
    out << row.name.leftJustified(52);
    for (const auto *times : {&whole, &anew, &drag})
        out << QString::number(bench::timingOf(*times).medianMs, 'f', 2).rightJustified(11);
    out << Qt::endl;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOption({"runs", "Runs of each (default 15).", "N", "15"});
    parser.addOption({"scribble", "Segments of the largest scribble (default 30000).", "N", "30000"});
    parser.addOption({"only", "Paintings whose names contain this.", "TEXT"});
    parser.process(app);
    only() = parser.value("only");
    const int runs = std::max(1, parser.value("runs").toInt());
    QTextStream out(stdout);
    out << "1024 × 768, medians of " << runs << " runs, ms; of the drag the first frame of each\n"
        << QStringLiteral("painting").leftJustified(52) << "    picture  with nodes       drag\n";
    measure(out, {"one small shape", shapes(1, 3, 1)}, runs);
    measure(out, {"disc of 400 px radius, s = 8", disc(8)}, runs);
    measure(out, {"disc of 400 px radius, s = 1.5", disc(1.5)}, runs);
    measure(out, {"disc of 400 px radius, s = 100", disc(100)}, runs);
    measure(out, {"disc of 400 px radius, crisp", disc(1e-4)}, runs);
    measure(out, {"1,000 shapes of 12 segments, s = 4", shapes(1000, 12, 4), 500}, runs);
    measure(out, {"1,000 shapes of 12 segments, crisp", shapes(1000, 12, 1e-4), 500}, runs);
    measure(out, {"outline of 100,000 segments, s = 8", coast(100'000, 8)}, std::min(runs, 5));
    measure(out, {"outline of 100,000 segments, crisp", coast(100'000, 1e-4)}, std::min(runs, 5));
    measure(out, {"jagged outline of 100,000 segments, s = 8", coast(100'000, 8, true)}, std::min(runs, 3));
    for (const int segments : {1'000, 10'000, parser.value("scribble").toInt()})
        measure(out, {QString("scribble of %1 segments, s = 8").arg(segments), scribble(std::max(segments, 3), 8)},
                std::min(runs, segments > 1'000 ? 1 : 5));
    return 0;
}
