// What fills cost: whole pictures, pictures whose fills are prepared anew, and the drag of a node, by all threads.
// bench_fills [--runs N]
#include "render/backends.h"
#include "render/bench/rows.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

#include <numbers>
#include <random>

using namespace suffuse;

namespace {

void addCurve(Stroke &stroke, const std::array<Point, 4> &points, bool start)
{
    Segment g;
    for (std::size_t i = 0; i < 4; ++i)
        g.bezier[i] = toOffset(points[i], {});
    g.density = 0;
    g.start = start && !stroke.segments.empty();
    if (!start)
        g.bezier[0] = stroke.segments.back().bezier[3];
    stroke.segments.push_back(g);
}

/// A closed outline of curves around a point, whose distance from it changes by a share.
void addBlob(Stroke &stroke, Point centre, double radius, int segments, double uneven, std::mt19937 &random)
{
    std::uniform_real_distribution<double> u(1 - uneven, 1 + uneven);
    const double angle = 2 * std::numbers::pi / segments, handle = 4.0 / 3 * std::tan(angle / 4);
    const auto on = [&](double r, double a) { return centre + r * Point{std::cos(a), std::sin(a)}; };
    double from = radius * u(random);
    const double first = from;
    for (int k = 0; k < segments; ++k) {
        const double to = k + 1 == segments ? first : radius * u(random), a = k * angle, b = a + angle;
        const Point p = on(from, a), q = on(to, b);
        addCurve(stroke,
                 {p, p + handle * from * Point{-std::sin(a), std::cos(a)},
                  q - handle * to * Point{-std::sin(b), std::cos(b)}, q},
                 k == 0);
        from = to;
    }
}

Stroke filled(StrokeId id, double spread, StyleKind kind = StyleKind::Uniform)
{
    Stroke s;
    s.id = id;
    if (kind == StyleKind::Edge)
        s.style = {kind, {0.36f, 0.40f, 0.5f}};
    Fill fill;
    fill.diffusion = float(spread * spread / 4);
    fill.colour = {float(id % 7) / 7, float(id % 5) / 5, float(id % 3) / 3, 0.8f};
    s.fill = fill;
    return s;
}

PaintingPtr paintingOf(std::vector<Stroke> strokes)
{
    auto p = std::make_shared<Painting>();
    for (Stroke &s : strokes)
        p->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
    return p;
}

PaintingPtr disc(double spread)
{
    std::mt19937 random(1);
    Stroke s = filled(1, spread);
    addBlob(s, {512, 384}, 400, 4, 0, random);
    return paintingOf({s});
}

PaintingPtr shapes(int count, int segments, double spread)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Stroke> strokes;
    for (int k = 0; k < count; ++k) {
        Stroke s = filled(StrokeId(k + 1), spread, k % 3 == 0 ? StyleKind::Edge : StyleKind::Uniform);
        addBlob(s, {1024 * u(random), 768 * u(random)}, 10 + 20 * u(random), segments, 0.3, random);
        strokes.push_back(s);
    }
    return paintingOf(std::move(strokes));
}

/// An outline that is as uneven as its segments are long or, if `jagged`, a hundred times as much.
PaintingPtr coast(int segments, double spread, bool jagged = false)
{
    std::mt19937 random(3);
    Stroke s = filled(1, spread);
    addBlob(s, {512, 384}, 350, segments, jagged ? 3e-3 : 3e-5, random);
    return paintingOf({s});
}

struct Row {
    QString name;
    PaintingPtr painting;
    std::size_t dragged = 0; ///< the stroke of which a node is dragged
};

void measure(QTextStream &out, const Row &row, int runs)
{
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
    parser.process(app);
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
    return 0;
}
