// The CUDA renderer, the paper's kernels on the same device, the CPU renderer and the reference, in one run.
#include "render/backends.h"
#include "render/bench/plan.h"
#include "render/compare.h"
#include "tests/bench/cuda/paper_scene.h"
#include "tests/bench/cuda/several_devices.h"
#include "tests/bench/filled_shapes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <cmath>
#include <functional>
#include <map>

using namespace suffuse;

namespace {

struct Report {
    std::vector<bench::Row> rows;
    std::vector<CudaFact> facts;
};

struct Options {
    int runs = 101;
    double secondsARow = 10;
    int referenceStrokes = 100;
    double liveSpread = 48.75; ///< s of the live stroke when dry, px: figure 11f's mean, as much larger as the picture
};

bench::Job jobOf(const CudaCase &c, const PaintingPtr &painting, Backend backend, int runs)
{
    RendererOptions renderer;
    renderer.backend = backend;
    bench::Job job = bench::jobOf(painting, c.width, renderer, makeRenderer);
    job.runs = runs;
    return job;
}

RenderRequest requestOf(const bench::Job &job)
{
    RenderRequest request;
    request.painting = job.painting;
    request.time = job.time;
    request.view = job.view;
    return request;
}

/// Runs of one of the paper's kernels after a first one, as many as fit into the time; if none does, the first.
Result<bench::Timing> timed(baseline::PaperOnDevice &paper, baseline::PaperKernel kernel, int polynomials,
                            const Options &options)
{
    std::vector<double> times;
    std::string why;
    double seconds = 0;
    for (int run = -1; run < options.runs && seconds <= options.secondsARow; ++run) {
        const double ms = paper.draw(kernel, polynomials, why);
        if (ms < 0)
            return Error{QString::fromStdString(why)};
        seconds += ms * 1e-3;
        if (run >= 0 || seconds > options.secondsARow)
            times.push_back(ms);
    }
    return bench::timingOf(std::move(times));
}

struct PaperVariant {
    const char *name;
    baseline::PaperKernel kernel;
    int points;
    int polynomials;
};

/// The paper's kernels on the job's painting; their ratios to `ours`.
Result<void> addPaper(const bench::Job &job, const bench::Row &ours, const Options &options, Report &report)
{
    using baseline::PaperKernel;
    constexpr PaperVariant variants[] = {
        {"paper-as-written-8", PaperKernel::AsWritten, 8, 0}, {"paper-port-8", PaperKernel::Port, 8, 0},
        {"paper-port-8-1", PaperKernel::Port, 8, 1},          {"paper-port-8-2", PaperKernel::Port, 8, 2},
        {"paper-as-written-5", PaperKernel::AsWritten, 5, 0}, {"paper-port-5", PaperKernel::Port, 5, 0},
        {"paper-port-5-1", PaperKernel::Port, 5, 1}};
    const RenderRequest request = requestOf(job);
    std::unique_ptr<baseline::PaperOnDevice> paper;
    baseline::PaperWork work;
    int points = 0;
    for (const PaperVariant &variant : variants) {
        if (variant.points == 5 && job.painting->segmentCount() > 100'000)
            continue; // minutes
        if (variant.points != points) {
            points = variant.points;
            std::string why;
            paper = baseline::paperOnDevice(baseline::paperScene(request, points), why);
            if (!paper)
                return Error{QString::fromStdString(why)};
            work = baseline::paperWork(request, points);
        }
        const Result<bench::Timing> timing = timed(*paper, variant.kernel, variant.polynomials, options);
        if (!timing)
            return Error{timing.error()};
        bench::Row row = ours;
        row.baseline = QLatin1String(variant.name);
        row.timing = *timing;
        row.ratio = timing->medianMs / ours.timing.medianMs;
        report.rows.push_back(row);
        const double operations = variant.kernel == PaperKernel::Port ? work.port : work.asWritten;
        report.facts.push_back({row.baseline, ours.painting, operations / timing->medianMs * 1e-6, "GFLOP/s"});
    }
    return {};
}

Result<void> fullRenders(const CudaCase &c, const Options &options, Report &report)
{
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    const bench::Job job = jobOf(c, *painting, Backend::Cuda, options.runs);
    const Result<bench::Timing> timing = bench::measureFullRender(job);
    if (!timing)
        return Error{timing.error()};
    Result<bench::Row> row = bench::rowFor(job, QStringLiteral("full-render"), c.name);
    if (!row)
        return Error{row.error()};
    row->timing = *timing;
    report.rows.push_back(*row);
    if (!c.sample.isEmpty())
        return {}; // The paper's kernels know neither paper nor styles of segments.
    return addPaper(job, *row, options, report);
}

Result<void> edits(const CudaCase &c, const Options &options, Report &report)
{
    bench::Plan plan;
    plan.make = makeRenderer;
    plan.name = c.name;
    plan.generated = c.painting;
    plan.devices.resize(1);
    plan.devices.front().backend = Backend::Cuda;
    plan.widths = {c.width};
    plan.only = QStringList{"drag", "edit-segment", "drag-among-100", "drag-among-10000"};
    plan.runs = options.runs;
    Result<std::vector<bench::Row>> rows = bench::run(plan);
    if (!rows)
        return Error{rows.error()};
    report.rows.insert(report.rows.end(), rows->begin(), rows->end());
    return {};
}

/// A stroke of which 180 and 2,000 segments spread, on top of figure 11f's strokes, 3840 × 2160 pixels.
Result<void> liveStrokes(const Options &options, Report &report)
{
    CudaCase c{"figure11f-3840", {}, 3840, {}};
    c.painting.width = 3840;
    c.painting.height = 2160;
    c.painting.unit = 3.75;
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    const bench::Job job = jobOf(c, *painting, Backend::Cuda, 1);
    for (int active : {180, 2000}) {
        const Result<bench::Timing> timing =
            bench::measureLiveStroke(job, options.liveSpread, active + 140, float(active) / 60);
        if (!timing)
            return Error{timing.error()};
        Result<bench::Row> row = bench::rowFor(job, QStringLiteral("live-stroke-%1-active").arg(active), c.name);
        if (!row)
            return Error{row.error()};
        row->timing = *timing;
        report.rows.push_back(*row);
        report.facts.push_back({row->name, c.name, 1000 / timing->medianMs, "frames/s"});
    }
    return {};
}

template <class Picture>
Result<Picture> drawn(Backend backend, const RenderRequest &request)
{
    RendererOptions options;
    options.backend = backend;
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
    if (!renderer)
        return Error{renderer.error()};
    Picture picture;
    const Result<RenderStats> stats = (*renderer)->render(request, picture);
    if (!stats)
        return Error{stats.error()};
    if (backend == Backend::Cuda && !(*renderer)->notice().isEmpty())
        return Error{(*renderer)->notice()};
    return picture;
}

Result<void> againstCpu(const CudaCase &c, const Options &, Report &report)
{
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    const RenderRequest request = requestOf(jobOf(c, *painting, Backend::Cpu, 1));
    const Result<Picture8> cpu = drawn<Picture8>(Backend::Cpu, request);
    const Result<Picture8> cuda = drawn<Picture8>(Backend::Cuda, request);
    if (!cpu || !cuda)
        return Error{cpu ? cuda.error() : cpu.error()};
    int largest = 0;
    std::size_t equal = 0;
    for (std::size_t i = 0; i < cpu->argb.size(); ++i)
        for (int shift = 0; shift < 24; shift += 8) {
            const int d = std::abs(int(cpu->argb[i] >> shift & 255) - int(cuda->argb[i] >> shift & 255));
            largest = std::max(largest, d);
            equal += d == 0;
        }
    report.facts.push_back({"against-cpu-largest", c.name, double(largest), "levels of 8 bits"});
    report.facts.push_back(
        {"against-cpu-equal", c.name, 100 * double(equal) / (3 * double(cpu->argb.size())), "% of bytes"});
    return {};
}

/// Paintings of fills: full renders, the first picture with all that is prepared for it, and frames in which a node of
/// a shape in the middle is dragged.
Result<void> fills(const CudaCase &c, const Options &options, Report &report)
{
    const std::map<QString, std::function<PaintingPtr()>> paintings{
        {"shapes-1000", [] { return baseline::shapes(1000, 12, 4); }},
        {"shapes-1000-crisp", [] { return baseline::shapes(1000, 12, 1e-4); }},
        {"disc-8", [] { return baseline::disc(8); }},
        {"disc-100", [] { return baseline::disc(100); }},
        {"coast-100000", [] { return baseline::coast(100'000, 8); }}};
    bench::Job job = jobOf(c, paintings.at(c.name)(), Backend::Cuda, options.runs);
    job.dragSteps = std::max(3 * options.runs, 10);
    const StrokeId middle = job.painting->strokes[job.painting->strokes.size() / 2]->id;
    const auto add = [&](const char *name, const Result<bench::Timing> &timing) -> Result<void> {
        if (!timing)
            return Error{timing.error()};
        Result<bench::Row> row = bench::rowFor(job, QLatin1String(name), c.name);
        if (!row)
            return Error{row.error()};
        row->timing = *timing;
        report.rows.push_back(*row);
        return {};
    };
    if (const Result<void> full = add("full-render", bench::measureFullRender(job)); !full)
        return full;
    if (const Result<void> drag = add("drag-node", bench::measureNodeDrag(job, middle)); !drag)
        return drag;
    return add("zoom-render", bench::measureZoom(job));
}

/// Part of the painting's strokes: the reference takes its time.
Result<void> againstReference(CudaCase c, const Options &options, Report &report)
{
    c.painting.segments = c.painting.segments * options.referenceStrokes / c.painting.strokes;
    c.painting.strokes = options.referenceStrokes;
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    const RenderRequest request = requestOf(jobOf(c, *painting, Backend::Reference, 1));
    const Result<FloatPicture> cuda = drawn<FloatPicture>(Backend::Cuda, request);
    if (!cuda)
        return Error{cuda.error()};
    QElapsedTimer timer;
    timer.start();
    const Result<FloatPicture> reference = drawn<FloatPicture>(Backend::Reference, request);
    if (!reference)
        return Error{reference.error()};
    const double seconds = double(timer.elapsed()) * 1e-3;
    const Result<PictureDifference> difference = compare(*cuda, *reference);
    if (!difference)
        return Error{difference.error()};
    const QString name = QStringLiteral("%1-%2-strokes").arg(c.name).arg(c.painting.strokes);
    report.facts.push_back({"against-reference-largest", name, 512 * difference->largest(), "of 1/512"});
    report.facts.push_back({"against-reference-over", name, double(difference->over), "pixels"});
    report.facts.push_back({"reference-took", name, seconds, "s"});
    return {};
}

/// Pictures of as many full renders as there are runs, and how many of them differ from the first in any bit.
Result<void> repeats(const CudaCase &c, const Options &options, Report &report)
{
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    const RenderRequest request = requestOf(jobOf(c, *painting, Backend::Cuda, 1));
    RendererOptions cuda;
    cuda.backend = Backend::Cuda;
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer(cuda);
    if (!renderer)
        return Error{renderer.error()};
    FloatPicture first;
    int different = 0;
    for (int run = 0; run < options.runs; ++run) {
        FloatPicture picture;
        (*renderer)->invalidate();
        const Result<RenderStats> stats = (*renderer)->render(request, picture);
        if (!stats || !(*renderer)->notice().isEmpty())
            return Error{stats ? (*renderer)->notice() : stats.error()};
        if (run == 0)
            first = std::move(picture);
        else
            different += picture.rgba != first.rgba;
    }
    report.facts.push_back(
        {"repeats-that-differ", c.name, double(different), QStringLiteral("of %1").arg(options.runs - 1)});
    return {};
}

Result<void> several(const CudaCase &c, const Options &options, Report &report)
{
    const Result<std::vector<CudaFact>> facts = timesOnSeveralDevices(c, options.runs);
    if (!facts)
        return Error{facts.error()};
    report.facts.insert(report.facts.end(), facts->begin(), facts->end());
    return {};
}

struct Group {
    const char *name;
    std::function<Result<void>(const CudaCase &, const Options &, Report &)> take;
    QStringList paintings;
};

std::vector<Group> groups()
{
    const QStringList all{"figure11f", "figure11f-2880", "spread-32-72", "million"};
    const QStringList withSamples = sampleCases() + all;
    return {{"full", fullRenders, withSamples},
            {"edits", edits, {"figure11f"}},
            {"fills", fills, filledCases()},
            {"live", [](const CudaCase &, const Options &o, Report &r) { return liveStrokes(o, r); }, {"figure11f"}},
            {"cpu", againstCpu, sampleCases() + QStringList{"figure11f", "figure11f-2880", "spread-32-72"}},
            {"repeats", repeats, {"figure11f", "ink-landscape-1024", "still-life-512"}},
            {"reference", againstReference, {"figure11f", "spread-32-72"}},
            {"several", several, {"figure11f", "still-life-1024"}}};
}

QString text(const Report &report)
{
    QString out = bench::toTable(report.rows) + QLatin1Char('\n');
    for (const CudaFact &f : report.facts)
        out += QStringLiteral("%1  %2  %3 %4\n")
                   .arg(f.name.leftJustified(26), f.painting.leftJustified(26))
                   .arg(f.value, 10, 'f', f.value < 100 ? 3 : 1)
                   .arg(f.unit);
    return out;
}

QByteArray json(const Report &report)
{
    QJsonArray facts;
    for (const CudaFact &f : report.facts)
        facts.append(QJsonObject{{"name", f.name}, {"painting", f.painting}, {"value", f.value}, {"unit", f.unit}});
    const QJsonArray rows = QJsonDocument::fromJson(bench::toJson(report.rows)).array();
    return QJsonDocument(QJsonObject{{"rows", rows}, {"facts", facts}}).toJson();
}

/// Whether a list that may be empty (all) names it.
bool named(const QString &list, const QString &name)
{
    return list.isEmpty() || list.split(QLatin1Char(',')).contains(name);
}

int measure(const QCommandLineParser &parser)
{
    QTextStream out(stdout), error(stderr);
    Options options;
    options.runs = std::max(1, parser.value("runs").toInt());
    options.secondsARow = std::max(0.0, parser.value("seconds").toDouble());
    options.referenceStrokes = std::max(1, parser.value("reference-strokes").toInt());
    options.liveSpread = std::max(1.0, parser.value("live-spread").toDouble());
    Report report;
    bool good = true;
    for (const Group &group : groups())
        for (const QString &painting : group.paintings) {
            if (!named(parser.value("only"), group.name) || !named(parser.value("paintings"), painting))
                continue;
            const Result<CudaCase> c = caseOf(painting);
            const Result<void> taken = c ? group.take(*c, options, report) : Result<void>(Error{c.error()});
            if (!taken) {
                error << "bench_cuda: " << group.name << ", " << painting << ": " << taken.error() << Qt::endl;
                good = false;
            }
        }
    out << (parser.isSet("json") ? QString::fromUtf8(json(report)) : text(report));
    return good ? 0 : 1;
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.setApplicationDescription("Times the CUDA renderer and the paper's kernels on the same device, and compares "
                                     "its pictures with the CPU renderer's and the reference's.");
    parser.addHelpOption();
    parser.addOptions(
        {{"json", "Prints an object with rows and facts."},
         {"only", "Groups, with commas between: full, edits, fills, live, cpu, repeats, reference, several.", "GROUPS"},
         {"paintings", "figure11f, figure11f-2880, spread-32-72, million; samples, as ink-landscape-1024.", "NAMES"},
         {"samples", "The samples' folder.", "FOLDER", samplesFolder()},
         {"runs", "Runs a row.", "N", "101"},
         {"seconds", "A row of the paper's kernels ends after so long.", "S", "10"},
         {"live-spread", "Spread of the live stroke when dry, in pixels.", "PX", "48.75"},
         {"reference-strokes", "Strokes that the reference draws.", "N", "100"}});
    parser.process(app);
    samplesFolder() = parser.value("samples");
    RendererOptions cuda;
    cuda.backend = Backend::Cuda;
    if (const Result<std::unique_ptr<Renderer>> renderer = makeRenderer(cuda); !renderer) {
        QTextStream(stdout) << "bench_cuda: skipped: " << renderer.error() << Qt::endl;
        return 0;
    }
    return measure(parser);
}
