// Strokes that look like a picture.
#include "app/python/pixels.h"

#include "model/painting/fields.h"
#include "render/fitting/fitting.h"

#include <QCoreApplication>
#include <QFile>

namespace suffuse::python {

namespace {

using namespace fitting;

/// The numbers of an array of `channels` (1: a weight), in [0, 1].
FitPicture fitPictureOf(const py::array &pixels, int channels, const char *name)
{
    const bool isGrey = channels == 1 && pixels.ndim() == 2;
    if (!isGrey && (pixels.ndim() != 3 || pixels.shape(2) < channels || pixels.shape(2) > 4 || pixels.size() == 0))
        raise(Raised::Value, QStringLiteral("%1: give it the shape (height, width%2)")
                                 .arg(QLatin1String(name), channels == 1 ? QString() : QStringLiteral(", 3 or 4")));
    // As images are read: what is multiplied, to the last bit.
    const float unit = 1 / whiteOf(pixels, name);
    const Floats numbers = finiteFloatsOf(pixels, name);
    const auto given = isGrey ? 1 : int(pixels.shape(2));
    const float *const end = numbers.data() + numbers.size();
    bool counts = channels != 1; // Of a weight, the first channel does.
    for (const float *v = numbers.data(); v < end && !counts; v += given)
        counts = *v > 0;
    if (!counts)
        raise(Raised::Value, QCoreApplication::translate(
                                 "fitting",
                                 "%1: is black all over, so nothing counts; paint white what is to be fitted")
                                 .arg(QLatin1String(name)));
    // What a resampling overshoots is cut off; farther away it is another range, which would be cut to black and white.
    const float *const far =
        std::find_if(numbers.data(), end, [&](float v) { return v * unit < -0.01f || v * unit > 1.5f; });
    if (far != end)
        raise(Raised::Value, QStringLiteral("%1: %2 is not in [0, 1]; divide floats by their white, or give uint8")
                                 .arg(QLatin1String(name))
                                 .arg(double(*far)));
    FitPicture out(int(pixels.shape(1)), int(pixels.shape(0)), channels);
    const float *from = numbers.data();
    for (std::size_t i = 0; i < out.pixels(); ++i, from += given) {
        const float alpha = given == 4 ? from[3] * unit : 1.0f; // White shows through.
        for (int c = 0; c < channels; ++c)
            out.values[i * std::size_t(channels) + std::size_t(c)] =
                std::clamp(channels == 1 ? from[c] * unit : 1 + alpha * (from[c] * unit - 1), 0.0f, 1.0f);
    }
    return out;
}

FitTarget targetOf(const py::object &picture, const py::object &weight, int pixels)
{
    FitTarget target;
    if (py::isinstance<py::array>(picture)) {
        target.picture = fitPictureOf(picture.cast<py::array>(), 3, "picture");
        target.canvasWidth = target.picture.width;
        target.canvasHeight = target.picture.height;
        if (const double shrink = std::sqrt(double(pixels) / double(target.picture.pixels())); shrink < 1) {
            const int width = std::max(1, int(target.picture.width * shrink));
            const double height = target.picture.height * (double(width) / target.picture.width);
            target.picture = averaged(target.picture, width, std::max(1, int(std::lround(height))));
        }
    } else {
        const QString name = pathOf(picture);
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly))
            raise(Raised::File, QStringLiteral("%1: %2").arg(name, file.errorString()));
        const QByteArray bytes = file.readAll();
        Result<FitTarget> read = Error{};
        withoutLock([&](std::atomic<bool> &cancel) { read = readFitTarget(bytes, name, pixels, &cancel); });
        target = valueOf(std::move(read), Raised::Value);
    }
    if (!weight.is_none()) {
        target.weight = fitPictureOf(weight.cast<py::array>(), 1, "weight");
        if (target.weight.width < target.picture.width || target.weight.height < target.picture.height)
            raise(Raised::Value, QStringLiteral("weight: give it the size of the picture, %1 × %2")
                                     .arg(target.canvasWidth)
                                     .arg(target.canvasHeight));
        target.weight = averaged(target.weight, target.picture.width, target.picture.height);
    }
    return target;
}

/// A number that is in its range, or DataError.
template <class Number>
Number checked(const char *name, Number value, double least, double greatest)
{
    if (!(double(value) >= least && double(value) <= greatest))
        raise(Raised::Value, QStringLiteral("%1 %2: give a %3number from %4 to %5")
                                 .arg(QLatin1String(name))
                                 .arg(value)
                                 .arg(QLatin1String(std::is_integral_v<Number> ? "whole " : ""))
                                 .arg(least, 0, 'g', 12)
                                 .arg(greatest, 0, 'g', 12));
    return value;
}

