// The CUDA renderer, the paper's kernels on the same device, the CPU renderer and the reference, in one run.
#include "model/document/timelapse.h"
#include "model/formats/files.h"
#include "render/backends.h"
#include "render/bench/plan.h"
#include "render/compare.h"
#include "render/sequence.h"
#include "tests/bench/cuda/paper_scene.h"
#include "tests/bench/filled_shapes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

using namespace suffuse;

namespace {

/// What is no time: operations a second, frames a second, differences.
struct Fact {
    QString name;
    QString painting;
    double value = 0;
    QString unit;
};

struct Report {
    std::vector<bench::Row> rows;
    std::vector<Fact> facts;
};

struct Options {
    int runs = 101;
    double secondsARow = 10;
    int referenceStrokes = 100;
    double liveSpread = 48.75; ///< s of the live stroke when dry, px: figure 11f's mean, as much larger as the picture
};

/// A painting and the width that it is drawn at.
struct Case {
    QString name;
    bench::PaintingOptions painting;
    int width = 1024;
    QString sample; ///< a file of the samples' folder, instead of a generated painting
};

/// The samples that come with the program; each is drawn at the widths below.
const QStringList samples{"ink-landscape", "still-life", "flat", "moonrise", "lanterns", "sheet"};
constexpr int sampleWidths[] = {512, 1024, 2048};

std::vector<Case> cases()
{
    bench::PaintingOptions wide, million;
    wide.spreadLow = 32;
    wide.spreadHigh = 72;
    million.strokes = 1'000'000 / 23;
    million.segments = 1'000'000;
    million.width = 3840;
    million.height = 2160;
    std::vector<Case> all{{"figure11f", {}, 1024, {}},
                          {"figure11f-2880", {}, 2880, {}},
                          {"spread-32-72", wide, 1024, {}},
                          {"million", million, 3840, {}}};
    for (const QString &sample : samples)
        for (const int width : sampleWidths)
            all.push_back({QStringLiteral("%1-%2").arg(sample).arg(width), {}, width, sample});
    return all;
}

/// The paintings that `fills` makes.
const QStringList filledCases{"shapes-1000", "shapes-1000-crisp", "disc-8", "disc-100", "coast-100000"};

/// The names of the samples' cases.
QStringList sampleCases()
{
    QStringList names;
    for (const Case &c : cases())
        if (!c.sample.isEmpty())
            names << c.name;
    return names;
}

Result<Case> caseOf(const QString &name)
{
    for (const Case &c : cases())
        if (c.name == name)
            return c;
    if (filledCases.contains(name))
        return Case{name, {}, 1024, {}};
    return Error{QStringLiteral("there is no painting %1").arg(name)};
}

/// Where `--samples` says that the samples lie.
QString &samplesFolder()
{
    static QString folder = QStringLiteral("packaging/samples");
    return folder;
}

Result<PaintingPtr> paintingOf(const Case &c)
{
    if (c.sample.isEmpty())
        return std::make_shared<const Painting>(bench::makePainting(c.painting));
    Result<LoadedDocument> loaded = loadDocument(QStringLiteral("%1/%2.suffuse").arg(samplesFolder(), c.sample));
    if (!loaded)
        return Error{loaded.error()};
    return std::make_shared<const Painting>(std::move(loaded->painting));
}

bench::Job jobOf(const Case &c, const PaintingPtr &painting, Backend backend, int runs)
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

Result<void> fullRenders(const Case &c, const Options &options, Report &report)
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

Result<void> edits(const Case &c, const Options &options, Report &report)
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
    Case c{"figure11f-3840", {}, 3840, {}};
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

Result<void> againstCpu(const Case &c, const Options &, Report &report)
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
Result<void> fills(const Case &c, const Options &options, Report &report)
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
Result<void> againstReference(Case c, const Options &options, Report &report)
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
Result<void> repeats(const Case &c, const Options &options, Report &report)
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

double secondsSince(const QElapsedTimer &timer)
{
    return double(timer.nsecsElapsed()) * 1e-9;
}

/// A picture of 32768 × 24576 pixels, which no memory need hold, in 48 parts that the devices take one after another;
/// seconds from ready devices to the last part, as 8 bits in memory.
Result<double> inParts(const std::vector<std::unique_ptr<Renderer>> &renderers, const PaintingPtr &painting)
{
    constexpr int columns = 8, rows = 6, side = 4096;
    const Rect all = painting->canvas.area();
    std::atomic<int> next = 0;
    std::mutex mutex;
    QString error;
    const auto draw = [&](Renderer &renderer) {
        Picture8 part;
        for (int i = next++; i < columns * rows; i = next++) {
            const double width = all.width() / columns, height = all.height() / rows;
            RenderRequest request;
            request.painting = painting;
            request.time = painting->end();
            request.view = View::ofArea(
                Rect::of(all.left + i % columns * width, all.top + i / columns * height, width, height), side, side);
            if (const auto stats = renderer.render(request, part); !stats || !renderer.notice().isEmpty()) {
                const std::lock_guard lock(mutex);
                error = stats ? renderer.notice() : stats.error();
            }
        }
    };
    QElapsedTimer timer;
    timer.start();
    {
        std::vector<std::jthread> threads;
        for (const auto &renderer : renderers)
            threads.emplace_back([&] { draw(*renderer); });
    }
    return error.isEmpty() ? Result<double>(secondsSince(timer)) : Error{error};
}

/// 300 frames of 1920 × 1440 pixels; seconds from ready devices to the last frame, each as 8 bits in memory.
Result<double> film(const std::vector<std::unique_ptr<Renderer>> &renderers, const PaintingPtr &painting)
{
    RenderRequest request;
    request.painting = painting;
    request.view = View::ofArea(painting->canvas.area(), 1920, 1440);
    QElapsedTimer timer;
    timer.start();
    const auto drawn = renderSequence(renderers, request, timelapseMoments(*painting, {300, 0.5}), 0,
                                      [](std::size_t, const FloatPicture &frame) {
                                          thread_local Picture8 raw;
                                          if (raw.width != frame.width)
                                              raw.resize(frame.width, frame.height);
                                          raw.store({0, 0, frame.width, frame.height}, frame.at(0, 0), frame.width);
                                          return Result<void>();
                                      });
    return drawn ? Result<double>(secondsSince(timer)) : Error{drawn.error()};
}

/// The same by one device and by all, in turn, after a first time that is not counted; medians.
Result<void> onSeveral(const QString &name,
                       const std::function<Result<double>(const std::vector<std::unique_ptr<Renderer>> &)> &take,
                       const Options &options, const Case &c, Report &report)
{
    std::vector<std::vector<std::unique_ptr<Renderer>>> made;
    for (const int devices : {1, allDevices}) {
        RendererOptions cuda;
        cuda.backend = Backend::Cuda;
        cuda.devices = devices;
        auto renderers = makeRenderers(cuda);
        if (!renderers)
            return Error{renderers.error()};
        made.push_back(std::move(*renderers));
    }
    std::map<std::size_t, std::vector<double>> seconds;
    for (int run = -1; run < std::min(options.runs, 9); ++run)
        for (const auto &renderers : made) {
            const Result<double> took = take(renderers);
            if (!took)
                return Error{took.error()};
            if (run >= 0)
                seconds[renderers.size()].push_back(*took);
        }
    for (auto &[devices, times] : seconds)
        report.facts.push_back(
            {QStringLiteral("%1-%2-devices").arg(name).arg(devices), c.name, bench::timingOf(times).medianMs, "s"});
    return {};
}

Result<void> several(const Case &c, const Options &options, Report &report)
{
    const Result<PaintingPtr> painting = paintingOf(c);
    if (!painting)
        return Error{painting.error()};
    if (const Result<void> taken = onSeveral(
            "32768x24576-in-parts", [&](const auto &renderers) { return inParts(renderers, *painting); }, options, c,
            report);
        !taken)
        return taken;
    return onSeveral(
        "film", [&](const auto &renderers) { return film(renderers, *painting); }, options, c, report);
}

struct Group {
    const char *name;
    std::function<Result<void>(const Case &, const Options &, Report &)> take;
    QStringList paintings;
};

std::vector<Group> groups()
{
    const QStringList all{"figure11f", "figure11f-2880", "spread-32-72", "million"};
    const QStringList withSamples = sampleCases() + all;
    return {{"full", fullRenders, withSamples},
            {"edits", edits, {"figure11f"}},
            {"fills", fills, filledCases},
            {"live", [](const Case &, const Options &o, Report &r) { return liveStrokes(o, r); }, {"figure11f"}},
            {"cpu", againstCpu, sampleCases() + QStringList{"figure11f", "figure11f-2880", "spread-32-72"}},
            {"repeats", repeats, {"figure11f", "ink-landscape-1024", "still-life-512"}},
            {"reference", againstReference, {"figure11f", "spread-32-72"}},
            {"several", several, {"figure11f", "still-life-1024"}}};
}

QString text(const Report &report)
{
    QString out = bench::toTable(report.rows) + QLatin1Char('\n');
    for (const Fact &f : report.facts)
        out += QStringLiteral("%1  %2  %3 %4\n")
                   .arg(f.name.leftJustified(26), f.painting.leftJustified(26))
                   .arg(f.value, 10, 'f', f.value < 100 ? 3 : 1)
                   .arg(f.unit);
    return out;
}

QByteArray json(const Report &report)
{
    QJsonArray facts;
    for (const Fact &f : report.facts)
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
            const Result<Case> c = caseOf(painting);
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
