#include "app/cli/pictures/bench_command.h"

#include "app/cli/options.h"
#include "render/backends.h"
#include "render/bench/plan.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cstdio>
#include <map>

#include <unistd.h>

namespace suffuse::cli {

namespace {

struct OptionText {
    const char *name;
    const char *value; ///< its name in the help; null: a switch
    const char *description;
};

constexpr OptionText options[] = {
    {"json", nullptr, QT_TRANSLATE_NOOP("Cli", "Prints the rows as a JSON array.")},
    {"painting", "FILE",
     QT_TRANSLATE_NOOP("Cli", "Measures on this document instead of a generated painting of figure 11f's size.")},
    {"backend", "BACKEND", QT_TRANSLATE_NOOP("Cli", "auto, cpu, cuda or reference.")},
    {"devices", "all", QT_TRANSLATE_NOOP("Cli", "all: every backend that can run here, one after the other.")},
    {"threads", "N[,N]",
     QT_TRANSLATE_NOOP("Cli", "Numbers of threads; several: full renders with each (default: 1, and one a core).")},
    {"size", "WxH",
     QT_TRANSLATE_NOOP("Cli", "Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).")},
    {"only", "NAMES", QT_TRANSLATE_NOOP("Cli", "Names of rows, with commas between: takes these only.")},
    {"runs", "N", QT_TRANSLATE_NOOP("Cli", "Runs a row (default: 9).")},
    {"table2", nullptr, QT_TRANSLATE_NOOP("Cli", "Full renders of all thirteen sizes of the paper's Table 2 too.")},
    {"spread", "LO HI", QT_TRANSLATE_NOOP("Cli", "Range of the generated strokes' spread, in units (default: 6 20).")},
    {"segments", "N[,N]", QT_TRANSLATE_NOOP("Cli", "Segments of the growth rows (default: 1000,10000,100000).")},
    {"long", nullptr, QT_TRANSLATE_NOOP("Cli", "A growth row of 1000000 segments too.")},
    {"width", "UNITS", QT_TRANSLATE_NOOP("Cli", "Width of the generated painting's canvas (default: 1024).")},
    {"height", "UNITS", QT_TRANSLATE_NOOP("Cli", "Height of the generated painting's canvas (default: 768).")},
    {"unit", "F", QT_TRANSLATE_NOOP("Cli", "Scale of the generated strokes (default: width / 1024).")},
};

void addBenchOptions(CommandLine &line)
{
    for (const OptionText &o : options)
        line.add({QLatin1String(o.name)}, QCoreApplication::translate("Cli", o.description), QLatin1String(o.value));
}

/// "--spread 6 20" as one value, "--spread 6,20", for a parser whose options have one value.
QStringList withJoinedSpread(QStringList arguments)
{
    const qsizetype at = arguments.indexOf(QStringLiteral("--spread"));
    if (at >= 0 && at + 2 < arguments.size() && toNumber(arguments.at(at + 1)) && toNumber(arguments.at(at + 2))) {
        arguments[at + 1] += QLatin1Char(',') + arguments.at(at + 2);
        arguments.removeAt(at + 2);
    }
    return arguments;
}

/// A list of whole numbers in a range, e.g. "1,2"; `fallback` where the option is not given.
Result<std::vector<int>> numbers(const CommandLine &line, const QString &option, int least, int most,
                                 std::vector<int> fallback)
{
    if (!line.isSet(option))
        return fallback;
    std::vector<int> out;
    for (const QString &part : line.value(option).split(QLatin1Char(','))) {
        bool ok = false;
        const int v = part.toInt(&ok);
        if (!ok || v < least || v > most)
            return Error{QCoreApplication::translate("Cli", "--%1 %2: give whole numbers from %3 to %4")
                             .arg(option, line.value(option))
                             .arg(least)
                             .arg(most)};
        out.push_back(v);
    }
    return out;
}

/// A number above 0; `value` stays where the option is not given.
Result<void> positive(const CommandLine &line, const QString &option, double most, double &value)
{
    if (!line.isSet(option))
        return {};
    const std::optional<double> v = toNumber(line.value(option));
    if (!v || *v <= 0 || *v > most)
        return Error{QCoreApplication::translate("Cli", "--%1 %2: give a number above 0, at most %3")
                         .arg(option, line.value(option))
                         .arg(most)};
    value = *v;
    return {};
}

Result<void> generatedPainting(const CommandLine &line, bench::PaintingOptions &out)
{
    for (const auto &[option, value] : {std::pair("width", &out.width), std::pair("height", &out.height)})
        if (const Result<void> read = positive(line, QLatin1String(option), 16384, *value); !read)
            return read;
    out.unit = out.width / 1024;
    if (const Result<void> read = positive(line, QStringLiteral("unit"), 1000, out.unit); !read)
        return read;
    if (!line.isSet(QStringLiteral("spread")))
        return {};
    const QStringList parts = line.value(QStringLiteral("spread")).split(QLatin1Char(','));
    const std::optional<double> low = toNumber(parts.value(0)), high = toNumber(parts.value(1));
    if (parts.size() != 2 || !low || !high || *low <= 0 || *high < *low || *high > 1000)
        return Error{QCoreApplication::translate("Cli", "--spread %1: give two numbers, e.g. --spread 6 20")
                         .arg(line.value(QStringLiteral("spread")))};
    out.spreadLow = *low;
    out.spreadHigh = *high;
    return {};
}

/// The backend asked for, or all that can run here but the reference.
Result<std::vector<RendererOptions>> devices(const CommandLine &line)
{
    RendererOptions device;
    if (!line.isSet(QStringLiteral("devices"))) {
        static const std::map<QString, Backend> names = {
            {"auto", Backend::Auto}, {"cpu", Backend::Cpu}, {"cuda", Backend::Cuda}, {"reference", Backend::Reference}};
        const QString name = line.isSet(QStringLiteral("backend")) ? line.value(QStringLiteral("backend")) : "auto";
        const auto backend = names.find(name);
        if (backend == names.end())
            return Error{
                QCoreApplication::translate("Cli", "--backend %1: give auto, cpu, cuda or reference").arg(name)};
        device.backend = backend->second;
        return std::vector{device};
    }
    if (line.value(QStringLiteral("devices")) != QLatin1String("all"))
        return Error{QCoreApplication::translate("Cli", "--devices %1: give all, or leave it out")
                         .arg(line.value(QStringLiteral("devices")))};
    std::vector<RendererOptions> out;
    for (Backend backend : {Backend::Cpu, Backend::Cuda}) {
        device.backend = backend;
        if (makeRenderer(device))
            out.push_back(device);
    }
    return out;
}

Result<void> rowsAndGrowth(const CommandLine &line, bench::Plan &plan)
{
    if (line.isSet(QStringLiteral("only"))) {
        plan.only = line.value(QStringLiteral("only")).split(QLatin1Char(','), Qt::SkipEmptyParts);
        for (const QString &name : plan.only)
            if (!bench::rowNames().contains(name))
                return Error{QCoreApplication::translate("Cli", "--only %1: the rows are %2")
                                 .arg(name, bench::rowNames().join(QStringLiteral(", ")))};
    }
    const Result<std::vector<int>> runs = numbers(line, QStringLiteral("runs"), 1, 1000, {9});
    Result<std::vector<int>> growth =
        numbers(line, QStringLiteral("segments"), 23, 10'000'000, {1000, 10'000, 100'000});
    if (!runs)
        return Error{runs.error()};
    if (!growth)
        return Error{growth.error()};
    plan.runs = runs->back();
    plan.growth = std::move(*growth);
    if (line.isSet(QStringLiteral("long")))
        plan.growth.push_back(1'000'000);
    plan.table2 = line.isSet(QStringLiteral("table2"));
    return {};
}

/// Everything but the sizes, which need the painting. Errors are usage errors.
Result<bench::Plan> planOf(const CommandLine &line)
{
    bench::Plan plan;
    plan.make = makeRenderer;
    Result<std::vector<RendererOptions>> backends = devices(line);
    if (!backends)
        return Error{backends.error()};
    plan.devices = std::move(*backends);
    Result<std::vector<int>> threads = numbers(line, QStringLiteral("threads"), 1, 1024, {1, 0});
    if (!threads)
        return Error{threads.error()};
    plan.threads = std::move(*threads);
    if (const Result<void> read = generatedPainting(line, plan.generated); !read)
        return Error{read.error()};
    if (const Result<void> read = rowsAndGrowth(line, plan); !read)
        return Error{read.error()};
    plan.cancel = &interrupted();
    return plan;
}

Result<std::vector<int>> widths(const CommandLine &line, const Painting &painting)
{
    const Result<PictureOptions> picture = pictureOptions(line, painting);
    if (!picture)
        return Error{picture.error()};
    std::vector<int> out{picture->width};
    if (!line.isSet(QStringLiteral("size")) && double(picture->width) * picture->height <= 2e6)
        out.push_back(std::max(1, picture->width * 45 / 16)); // 1024 → 2880
    return out;
}

void showProgress(const QString &text)
{
    if (::isatty(STDERR_FILENO)) {
        std::fprintf(stderr, "\r\033[K%s", qPrintable(text));
        std::fflush(stderr);
    }
}

} // namespace

int benchCommand(const QStringList &arguments)
{
    CommandLine line("bench",
                     QCoreApplication::translate("Cli", "Measures how fast this machine draws: the figures of "
                                                        "docs/performance.md."),
                     {});
    addBenchOptions(line);
    if (const std::optional<int> code = line.parse(withJoinedSpread(arguments)))
        return *code;
    Result<bench::Plan> plan = planOf(line);
    if (!plan)
        return failUsage("bench", plan.error());
    Canvas canvas;
    canvas.width = plan->generated.width;
    canvas.height = plan->generated.height;
    if (line.isSet("painting")) {
        Result<Painting> painting = paintingOf(line.value("painting"));
        if (!painting)
            return fail(painting.error());
        canvas = painting->canvas;
        plan->name = QFileInfo(line.value("painting")).completeBaseName();
        plan->painting = std::make_shared<const Painting>(std::move(*painting));
    }
    Painting empty;
    empty.canvas = canvas;
    const Result<std::vector<int>> sizes = widths(line, empty);
    if (!sizes)
        return failUsage("bench", sizes.error());
    plan->widths = *sizes;
    const Result<std::vector<bench::Row>> rows = bench::run(*plan, showProgress);
    showProgress({});
    if (!rows)
        return fail(rows.error());
    return print(line.isSet("json") ? QString::fromUtf8(bench::toJson(*rows)) : bench::toTable(*rows));
}

} // namespace suffuse::cli
