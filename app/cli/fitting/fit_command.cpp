#include "app/cli/fitting/fit_options.h"
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "model/formats/files.h"
#include "render/backends.h"
#include "render/fitting/fitting.h"
#include "render/fitting/picture_metrics.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include <cmath>
#include <memory>
#include <new>

namespace suffuse::cli {

namespace {

using namespace fitting;

/// So many strokes a fit may have where an error is asked for.
constexpr int mostStrokes = 20'000;

void addFitOptions(CommandLine &line)
{
    const auto add = [&line](const QStringList &names, const char *text, const QString &value = {}) {
        line.add(names, QCoreApplication::translate("Cli", text), value);
    };
    add({"o", "output"}, QT_TRANSLATE_NOOP("Cli", "The painting to write: .suffuse or .json."), "OUT");
    add({"strokes"}, QT_TRANSLATE_NOOP("Cli", "At most so many strokes (default 512)."), "N");
    add({"numbers"}, QT_TRANSLATE_NOOP("Cli", "At most so many numbers, 27 for each stroke."), "N");
    add({"error"}, QT_TRANSLATE_NOOP("Cli", "As many strokes as this root mean square error needs, in 255ths."), "E");
    add({"palette"}, QT_TRANSLATE_NOOP("Cli", "So many paints, which become linked swatches."), "K");
    add({"style"}, QT_TRANSLATE_NOOP("Cli", "feathering (default), uniform or edge."), "STYLE");
    add({"least-width"}, QT_TRANSLATE_NOOP("Cli", "No stroke is narrower, pixels of PICTURE."), "W");
    add({"greatest-width"}, QT_TRANSLATE_NOOP("Cli", "No stroke is wider, pixels of PICTURE."), "W");
    add({"mask"}, QT_TRANSLATE_NOOP("Cli", "Another picture, white where PICTURE counts and black where not."), "MASK");
    add({"perceptual"}, QT_TRANSLATE_NOOP("Cli", "The share of the error as people see it, 0 (default) to 1."), "P");
    add({"target"},
        QT_TRANSLATE_NOOP("Cli", "Also writes the picture that is fitted, as it was read, averaged or solved."), "FILE");
    add({"from"}, QT_TRANSLATE_NOOP("Cli", "Goes on with a painting that was fitted before."), "FIT");
    add({"iterations"}, QT_TRANSLATE_NOOP("Cli", "How many steps (default 1200)."), "N");
    add({"pixels"}, QT_TRANSLATE_NOOP("Cli", "PICTURE is averaged down to so many pixels (default 600000)."), "N");
    add({"seed"}, QT_TRANSLATE_NOOP("Cli", "Other numbers give other strokes (default 1)."), "N");
    add({"backend"}, QT_TRANSLATE_NOOP("Cli", "auto (default: a GPU where there is one), cpu or cuda."), "BACKEND");
    add({"threads"}, QT_TRANSLATE_NOOP("Cli", "Number of threads (default: one a core)."), "N");
    add({"json"}, QT_TRANSLATE_NOOP("Cli", "Prints how near the painting comes, as JSON (docs/cli.md)."));
}

/// What the command line asks for. Widths are in pixels of IN until the picture is known.
struct FitRequest {
    FitOptions options;
    Backend backend = Backend::Auto; ///< finds the gradients
    int pixels = usualFitPixels;
};

Result<Backend> backendOf(const CommandLine &line)
{
    const QString name = line.isSet("backend") ? line.value("backend") : QStringLiteral("auto");
    constexpr std::array names = {std::pair("auto", Backend::Auto), std::pair("cpu", Backend::Cpu),
                                  std::pair("cuda", Backend::Cuda)};
    for (const auto &[known, backend] : names)
        if (name == QLatin1String(known))
            return backend;
    return Error{QCoreApplication::translate("Cli", "--backend %1: give auto, cpu or cuda").arg(name)};
}

/// What contradicts itself; empty if nothing does.
QString contradictionIn(const CommandLine &line)
{
    if (line.value("output").isEmpty())
        return QCoreApplication::translate("Cli", "-o OUT is missing: name the painting to write");
    if (formatForSaving(line.value("output")) == FileFormat::Unknown)
        return QCoreApplication::translate("Cli", "%1: unknown ending; use .suffuse or .json")
            .arg(line.value("output"));
    if (line.isSet("strokes") && line.isSet("numbers"))
        return QCoreApplication::translate("Cli", "--strokes and --numbers say the same; give one of them");
    if (line.isSet("target") && imageFormatForPath(line.value("target")) == ImageFormat::Unknown)
        return QCoreApplication::translate("Cli", "--target %1: unknown ending; use one of %2")
            .arg(line.value("target"), imageEndings().join(QStringLiteral(", ")));
    for (const QString &in : {line.argument(0), line.value("mask"), line.value("from")})
        if (isSameFile(in, line.value("target")))
            return inputWouldBeLost(line.value("target"));
    if (line.isSet("style") && line.isSet("from"))
        return QCoreApplication::translate("Cli", "--style goes without --from, whose strokes have a style already");
    return {};
}

Result<FitRequest> requestOf(const CommandLine &line)
{
    const bool byError = line.isSet("error");
    const Result<StyleKind> style = styleOf(line);
    if (!style)
        return Error{style.error()};
    const Result<Backend> backend = backendOf(line);
    if (!backend)
        return Error{backend.error()};
    const Result<double> strokes =
        line.isSet("numbers") ? numberOf(line, "numbers", 0, {double(strokeNumbers), 1e6, true})
                              : numberOf(line, "strokes", byError ? mostStrokes : 512, {1, double(mostStrokes), true});
    const Result<double> error = numberOf(line, "error", 0, {0.1, 255, false});
    const Result<double> paints = numberOf(line, "palette", 0, {1, 256, true});
    const Result<double> least = numberOf(line, "least-width", 0, {0.1, 1e5, false});
    const Result<double> greatest = numberOf(line, "greatest-width", 0, {0.1, 1e5, false});
    const Result<double> perceptual = numberOf(line, "perceptual", 0, {0, 1, false});
    const Result<double> steps = numberOf(line, "iterations", usualFitSteps, {1, 1e6, true});
    const Result<double> pixels = numberOf(line, "pixels", usualFitPixels, {1, 1e7, true});
    const Result<double> seed = numberOf(line, "seed", 1, {0, 4294967295.0, true});
    const Result<double> threads = numberOf(line, "threads", 0, {1, 1024, true});
    for (const Result<double> *value :
         {&strokes, &error, &paints, &least, &greatest, &perceptual, &steps, &pixels, &seed, &threads})
        if (!*value)
            return Error{value->error()};
    if (*greatest > 0 && *greatest < *least)
        return Error{QCoreApplication::translate("Cli", "--greatest-width %1 is below --least-width %2")
                         .arg(*greatest)
                         .arg(*least)};
    FitRequest out;
    out.backend = *backend;
    out.options.strokes = line.isSet("numbers") ? int(*strokes) / int(strokeNumbers) : int(*strokes);
    out.options.error = *error / 255;
    out.options.paints = int(*paints);
    out.options.limits.style = *style;
    out.options.limits.leastWidth = *least;
    out.options.limits.greatestWidth = *greatest;
    out.options.perceptual = *perceptual;
    out.options.steps = int(*steps);
    out.options.seed = std::uint64_t(*seed);
    out.options.threads = int(*threads);
    out.pixels = int(*pixels);
    return out;
}

Result<FitTarget> targetOf(const CommandLine &line, int pixels)
{
    const QString path = line.argument(0);
    const Result<QByteArray> bytes = inputBytes(path);
    if (!bytes)
        return Error{bytes.error()};
    if (const FileFormat format = detectFormat(*bytes); format == FileFormat::Suffuse || format == FileFormat::Text)
        return Error{
            QCoreApplication::translate("Cli", "%1: is a painting already; draw it with suffuse-cli render first")
                .arg(path)};
    Result<FitTarget> target = readFitTarget(*bytes, path, pixels, &interrupted());
    if (!target || !line.isSet("mask"))
        return target;
    const Result<QByteArray> maskBytes = inputBytes(line.value("mask"));
    if (!maskBytes)
        return Error{maskBytes.error()};
    const Result<FitPicture> mask = readMask(*maskBytes, line.value("mask"), *target);
    if (!mask)
        return Error{mask.error()};
    target->weight = *mask;
    return target;
}

Result<void> writeTarget(const QString &path, const FitPicture &picture)
{
    std::vector<float> row(4 * std::size_t(picture.width), 1);
    const PictureRows rows(picture.width, picture.height, [&](int y) {
        for (int x = 0; x < picture.width; ++x)
            std::copy_n(picture.at(x, y), 3, row.data() + 4 * std::ptrdiff_t(x));
        return row.data();
    });
    ImageOptions options;
    options.cancel = &interrupted();
    return writeImage(path, rows, options);
}

Result<std::unique_ptr<Fitting>> fittingOf(const CommandLine &line, FitTarget target, const FitRequest &request)
{
    FitOptions options = request.options;
    Result<std::unique_ptr<gradient::Differentiator>> differentiator =
        makeDifferentiator(request.backend, Threads(options.threads));
    if (!differentiator)
        return Error{differentiator.error()};
    const double scale = target.picture.width / target.canvasWidth;
    options.limits.leastWidth *= scale;
    options.limits.greatestWidth *= scale;
    if (!line.isSet("from"))
        return std::make_unique<Fitting>(std::move(target), options, std::move(*differentiator));
    const QString path = line.value("from");
    const Result<Painting> painting = paintingOf(path);
    if (!painting)
        return Error{painting.error()};
    Result<FittedStrokes> start = fittedStrokesOf(*painting, target);
    if (!start)
        return Error{QStringLiteral("%1: %2").arg(path, start.error())};
    return std::make_unique<Fitting>(std::move(target), options, std::move(*start), std::move(*differentiator));
}

QJsonObject statsOf(Fitting &fit, const FitOptions &options, int paints, double seconds)
{
    const FitPicture picture = fit.picture();
    const FitTarget &target = fit.target();
    const SimilarityAtScales similarity = multiScaleSimilarity(picture, target.picture);
    const double square = meanSquare(picture, target.picture, target.weight);
    const auto strokes = qint64(fit.strokes().strokes.size());
    return {{"strokes", strokes},
            {"numbers", strokes * qint64(strokeNumbers)},
            {"paints", paints},
            {"psnr", peakRatio(square)},
            {"error", 255 * std::sqrt(square)},
            {"msSsim", similarity.value},
            {"msSsimScales", similarity.scales},
            {"width", picture.width},
            {"height", picture.height},
            {"device", fit.differentiator().deviceName()},
            {"iterations", fit.steps()},
            {"seed", qint64(options.seed)},
            {"seconds", seconds}};
}

int fitPicture(const CommandLine &line, const FitRequest &request)
{
    QElapsedTimer clock;
    clock.start();
    const QString out = line.value("output");
    if (const QString problem = problemOfOut(out); !problem.isEmpty())
        return fail(problem);
    Result<FitTarget> target = targetOf(line, request.pixels);
    if (!target)
        return fail(interrupted() ? QCoreApplication::translate("Cli", "stopped; nothing was written")
                                  : target.error());
    if (line.isSet("target"))
        if (const Result<void> written = writeTarget(line.value("target"), target->picture); !written)
            return fail(written.error());
    const Result<std::unique_ptr<Fitting>> made = fittingOf(line, std::move(*target), request);
    if (!made)
        return fail(made.error());
    Fitting *const fit = made->get();
    const bool goesOn = line.isSet("from");
    const double before = goesOn ? fit->meanSquareError() : 0;
    fit->stopWith(&interrupted());
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "fitting"), true);
        while (!interrupted() && fit->step())
            progress.show(qint64(1000 * fit->progress()), 1000);
    }
    if (const QString lost = fit->differentiator().notice(); !lost.isEmpty())
        warn(QCoreApplication::translate("Cli", "the GPU failed (%1); the CPU went on").arg(lost));
    if (interrupted() && fit->strokes().strokes.empty())
        return fail(QCoreApplication::translate("Cli", "stopped; nothing was written"));
    fit->stopWith(nullptr);
    const double error = goesOn || request.options.error > 0 ? std::sqrt(fit->meanSquareError()) : 0;
    if (interrupted() && goesOn && error > std::sqrt(before)) // OUT may be FIT, which is worth more.
        return fail(QCoreApplication::translate("Cli", "stopped before it came nearer than %1; nothing was written")
                        .arg(line.value("from")));
    if (error > request.options.error && request.options.error > 0)
        warn(QCoreApplication::translate("Cli", "--error %1 was not reached: it is %2. Give more --strokes or --iterations.")
                 .arg(line.value("error"))
                 .arg(255 * error, 0, 'f', 2));
    const Painting painting = fit->painting();
    if (const Result<void> saved = saveDocument(painting, {}, out); !saved)
        return fail(saved.error());
    if (interrupted())
        return fail(
            QCoreApplication::translate("Cli", "stopped; %1 has the strokes so far, and --from %1 goes on").arg(out));
    return line.isSet("json") ? printJson(statsOf(*fit, request.options, int(painting.swatches.size()),
                                                  double(clock.elapsed()) * 1e-3))
                              : Done;
}

} // namespace

int fitCommand(const QStringList &arguments)
{
    CommandLine line("fit",
                     QCoreApplication::translate("Cli", "Makes strokes that look like a picture, from the back to the "
                                                        "front and large before small."),
                     {"PICTURE"});
    addFitOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (const QString problem = contradictionIn(line); !problem.isEmpty())
        return failUsage("fit", problem);
    const Result<FitRequest> request = requestOf(line);
    if (!request)
        return failUsage("fit", request.error());
    try {
        return fitPicture(line, *request);
    } catch (const std::bad_alloc &) {
        return fail(QCoreApplication::translate("Cli", "there is not enough memory to fit %1. Choose fewer --pixels.")
                        .arg(line.argument(0)));
    }
}

} // namespace suffuse::cli