StyleKind styleOf(const QString &name)
{
    for (std::size_t i = 0; i < WordsOf<StyleKind>::list.size(); ++i)
        if (name == QLatin1String(WordsOf<StyleKind>::list[i].data(), qsizetype(WordsOf<StyleKind>::list[i].size())))
            return StyleKind(i);
    raise(Raised::Value, QStringLiteral("style %1: give feathering, uniform or edge").arg(name));
}

/// Does the steps; tells Python of each, which may raise and so end the fit.
void run(Fitting &fit, const py::object &progress)
{
    bool goesOn = true;
    while (goesOn) {
        withoutLock([&](std::atomic<bool> &cancel) {
            fit.stopWith(&cancel);
            goesOn = fit.step();
            fit.stopWith(nullptr);
        });
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!progress.is_none())
            progress(fit.progress());
    }
}

PaintingValue valueOfFit(const Fitting &fit)
{
    return {std::make_shared<const Painting>(fit.painting()), std::make_shared<const DocumentExtras>(), {}};
}

/// Gives an exception that ended a fit the strokes so far, as its attribute `painting`: None where there are none, and the
/// start where they are no nearer than that.
void keepIn(const py::error_already_set &stopped, Fitting &fit, const py::object &start, double startError)
{
    py::object reached = py::none();
    if (!start.is_none() && fit.meanSquareError() > startError)
        reached = start;
    else if (!fit.strokes().strokes.empty())
        reached = py::cast(valueOfFit(fit));
    if (PyObject_SetAttrString(stopped.value().ptr(), "painting", reached.ptr()) != 0)
        PyErr_Clear(); // An exception of others may have no room for it.
}

} // namespace

void addFits(py::module_ &module)
{
    using namespace py::literals;
    module.def(
        "fit",
        [](const py::object &picture, int strokes, double error, int steps, int paints, double perceptual,
           const QString &style, double leastWidth, double greatestWidth, const py::object &weight,
           const py::object &start, int pixels, std::uint64_t seed, int threads, const py::object &progress) {
            FitOptions options;
            options.strokes = checked("strokes", strokes, 1, 20'000);
            options.error = error == 0 ? 0 : checked("error", error, 0.1, 255) / 255;
            options.steps = checked("steps", steps, 1, 1e6);
            options.paints = checked("palette", paints, 0, 256);
            options.perceptual = checked("perceptual", perceptual, 0, 1);
            options.seed = seed;
            options.threads = checked("threads", threads, 0, 1024);
            options.limits.style = styleOf(style);
            FitTarget target = targetOf(picture, weight, checked("pixels", pixels, 1, 1e7));
            const double scale = target.picture.width / target.canvasWidth;
            options.limits.leastWidth = scale * leastWidth;
            options.limits.greatestWidth = scale * greatestWidth;
            if (greatestWidth > 0 && greatestWidth < leastWidth)
                raise(Raised::Value,
                      QStringLiteral("greatest_width %1 is below least_width %2").arg(greatestWidth).arg(leastWidth));
            std::unique_ptr<Fitting> fit;
            if (start.is_none()) {
                fit = std::make_unique<Fitting>(std::move(target), options);
            } else {
                FittedStrokes begun =
                    valueOf(fittedStrokesOf(*start.cast<const PaintingValue &>().painting, target), Raised::Value);
                fit = std::make_unique<Fitting>(std::move(target), options, std::move(begun));
            }
            double startError = 0;
            if (!start.is_none()) {
                const py::gil_scoped_release released;
                startError = fit->meanSquareError();
            }
            try {
                run(*fit, progress);
            } catch (const py::error_already_set &stopped) {
                keepIn(stopped, *fit, start, startError);
                throw;
            }
            return valueOfFit(*fit);
        },
        "picture"_a, py::kw_only(), "strokes"_a = 512, "error"_a = 0.0, "steps"_a = usualFitSteps, "palette"_a = 0,
        "perceptual"_a = 0.0, "style"_a = "feathering", "least_width"_a = 0.0, "greatest_width"_a = 0.0,
        "weight"_a = py::none(), "start"_a = py::none(), "pixels"_a = usualFitPixels, "seed"_a = 1, "threads"_a = 0,
        "progress"_a = py::none());
}

} // namespace suffuse::python
