#include "app/cli/fit_options.h"
#include "app/cli/progress.h"
#include "app/cli/stroke_choice.h"
#include "model/formats/files.h"
#include "render/backends.h"
#include "render/fitting/fitting.h"
#include "render/refit/refit_target.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonArray>

#include <cmath>
#include <new>

namespace suffuse::cli {

namespace {

using namespace refit;

constexpr int mostRefitStrokes = 20'000;
constexpr int fewestTried = 4; ///< strokes, where an error is asked for
constexpr int fewerBy = 4;     ///< Unless it is said how many, that many strokes become one.

struct RefitRequest {
    fitting::FitOptions options; ///< strokes: 0 unless they are given
    int pixels = fitting::usualFitPixels;
};

void addRefitOptions(CommandLine &line)
{
    const auto add = [&line](const QStringList &names, const char *text, const QString &value = {}) {
        line.add(names, QCoreApplication::translate("Cli", text), value);
    };
    add({"o", "output"}, QT_TRANSLATE_NOOP("Cli", "The painting to write: .suffuse or .json."), "OUT");
    add({"select"},
        QT_TRANSLATE_NOOP("Cli", "The strokes to make anew, by their ids, such as 3,7,20-180 (default: all)."), "IDS");
    add({"layer"}, QT_TRANSLATE_NOOP("Cli", "All strokes of the group of that name, in place of --select."), "NAME");
    add({"to"},
        QT_TRANSLATE_NOOP("Cli",
                          "A picture, or another painting, that the whole is to look like (default: as it does)."),
        "FILE");
    add({"strokes"}, QT_TRANSLATE_NOOP("Cli", "At most so many strokes (default: a quarter of those before)."), "N");
    add({"error"}, QT_TRANSLATE_NOOP("Cli", "As many strokes as this root mean square error needs, in 255ths."), "E");
    add({"style"}, QT_TRANSLATE_NOOP("Cli", "feathering (default), uniform or edge."), "STYLE");
    add({"iterations"}, QT_TRANSLATE_NOOP("Cli", "How many steps (default 1200)."), "N");
    add({"pixels"}, QT_TRANSLATE_NOOP("Cli", "What the strokes reach is fitted at so many pixels (default 600000)."),
        "N");
    add({"seed"}, QT_TRANSLATE_NOOP("Cli", "Other numbers give other strokes (default 1)."), "N");
    add({"threads"}, QT_TRANSLATE_NOOP("Cli", "Number of threads (default: one a core)."), "N");
    add({"json"}, QT_TRANSLATE_NOOP("Cli", "Says how near the painting comes as JSON (docs/cli.md)."));
}

QString refitContradiction(const CommandLine &line)
{
    const QString in = line.argument(0), out = line.value("output");
    if (out.isEmpty())
        return QCoreApplication::translate("Cli", "-o OUT is missing: name the painting to write");
    if (formatForSaving(out) == FileFormat::Unknown)
        return QCoreApplication::translate("Cli", "%1: unknown ending; use .suffuse or .json").arg(out);
    if (isSameFile(in, out) || isSameFile(line.value("to"), out))
        return inputWouldBeLost(out);
    if (line.isSet("select") && line.isSet("layer"))
        return QCoreApplication::translate("Cli", "--select and --layer both say which strokes; give one of them");
    return {};
}

Result<RefitRequest> refitRequestOf(const CommandLine &line)
{
    const Result<StyleKind> style = styleOf(line);
    if (!style)
        return Error{style.error()};
    const Result<double> strokes = numberOf(line, "strokes", 0, {1, double(mostRefitStrokes), true});
    const Result<double> error = numberOf(line, "error", 0, {0.1, 255, false});
    const Result<double> steps = numberOf(line, "iterations", fitting::usualFitSteps, {1, 1e6, true});
    const Result<double> pixels = numberOf(line, "pixels", fitting::usualFitPixels, {1, 1e7, true});
    const Result<double> seed = numberOf(line, "seed", 1, {0, 4294967295.0, true});
    const Result<double> threads = numberOf(line, "threads", 0, {1, 1024, true});
    for (const Result<double> *value : {&strokes, &error, &steps, &pixels, &seed, &threads})
        if (!*value)
            return Error{value->error()};
    RefitRequest out;
    out.options.strokes = int(*strokes);
    out.options.error = *error / 255;
    out.options.steps = int(*steps);
    out.options.limits.style = *style;
    out.options.seed = std::uint64_t(*seed);
    out.options.threads = int(*threads);
    out.pixels = int(*pixels);
    return out;
}

/// The strokes of the group of that name, and of the groups within it. The error is a usage error.
Result<std::unordered_set<StrokeId>> strokesOfLayer(const QString &name, const Painting &painting)
{
    const Result<GroupId> layer = layerNamed(name, painting);
    if (!layer)
        return Error{layer.error()};
    std::unordered_set<StrokeId> out;
    for (const StrokePtr &stroke : painting.strokes)
        for (const Group *g = painting.findGroup(stroke->group); g; g = painting.findGroup(g->parent))
            if (g->id == *layer)
                out.insert(stroke->id);
    return out;
}

Result<std::unordered_set<StrokeId>> chosenStrokes(const CommandLine &line, const Painting &painting)
{
    if (line.isSet("select"))
        return strokesNamed(line.value("select"), painting);
    if (line.isSet("layer"))
        return strokesOfLayer(line.value("layer"), painting);
    std::unordered_set<StrokeId> out;
    for (const StrokePtr &stroke : painting.strokes)
        out.insert(stroke->id);
    return out;
}

Result<RefitGoal> goalOf(const CommandLine &line)
{
    RefitGoal goal;
    if (!line.isSet("to"))
        return goal;
    goal.name = line.value("to");
    const Result<QByteArray> bytes = bytesOf(goal.name);
    if (!bytes)
        return Error{bytes.error()};
    if (const FileFormat format = detectFormat(*bytes); format == FileFormat::Suffuse || format == FileFormat::Text) {
        Result<Painting> painting = paintingOf(goal.name);
        if (!painting)
            return Error{painting.error()};
        goal.painting = std::make_shared<const Painting>(std::move(*painting));
    } else if (bytes->isEmpty()) {
        return Error{QCoreApplication::translate("Cli", "%1: is empty").arg(goal.name)};
    } else {
        goal.picture = *bytes;
    }
    return goal;
}

/// What is said of a refit when it is done.
struct RefitReport {
    std::size_t before = 0, now = 0, between = 0;
    Rect area;
    RefitPictures::Difference was, is; ///< from the goal
    int steps = 0;
    std::uint64_t seed = 0;
    double seconds = 0;
};

int sayReport(const RefitReport &report, bool asJson)
{
    const auto numbers = [](const RefitPictures::Difference &d) {
        return QJsonObject{{"rootMeanSquare", d.rootMeanSquare}, {"greatest", d.greatest}};
    };
    if (asJson)
        return printJson(
            {{"strokesBefore", qint64(report.before)},
             {"strokes", qint64(report.now)},
             {"numbers", qint64(report.now * std::size_t(fitting::strokeNumbers))},
             {"between", qint64(report.between)},
             {"area", QJsonArray{report.area.left, report.area.top, report.area.width(), report.area.height()}},
             {"errorBefore", numbers(report.was)},
             {"error", numbers(report.is)},
             {"iterations", report.steps},
             {"seed", qint64(report.seed)},
             {"seconds", report.seconds}});
    QString text =
        QCoreApplication::translate("Cli", "%1 strokes in place of %2. Where they are seen, the picture is %3 of "
                                           "255 from what it should be (root mean square), %4 at most.")
            .arg(report.now)
            .arg(report.before)
            .arg(report.is.rootMeanSquare, 0, 'f', 2)
            .arg(report.is.greatest, 0, 'f', 1);
    if (report.was.greatest > 0)
        text += QLatin1Char(' ') + QCoreApplication::translate("Cli", "Before it was %1, %2 at most.")
                                       .arg(report.was.rootMeanSquare, 0, 'f', 2)
                                       .arg(report.was.greatest, 0, 'f', 1);
    if (report.between > 0)
        text +=
            QLatin1Char(' ') + QCoreApplication::translate("Cli", "%n stroke(s) that lay between them lie below now.",
                                                           nullptr, int(report.between));
    return print(text + QLatin1Char('\n'));
}

/// The fit at its end, or where it was interrupted. Where an error is asked for, the number of strokes grows by half at
/// a time, each time to the end of a fit, since errors are far greater on the way there.
std::unique_ptr<fitting::Fitting> fitOf(const fitting::FitTarget &target, const fitting::FitOptions &options)
{
    fitting::FitOptions some = options;
    some.error = 0;
    some.strokes = options.error > 0 ? std::min(fewestTried, options.strokes) : options.strokes;
    std::unique_ptr<fitting::Fitting> fit;
    while (true) {
        fit = fit ? std::make_unique<fitting::Fitting>(target, some, fit->strokes())
                  : std::make_unique<fitting::Fitting>(target, some);
        fit->stopWith(&interrupted());
        {
            ProgressLine progress(QCoreApplication::translate("Cli", "fitting"), true);
            while (!interrupted() && fit->step())
                progress.show(qint64(1000 * fit->progress()), 1000);
        }
        if (interrupted() || some.strokes >= options.strokes || std::sqrt(fit->meanSquareError()) <= options.error)
            return fit;
        some.strokes = std::min(some.strokes + (some.strokes + 1) / 2, options.strokes);
    }
}

int refitPainting(const CommandLine &line, const RefitRequest &request)
{
    QElapsedTimer clock;
    clock.start();
    const QString stopped = QCoreApplication::translate("Cli", "stopped; nothing was written");
    const auto problem = [&](const QString &error) { return fail(interrupted() ? stopped : error); };
    const QString out = line.value("output");
    if (const QString why = problemOfOut(out); !why.isEmpty())
        return fail(why);
    const Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<std::unordered_set<StrokeId>> ids = chosenStrokes(line, *painting);
    if (!ids)
        return failUsage("refit", ids.error());
    const Result<RefitGoal> goal = goalOf(line);
    if (!goal)
        return fail(goal.error());
    const Result<RefitScope> scope = RefitScope::of(std::make_shared<const Painting>(*painting), *ids);
    if (!scope)
        return fail(scope.error());
    const Result<std::unique_ptr<Renderer>> renderer =
        makeRenderer({.backend = Backend::Cpu, .threads = request.options.threads});
    if (!renderer)
        return fail(renderer.error());
    const RefitPictures pictures(*scope, *goal, **renderer, request.pixels, &interrupted());
    Result<fitting::FitTarget> target = pictures.target();
    if (!target)
        return problem(target.error());
    fitting::FitOptions options = request.options;
    const int count = int(std::min(scope->count(), std::size_t(mostRefitStrokes)));
    if (options.strokes == 0)
        options.strokes = options.error > 0 ? count : std::max(1, count / fewerBy);
    const std::unique_ptr<fitting::Fitting> fit = fitOf(*target, options);
    if (interrupted())
        return fail(stopped);
    const StrokeList strokes = placed(*scope, fit->painting());
    const Painting result = scope->with(strokes);
    RefitReport report{scope->count(),
                       strokes.size(),
                       scope->between(),
                       areaWith(*scope, strokes),
                       {},
                       {},
                       fit->steps(),
                       options.seed,
                       0};
    const Result<RefitPictures::Difference> was = pictures.differenceOf(*painting, report.area),
                                            is = pictures.differenceOf(result, report.area);
    if (!was || !is)
        return problem(was ? is.error() : was.error());
    report.was = *was, report.is = *is;
    if (const Result<void> saved = saveDocument(result, {}, out); !saved)
        return fail(saved.error());
    report.seconds = double(clock.elapsed()) * 1e-3;
    return sayReport(report, line.isSet("json"));
}

} // namespace

int refitCommand(const QStringList &arguments)
{
    CommandLine line("refit",
                     QCoreApplication::translate("Cli",
                                                 "Makes fewer strokes that look like those of a painting, or makes "
                                                 "them look like a picture, and says how near they come."),
                     {"IN"});
    addRefitOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (const QString problem = refitContradiction(line); !problem.isEmpty())
        return failUsage("refit", problem);
    const Result<RefitRequest> request = refitRequestOf(line);
    if (!request)
        return failUsage("refit", request.error());
    try {
        return refitPainting(line, *request);
    } catch (const std::bad_alloc &) {
        return fail(QCoreApplication::translate("Cli", "there is not enough memory to fit %1. Choose fewer --pixels.")
                        .arg(line.argument(0)));
    }
}

} // namespace suffuse::cli
