// Suffuse and the methods it is compared with, on one painting in one run.
#include "model/formats/files.h"
#include "render/backends.h"
#include "render/bench/generator.h"
#include "render/bench/measure.h"
#include "render/threads/parallel.h"
#include "tests/bench/baselines.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTextStream>

#include <algorithm>
#include <functional>

using namespace suffuse;

namespace {

struct Options {
    PaintingPtr painting;
    QString name;
    int width = 1024;
    int runs = 5;
    int threads = 0;
    bool json = false;
};

struct Method {
    QString name;
    bool oneCore = false; ///< it cannot use more
    std::function<double(const RenderRequest &, int threads)> milliseconds;
};

template <class Draw>
std::function<double(const RenderRequest &, int)> timed(Draw draw)
{
    return [draw](const RenderRequest &request, int threads) {
        QElapsedTimer timer;
        timer.start();
        const std::vector<float> picture = draw(request, threads);
        return picture.empty() ? -1 : double(timer.nsecsElapsed()) * 1e-6;
    };
}

std::vector<Method> methods()
{
    using namespace suffuse::baseline;
    std::vector<Method> out;
    for (int nodes : {8, 5})
        out.push_back({QStringLiteral("paper-method-%1-nodes").arg(nodes), false,
                       timed([nodes](const RenderRequest &r, int threads) { return paperMethod(r, nodes, threads); })});
    out.push_back({QStringLiteral("finite-differences-10-steps"), false,
                   timed([](const RenderRequest &r, int threads) { return finiteDifferences(r, 10, threads); })});
    out.push_back({QStringLiteral("libmypaint"), true, [](const RenderRequest &r, int) { return myPaintReplay(r); }});
    return out;
}

/// Our full render first, then each method; turns are taken, so that all see the same machine.
Result<std::vector<bench::Row>> measure(const Options &options, int threads)
{
    RendererOptions renderer;
    renderer.backend = Backend::Cpu;
    renderer.threads = threads;
    bench::Job job = bench::jobOf(options.painting, options.width, renderer, makeRenderer);
    job.runs = 1;
    RenderRequest request;
    request.painting = job.painting;
    request.time = job.time;
    request.view = job.view;
    const std::vector<Method> all = methods();
    std::vector<double> ours;
    std::vector<std::vector<double>> theirs(all.size());
    for (int run = 0; run < options.runs; ++run) {
        const Result<bench::StageTimings> stages = bench::measureStages(job);
        if (!stages)
            return Error{stages.error()};
        ours.push_back(stages->fullRender.medianMs);
        for (std::size_t i = 0; i < all.size(); ++i)
            if (threads == 1 || !all[i].oneCore)
                theirs[i].push_back(all[i].milliseconds(request, threads));
    }
    Result<bench::Row> row = bench::rowFor(job, QStringLiteral("full-render"), options.name);
    if (!row)
        return Error{row.error()};
    row->timing = bench::timingOf(ours);
    std::vector<bench::Row> rows{*row};
    const double median = row->timing.medianMs;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (theirs[i].empty() || theirs[i].front() < 0)
            continue;
        row->timing = bench::timingOf(theirs[i]);
        row->baseline = all[i].name;
        row->ratio = row->timing.medianMs / median;
        rows.push_back(*row);
    }
    return rows;
}

/// `message`: why the options cannot be used; empty where they can.
Options optionsOf(const QCommandLineParser &parser, QString &message)
{
    Options out;
    out.json = parser.isSet("json");
    out.runs = std::max(1, parser.value("runs").toInt());
    out.threads = parser.value("threads").toInt();
    out.width = parser.value("width").toInt();
    if (parser.isSet("painting")) {
        Result<Painting> painting = loadPainting(parser.value("painting"));
        if (!painting) {
            message = painting.error();
            return out;
        }
        out.painting = std::make_shared<const Painting>(std::move(*painting));
        out.name = QFileInfo(parser.value("painting")).completeBaseName();
    } else {
        bench::PaintingOptions generated;
        const QStringList spread = parser.value("spread").split(',');
        generated.spreadLow = spread.value(0).toDouble();
        generated.spreadHigh = spread.value(1).toDouble();
        if (spread.size() != 2 || !(generated.spreadLow > 0) || !(generated.spreadHigh >= generated.spreadLow)) {
            message = QStringLiteral("--spread: give two numbers, e.g. --spread 6,20");
            return out;
        }
        out.painting = std::make_shared<const Painting>(bench::makePainting(generated));
        out.name = QStringLiteral("figure11f");
    }
    if (out.width < 1 || out.width > 8192)
        message = QStringLiteral("--width: give pixels from 1 to 8192");
    return out;
}

} // namespace

int main(int argc, char *argv[])
{
    qputenv("OMP_NUM_THREADS", "1"); // libmypaint on one core, as Suffuse beside it
    QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.setApplicationDescription("Times Suffuse's CPU renderer and the methods it is compared with in one run.");
    parser.addHelpOption();
    parser.addOptions({{"json", "Prints the rows as a JSON array."},
                       {"painting", "Document to draw (default: a generated one of figure 11f's size).", "FILE"},
                       {"spread", "Range of the generated strokes' spread, in units.", "LO,HI", "6,20"},
                       {"width", "Pixels across.", "W", "1024"},
                       {"threads", "Number of threads (default: 1, then one a core).", "N", "0"},
                       {"runs", "Runs a row.", "N", "5"}});
    parser.process(app);
    QTextStream error(stderr);
    QString message;
    const Options options = optionsOf(parser, message);
    if (!message.isEmpty()) {
        error << "bench_baselines: " << message << Qt::endl;
        return 2;
    }
    const std::vector<int> threads =
        options.threads > 0 ? std::vector{options.threads} : std::vector{1, hardwareThreads()};
    std::vector<bench::Row> rows;
    for (int n : threads) {
        const Result<std::vector<bench::Row>> some = measure(options, n);
        if (!some) {
            error << "bench_baselines: " << some.error() << Qt::endl;
            return 1;
        }
        rows.insert(rows.end(), some->begin(), some->end());
    }
    QTextStream(stdout) << (options.json ? QString::fromUtf8(bench::toJson(rows)) : bench::toTable(rows));
    return 0;
}
