// Fewer strokes in place of many.
#include "app/python/pictures.h"
#include "app/python/pixels.h"
#include "app/python/views.h"

#include "app/cli/fitting/refit_work.h"
#include "render/image_io/image_io.h"

#include <QFile>

namespace suffuse::python {

namespace {

/// The goal that `to` is: a painting, an array, or the path of either; None: as it looks.
refit::RefitGoal goalOf(const py::object &to)
{
    refit::RefitGoal goal;
    if (to.is_none())
        return goal;
    goal.name = QStringLiteral("to");
    if (py::isinstance<PaintingValue>(to)) {
        goal.painting = to.cast<const PaintingValue &>().painting;
        return goal;
    }
    if (py::isinstance<py::array>(to)) {
        const auto pixels = to.cast<py::array>();
        if (pixels.ndim() != 3 || (pixels.shape(2) != 3 && pixels.shape(2) != 4) || pixels.size() == 0)
            raise(Raised::Value, QStringLiteral("to: give it the shape (height, width, 3 or 4)"));
        const FloatPicture picture = pictureOf(pixels);
        ImageOptions options;
        options.alpha = pixels.shape(2) == 4;
        options.depth = whiteOf(pixels, "to") == 255 ? ImageDepth::Bits8 : ImageDepth::Bits16;
        options.quick = true;
        goal.picture = valueOf(encodeImage(ImageFormat::Png, picture, options, goal.name), Raised::Value);
        return goal;
    }
    const QString name = pathOf(to);
    if (QFile file(name); !file.open(QIODevice::ReadOnly))
        raise(Raised::File, QStringLiteral("%1: %2").arg(name, file.errorString()));
    Asked asked("refit", {"to"});
    asked.set("to", name);
    return valueOf(cli::goalOf(asked.line()), Raised::Value);
}

/// The ids of the strokes that are made anew.
std::unordered_set<StrokeId> chosen(const std::optional<std::vector<StrokeId>> &select, const py::object &layer,
                                    const Painting &painting)
{
    if (select && !layer.is_none())
        raise(Raised::Value, QStringLiteral("select and layer both say which strokes; give one of them"));
    if (select && select->empty())
        return {};
    Asked asked("refit", {"select", "layer"});
    if (select) {
        QStringList ids;
        for (const StrokeId id : *select)
            ids.append(QString::number(id));
        asked.set("select", ids.join(QLatin1Char(',')));
    }
    asked.set("layer", layer);
    return valueOf(cli::chosenStrokes(asked.line(), painting), Raised::Value);
}

py::dict numbersOf(const refit::RefitPictures::Difference &difference)
{
    py::dict out;
    out["root_mean_square"] = difference.rootMeanSquare;
    out["greatest"] = difference.greatest;
    return out;
}

py::dict reportOf(const cli::RefitReport &report)
{
    py::dict out;
    out["strokes_before"] = report.before;
    out["strokes"] = report.now;
    out["between"] = report.between;
    out["area"] = py::make_tuple(report.area.left, report.area.top, report.area.width(), report.area.height());
    out["error_before"] = numbersOf(report.was);
    out["error"] = numbersOf(report.is);
    out["steps"] = report.steps;
    out["worse"] = report.isWorse();
    out["reached"] = !report.isTooFar();
    return out;
}

} // namespace

void addRefits(py::module_ &module)
{
    using namespace py::literals;
    module.def(
        "refit",
        [](const PaintingValue &painting, const std::optional<std::vector<StrokeId>> &select, const py::object &layer,
           const py::object &to, const py::object &strokes, const py::object &error, const py::object &steps,
           const QString &style, const py::object &pixels, const py::object &seed, int threads,
           const py::object &progress) {
            Asked asked("refit", {"strokes", "error", "iterations", "style", "pixels", "seed", "threads"});
            asked.set("strokes", strokes);
            asked.set("error", error);
            asked.set("iterations", steps);
            asked.set("style", style);
            asked.set("pixels", pixels);
            asked.set("seed", seed);
            if (threads != 0)
                asked.set("threads", QString::number(threads));
            Result<cli::RefitRequest> request = cli::refitRequestOf(asked.line());
            if (!request)
                raise(Raised::Value, QString(request.error()).replace(QLatin1String("--iterations"), QLatin1String("steps")));
            const std::unordered_set<StrokeId> ids = chosen(select, layer, *painting.painting);
            const refit::RefitGoal goal = goalOf(to);
            WorkShare share(progress);
            Result<cli::Refitted> made = Error{};
            withoutLock(
                [&](std::atomic<bool> &cancel) {
                    made = cli::refitted(painting.painting, ids, goal, *request, cancel,
                                         [&](double done) { share.set(done); });
                },
                share.teller());
            cli::Refitted refitted = valueOf(std::move(made), Raised::Value);
            auto result = std::make_shared<const Painting>(std::move(refitted.painting));
            return py::make_tuple(derivedFrom(painting, std::move(result)), reportOf(refitted.report));
        },
        "painting"_a, py::kw_only(), "select"_a = py::none(), "layer"_a = py::none(), "to"_a = py::none(),
        "strokes"_a = py::none(), "error"_a = py::none(), "steps"_a = fitting::usualFitSteps,
        "style"_a = "feathering", "pixels"_a = fitting::usualFitPixels, "seed"_a = 1, "threads"_a = 0,
        "progress"_a = py::none());
}

} // namespace suffuse::python
