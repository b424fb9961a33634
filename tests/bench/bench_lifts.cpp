// What lifting and fading cost: times of strokes from which paint is taken away, over those of the same strokes
// without. bench_lifts [--runs N] [--scale PX] [--only TEXT] [PAINTING…]; of each painting the strokes with the most
// segments are measured, too.
#include "model/formats/files.h"
#include "model/shaping/curves/chains.h"
#include "render/backends.h"
#include "render/bench/rows.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

#include <algorithm>
#include <ctime>
#include <numbers>

using namespace suffuse;

namespace {

constexpr double eraserSpread = 7; // of a soft eraser of radius 12
constexpr std::size_t washSegments = 600, washLifts = 200;

Segment segmentBetween(Point a, Point b, double spread, double peak)
{
    Segment g;
    for (std::size_t i = 0; i < 4; ++i)
        g.bezier[i] = toOffset(a + (double(i) / 3) * (b - a), {});
    g.diffusion = float(spread * spread / 4);
    g.density = float(peak * std::sqrt(std::numbers::pi) * spread);
    return g;
}

/// A hill filled to and fro, its passes running into each other.
Stroke washOf(const Style &style, bool coloursVary)
{
    constexpr int passes = 20, each = int(washSegments) / passes;
    Stroke s;
    s.id = 1;
    s.style = style;
    const auto at = [](int k) {
        const int pass = k / each, step = k % each;
        const double along = double(pass % 2 ? each - step : step) / each;
        return Point{130 + 760 * along, 100 + 560.0 * k / (passes * each) + 40 * std::sin(3 * along)};
    };
    for (int k = 0; k < passes * each; ++k) {
        s.segments.push_back(segmentBetween(at(k), at(k + 1), 14, 0.9 * double(style.xi[0])));
        if (k > 0)
            s.segments.back().bezier[0] = s.segments[std::size_t(k) - 1].bezier[3];
        s.segments.back().colour = {0.1f, coloursVary ? float(k % 11) / 11 : 0.7f, 0.9f, coloursVary ? 0.8f : 0.9f};
    }
    return s;
}

constexpr double fadingPeak = 0.51; ///< which takes 40 %

/// The stroke with `count` segments that lift, or fade, as several rubs of a soft eraser across it.
Stroke erasedFrom(Stroke s, std::size_t count, const Rect &area, double spread, double peak, bool fades)
{
    constexpr std::size_t chains = 5;
    for (std::size_t c = 0; c < chains; ++c) {
        const std::size_t n = count / chains;
        const auto at = [&](std::size_t k) {
            const double along = double(k) / double(n);
            return Point{area.left + area.width() * (double(c) + 0.5 + 0.4 * std::sin(7 * along)) / chains,
                         area.top + area.height() * along};
        };
        std::vector<Segment> chain;
        for (std::size_t k = 0; k < n; ++k) {
            chain.push_back(
                segmentBetween(at(k) - (s.origin - Point()), at(k + 1) - (s.origin - Point()), spread, peak));
            (fades ? chain.back().fade : chain.back().lift) = true;
            if (k > 0)
                chain.back().bezier[0] = chain[k - 1].bezier[3];
        }
        appendChain(s, std::move(chain));
    }
    return s;
}

PaintingPtr paintingOf(const Canvas &canvas, std::vector<Stroke> strokes)
{
    auto p = std::make_shared<Painting>();
    p->canvas = canvas;
    for (Stroke &s : strokes)
        p->strokes.push_back(std::make_shared<const Stroke>(std::move(s)));
    return p;
}

struct Settings {
    int runs;
    double scale; ///< pixels a unit
};

/// Draws paintings in turn by one thread, and tells the median of the computing time of each, in milliseconds, which
/// holds on a busy machine, too. `fresh`: by a renderer that has not prepared anything.
std::vector<double> mediansOf(const std::vector<PaintingPtr> &paintings, const Settings &settings, bool fresh)
{
    const auto make = [] { return std::move(*makeRenderer({Backend::Cpu, 1})); };
    std::vector<std::unique_ptr<Renderer>> renderers;
    std::vector<Picture8> pictures(paintings.size());
    std::vector<std::vector<double>> ms(paintings.size());
    for (int run = -1; run < settings.runs; ++run) // the first one warms up
        for (std::size_t i = 0; i < paintings.size(); ++i) {
            if (run < 0)
                renderers.push_back(make());
            else if (fresh)
                renderers[i] = make();
            const Rect area = paintings[i]->canvas.area();
            const int width = int(std::lround(area.width() * settings.scale));
            RenderRequest request;
            request.painting = paintings[i];
            request.time = paintings[i]->end();
            request.view = View::ofArea(area, width, heightForWidth(area, width));
            renderers[i]->invalidate();
            const std::clock_t begin = std::clock();
            (void)renderers[i]->render(request, pictures[i]);
            if (run >= 0)
                ms[i].push_back(1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC);
        }
    std::vector<double> medians;
    for (const std::vector<double> &times : ms)
        medians.push_back(bench::timingOf(times).medianMs);
    return medians;
}

/// A row: both times without that of an empty canvas, and their ratio, for pictures and for pictures with their nodes.
double measure(QTextStream &out, const QString &name, const Canvas &canvas, const Stroke &plain, const Stroke &erased,
               const Settings &settings)
{
    const std::vector<PaintingPtr> paintings{paintingOf(canvas, {}), paintingOf(canvas, {plain}),
                                             paintingOf(canvas, {erased})};
    out << name.leftJustified(44) << QString::number(plain.segments.size()).rightJustified(6)
        << QString::number(erased.segments.size() - plain.segments.size()).rightJustified(6);
    double worst = 0;
    for (const bool fresh : {false, true}) {
        const std::vector<double> ms = mediansOf(paintings, settings, fresh);
        const double without = ms[1] - ms[0], with = ms[2] - ms[0], ratio = with / without;
        out << QStringLiteral("%1 %2 %3").arg(without, 9, 'f', 3).arg(with, 8, 'f', 3).arg(ratio, 6, 'f', 2);
        worst = std::max(worst, ratio);
    }
    out << Qt::endl;
    return worst;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOption({"runs", "Runs of each (default 15).", "N", "15"});
    parser.addOption({"scale", "Pixels a canvas unit (default 1).", "PX", "1"});
    parser.addOption({"only", "Rows whose name has this text.", "TEXT"});
    parser.addPositionalArgument("PAINTING", "Paintings whose strokes are measured, too.", "[PAINTING...]");
    parser.process(app);
    const Settings settings{std::max(1, parser.value("runs").toInt()),
                            std::max(0.01, parser.value("scale").toDouble())};
    QTextStream out(stdout);
    out << "computing time of one thread, medians of " << settings.runs << " runs, ms; without an empty canvas's\n"
        << QStringLiteral("stroke").leftJustified(44)
        << "  laid taken   without    with ratio   with nodes: both, ratio\n";
    const std::pair<const char *, Style> styles[] = {{"uniform", {StyleKind::Uniform, {0.5f, 0.05f, 0}}},
                                                     {"feathering", {StyleKind::Feathering, {1.1f, 1.5f, 0}}},
                                                     {"dark edges", {StyleKind::Edge, {0.36f, 0.40f, 0.5f}}}};
    Canvas sheet;
    sheet.width = 1024, sheet.height = 768;
    double worst = 0;
    const auto isWanted = [only = parser.value("only")](const QString &row) { return row.contains(only); };
    for (const auto &[name, style] : styles)
        for (const bool coloursVary : {false, true})
            for (const bool fades : {false, true}) {
                const QString row = QStringLiteral("wash, %1%2, %3")
                                        .arg(QLatin1String(name), QLatin1String(coloursVary ? ", colours" : ""),
                                             QLatin1String(fades ? "faded" : "lifted"));
                if (!isWanted(row))
                    continue;
                const Stroke wash = washOf(style, coloursVary);
                const Stroke erased = erasedFrom(wash, washLifts, Rect::of(200, 150, 620, 470), eraserSpread,
                                                 fades ? fadingPeak : double(style.xi[0]), fades);
                worst = std::max(worst, measure(out, row, sheet, wash, erased, settings));
            }
    for (const QString &path : parser.positionalArguments()) {
        const auto painting = loadPainting(path);
        if (!painting) {
            out << painting.error() << '\n';
            return 1;
        }
        std::vector<StrokePtr> strokes(painting->strokes.begin(), painting->strokes.end());
        std::ranges::stable_sort(strokes, std::greater{}, [](const StrokePtr &s) { return s->segments.size(); });
        for (std::size_t i = 0; i < std::min<std::size_t>(strokes.size(), 5); ++i) {
            const Stroke &s = *strokes[i];
            Rect box;
            for (const Segment &segment : s.segments)
                box = box.united(s.cubicOf(segment).controlBox());
            for (const bool fades : {false, true}) {
                const QString row = QStringLiteral("%1, stroke %2, %3")
                                        .arg(QFileInfo(path).fileName())
                                        .arg(s.id)
                                        .arg(QLatin1String(fades ? "faded" : "lifted"));
                if (!isWanted(row))
                    continue;
                const Stroke erased = erasedFrom(s, s.segments.size() / 3 + 5, box, eraserSpread,
                                                 fades ? fadingPeak : double(s.style.xi[0]), fades);
                worst = std::max(worst, measure(out, row, painting->canvas, s, erased, settings));
            }
        }
    }
    out << "the greatest ratio is " << QString::number(worst, 'f', 2) << '\n';
    return 0;
}
