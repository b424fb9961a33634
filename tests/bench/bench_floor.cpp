// Counts what a full render has to do: the floor that docs/performance.md compares times with.
#include "model/formats/files.h"
#include "render/backends.h"
#include "render/bench/generator.h"
#include "render/bench/measure.h"
#include "render/nodes/node_builder.h"
#include "tests/bench/baseline_kernels.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

#include <algorithm>
#include <cmath>

using namespace suffuse;

namespace {

constexpr int side = 16; // of a block

struct Counts {
    long long nodes = 0;
    long long boxPairs = 0;     ///< (node, block) whose boxes meet
    long long pairs = 0;        ///< of them, in blocks where the stroke can be seen
    long long strokeBlocks = 0; ///< (stroke, block) where it can be seen
    long long sums = 0;         ///< Σ over pairs of the sums that a pixel needs
    long long densitySums = 0;  ///< the same without the two of the gradient
};

/// Density below which a style draws nothing.
double visibleCut(const Style &style)
{
    const double x1 = double(style.xi[0]), x2 = double(style.xi[1]), x3 = double(style.xi[2]);
    if (style.kind == StyleKind::Uniform)
        return std::max(0.0, x1 - 8 * x2);
    if (style.kind == StyleKind::Feathering)
        return x1 * std::exp2(-13 / x2);
    const double r = std::pow(x2 / x1, 3), q = (r + std::sqrt(r * r + 4 * (1 / x3 - 1))) / 2;
    return x1 * std::pow(q, -1.0 / 3);
}

/// Channels beside φ and its gradient: colour where it varies, ω where it varies and there is paper.
int channelsOf(const Stroke &stroke, const Canvas &canvas)
{
    const auto varies = [&](auto value) {
        return std::any_of(stroke.segments.begin(), stroke.segments.end(),
                           [&](const Segment &s) { return !(value(s) == value(stroke.segments.front())); });
    };
    const bool grain = canvas.paper.kind != PaperKind::None && varies([](const Segment &s) { return s.granulation; });
    return (varies([](const Segment &s) { return s.colour; }) ? 4 : 0) + (grain ? 1 : 0);
}

/// One block: how many nodes reach it, and an upper bound of their density there.
struct BlockSum {
    long long nodes = 0;
    double bound = 0;
};

void countStroke(const Stroke &stroke, const bench::Job &job, Counts &counts)
{
    const View &view = job.view;
    const auto source = buildNodes(stroke, job.time, zoomOctave(view.scale), Rect::of(-1e9, -1e9, 2e9, 2e9));
    const int columns = (view.width + side - 1) / side, rows = (view.height + side - 1) / side;
    std::vector<BlockSum> blocks(std::size_t(columns) * std::size_t(rows));
    for (const Node &n : source->nodes) {
        const Point p = view.toPixels(stroke.origin + Offset{float(n.x), float(n.y)});
        const double metric = double(n.a) / (view.scale * view.scale), reach = double(n.cutRadius) / std::sqrt(metric);
        const auto cell = [](double v, int most) { return std::clamp(int(std::floor(v / side)), 0, most); };
        if (p.x + reach <= 0 || p.y + reach <= 0 || p.x - reach >= view.width || p.y - reach >= view.height)
            continue;
        for (int j = cell(p.y - reach, rows - 1); j <= cell(p.y + reach, rows - 1); ++j)
            for (int i = cell(p.x - reach, columns - 1); i <= cell(p.x + reach, columns - 1); ++i) {
                const double dx = std::max({0.0, i * side - p.x, p.x - (i + 1) * side});
                const double dy = std::max({0.0, j * side - p.y, p.y - (j + 1) * side});
                BlockSum &block = blocks[std::size_t(j) * std::size_t(columns) + std::size_t(i)];
                ++block.nodes;
                block.bound += double(n.weight) * std::exp(-metric * (dx * dx + dy * dy));
            }
    }
    const double cut = visibleCut(stroke.style);
    const int channels = channelsOf(stroke, job.painting->canvas);
    counts.nodes += (long long)source->nodes.size();
    for (const BlockSum &block : blocks) {
        counts.boxPairs += block.nodes;
        if (block.nodes == 0 || block.bound <= cut)
            continue;
        counts.pairs += block.nodes;
        counts.strokeBlocks += 1;
        counts.sums += block.nodes * (3 + channels);
        counts.densitySums += block.nodes * (1 + channels);
    }
}

/// Multiply-adds (lanes) a second on one core: the best of several tries, since others may use it.
double multiplyAddsPerSecond()
{
    double best = 0;
    float sink = 0;
    for (int run = 0; run < 10; ++run) {
        QElapsedTimer timer;
        timer.start();
        const long long lanes = baseline::baselineKernels().multiplyAdds(2'000'000, &sink);
        best = std::max(best, double(lanes) / (double(timer.nsecsElapsed()) * 1e-9));
    }
    return best;
}

QString report(const Counts &c, const View &view)
{
    const double peak = multiplyAddsPerSecond(), pixels = double(side) * side;
    const double fma = double(c.sums) * pixels, densityFma = double(c.densitySums) * pixels;
    const double exponentials = double(c.pairs) * 2 * side;
    QString text;
    const auto line = [&](const char *what, const QString &value) {
        text += QStringLiteral("%1  %2\n").arg(QLatin1String(what), -64).arg(value, 14);
    };
    const auto millions = [](double v) { return QString::number(v * 1e-6, 'f', 2) + " M"; };
    line("nodes", QString::number(c.nodes));
    line("(node, 16x16 block) pairs whose boxes meet", millions(double(c.boxPairs)));
    line("  of them where the stroke can be seen", millions(double(c.pairs)));
    line("(stroke, block) pairs where it can be seen", millions(double(c.strokeBlocks)));
    line("pixels shaded and mixed", millions(double(c.strokeBlocks) * pixels));
    line("multiply-adds: density, gradient and channels", millions(fma));
    line("multiply-adds: density and channels alone", millions(densityFma));
    line("exponentials, 32 a pair", millions(exponentials));
    line("bytes: the picture, RGBA of floats", millions(double(view.width) * view.height * 16));
    line("bytes: tables of exponentials read, 32 floats a sum and pair", millions(double(c.sums) * 2 * side * 4));
    line("multiply-adds a second of a core (best of 10)", millions(peak));
    line("floor, one core: sums alone, ms", QString::number(1e3 * fma / peak, 'f', 2));
    line("floor, one core: density and channels alone, ms", QString::number(1e3 * densityFma / peak, 'f', 2));
    // Counted in operations of one lane: 12 an exponential, 40 a pixel shaded and mixed.
    const double all = fma + 12 * exponentials + 40 * double(c.strokeBlocks) * pixels;
    line("floor, one core: with exponentials (12 each) and shading (40), ms",
         QString::number(1e3 * all / peak, 'f', 2));
    return text;
}

/// The document named, or a generated painting.
Result<PaintingPtr> paintingOf(const QCommandLineParser &parser)
{
    if (parser.isSet("painting")) {
        Result<Painting> loaded = loadPainting(parser.value("painting"));
        if (!loaded)
            return Error{loaded.error()};
        return PaintingPtr(std::make_shared<const Painting>(std::move(*loaded)));
    }
    bench::PaintingOptions options;
    const QStringList spread = parser.value("spread").split(',');
    options.spreadLow = spread.value(0).toDouble();
    options.spreadHigh = spread.value(1).toDouble();
    if (!(options.spreadLow > 0) || !(options.spreadHigh >= options.spreadLow))
        return Error{QStringLiteral("--spread: give two numbers, e.g. --spread 6,20")};
    return PaintingPtr(std::make_shared<const Painting>(bench::makePainting(options)));
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.setApplicationDescription("Counts the operations of a full render and the time they take at least.");
    parser.addHelpOption();
    parser.addOptions({{"painting", "Document to count (default: a generated one of figure 11f's size).", "FILE"},
                       {"spread", "Range of the generated strokes' spread, in units.", "LO,HI", "6,20"},
                       {"width", "Pixels across.", "W", "1024"}});
    parser.process(app);
    const Result<PaintingPtr> painting = paintingOf(parser);
    if (!painting) {
        QTextStream(stderr) << "bench_floor: " << painting.error() << Qt::endl;
        return 1;
    }
    const bench::Job job =
        bench::jobOf(*painting, std::clamp(parser.value("width").toInt(), 1, 8192), {}, makeRenderer);
    Counts counts;
    for (const StrokePtr &stroke : job.painting->strokes)
        if (job.painting->isVisible(*stroke))
            countStroke(*stroke, job, counts);
    QTextStream(stdout) << report(counts, job.view);
    return 0;
}
