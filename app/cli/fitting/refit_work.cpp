#include "app/cli/fitting/refit_work.h"

#include "app/cli/fitting/fit_options.h"
#include "app/cli/stroke_choice.h"
#include "model/formats/files.h"
#include "render/backends.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse::cli {

using namespace refit;

namespace {

constexpr int mostRefitStrokes = 20'000;
constexpr int fewestTried = 4; ///< strokes, where an error is asked for
constexpr int fewerBy = 4;     ///< Unless it is said how many, that many strokes become one.

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

/// The fit at its end, or where it was interrupted. Where an error is asked for, the number of strokes grows by half at
/// a time, each time to the end of a fit, since errors are far greater on the way there.
std::unique_ptr<fitting::Fitting> fitOf(const fitting::FitTarget &target, const fitting::FitOptions &options,
                                       const std::atomic<bool> &cancel, const std::function<void(double)> &progress)
{
    fitting::FitOptions some = options;
    some.error = 0;
    some.strokes = options.error > 0 ? std::min(fewestTried, options.strokes) : options.strokes;
    std::unique_ptr<fitting::Fitting> fit;
    while (true) {
        fit = fit ? std::make_unique<fitting::Fitting>(target, some, fit->strokes())
                  : std::make_unique<fitting::Fitting>(target, some);
        fit->stopWith(&cancel);
        while (!cancel && fit->step())
            progress(fit->progress());
        if (cancel || some.strokes >= options.strokes || std::sqrt(fit->meanSquareError()) <= options.error)
            return fit;
        some.strokes = std::min(some.strokes + (some.strokes + 1) / 2, options.strokes);
    }
}

} // namespace

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
    const Result<QByteArray> bytes = inputBytes(goal.name);
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

Result<Refitted> refitted(const PaintingPtr &painting, const std::unordered_set<StrokeId> &ids, const RefitGoal &goal,
                          const RefitRequest &request, const std::atomic<bool> &cancel,
                          const std::function<void(double)> &progress)
{
    const Result<RefitScope> scope = RefitScope::of(painting, ids);
    if (!scope)
        return Error{scope.error()};
    const Result<std::unique_ptr<Renderer>> renderer =
        makeRenderer({.backend = Backend::Cpu, .threads = request.options.threads});
    if (!renderer)
        return Error{renderer.error()};
    const RefitPictures pictures(*scope, goal, **renderer, request.pixels, &cancel);
    const Result<fitting::FitTarget> target = pictures.target();
    if (!target)
        return Error{target.error()};
    fitting::FitOptions options = request.options;
    const int count = int(std::min(scope->count(), std::size_t(mostRefitStrokes)));
    if (options.strokes == 0)
        options.strokes = options.error > 0 ? count : std::max(1, count / fewerBy);
    const std::unique_ptr<fitting::Fitting> fit = fitOf(*target, options, cancel, progress);
    if (cancel)
        return Error{};
    const StrokeList strokes = placed(*scope, fit->painting());
    Refitted out{scope->with(strokes), {}};
    out.report = {scope->count(),
                  strokes.size(),
                  scope->between(),
                  areaWith(*scope, strokes),
                  {},
                  {},
                  fit->steps(),
                  options.seed,
                  0,
                  goal.name,
                  255 * options.error,
                  255 * std::sqrt(fit->meanSquareError())};
    const Result<RefitPictures::Difference> was = pictures.differenceOf(*painting, out.report.area),
                                            is = pictures.differenceOf(out.painting, out.report.area);
    if (!was || !is)
        return Error{was ? is.error() : was.error()};
    out.report.was = *was, out.report.is = *is;
    return out;
}

} // namespace suffuse::cli
