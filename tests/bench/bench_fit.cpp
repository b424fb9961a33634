// How near fits come, and how long they take, on the CPU and on a CUDA device.
// bench_fit [--backend cpu|cuda|both] [--strokes LIST] [--steps N] [--pixels N] [--seed N] [PICTURE.ppm …]
// Pictures are binary PPM files (P6), of which a reader is a few lines, so that the program runs where no image library is
// installed. Without one it fits a landscape of its own, small enough for each push.
#include "render/backends.h"
#include "render/fitting/fitting.h"
#include "render/fitting/picture_metrics.h"
#include "tests/render/fitting/fitted_pictures.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTextStream>

#include <algorithm>
#include <cmath>

using namespace suffuse;
using namespace suffuse::fitting;

namespace {

/// A picture in [0, 1] from a PPM file of 8 bits a channel; empty if it is none.
FitPicture ppm(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray bytes = file.readAll();
    int numbers[3] = {}, at = 2;
    if (!bytes.startsWith("P6"))
        return {};
    for (int &number : numbers) {
        for (; at < bytes.size() && (std::isspace(static_cast<unsigned char>(bytes[at])) || bytes[at] == '#'); ++at)
            while (bytes[at] == '#' && at + 1 < bytes.size() && bytes[at + 1] != '\n')
                bytes[++at] = '#'; // a comment, up to the end of its line
        while (at < bytes.size() && std::isdigit(static_cast<unsigned char>(bytes[at])))
            number = 10 * number + (bytes[at++] - '0');
    }
    ++at;
    const auto [width, height, most] = numbers;
    if (most != 255 || bytes.size() - at < qsizetype(3) * width * height)
        return {};
    FitPicture out(width, height, 3);
    std::transform(bytes.begin() + at, bytes.begin() + at + qsizetype(3) * width * height, out.values.begin(),
                   [](char c) { return float(static_cast<unsigned char>(c)) / 255; });
    return out;
}

FitTarget targetOf(const FitPicture &picture, int pixels)
{
    FitTarget target;
    target.canvasWidth = picture.width, target.canvasHeight = picture.height;
    const double scale = std::min(1.0, std::sqrt(double(pixels) / double(picture.pixels())));
    target.picture =
        averaged(picture, int(std::lround(picture.width * scale)), int(std::lround(picture.height * scale)));
    return target;
}

/// Of so many moments of the painting that is played, those that are less near than the one before.
int momentsBack(const FittedStrokes &strokes, const FitTarget &target, int moments)
{
    const double scale = 0.5;
    const FitPicture small = averaged(target.picture, std::max(1, int(target.picture.width * scale)),
                                      std::max(1, int(target.picture.height * scale)));
    const View view =
        View::ofArea(Rect::of(0, 0, target.picture.width, target.picture.height), small.width, small.height);
    double before = 1e300;
    int back = 0;
    for (int moment = 1; moment <= moments; ++moment) {
        std::vector<FitStroke> some;
        for (std::size_t i = 0; i < strokes.strokes.size(); ++i)
            if (strokes.births.empty() ||
                strokes.births[i] < strokes.strokes.size() * std::size_t(moment) / std::size_t(moments))
                some.push_back(strokes.strokes[i]);
        gradient::SceneGradient<float> gradient;
        const gradient::FlatScene scene = sceneOf(some, strokes.style, strokes.background, view);
        gradient.choose(scene);
        const std::span<const float> drawn = gradient.draw(scene);
        double error = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            error += std::pow(double(drawn[i]) - double(small.values[i]), 2);
        back += error > before * (1 + 1e-6) ? 1 : 0;
        before = error;
    }
    return back;
}

void report(const QString &name, const FitTarget &target, const FitOptions &options, Backend backend, QTextStream &out)
{
    Result<std::unique_ptr<gradient::Differentiator>> made = makeDifferentiator(backend, Threads(options.threads));
    if (!made) {
        out << "skipped: " << made.error() << "\n" << Qt::flush;
        return;
    }
    QElapsedTimer clock;
    clock.start();
    Fitting fit(target, options, std::move(*made));
    double lastSteps = 0;
    while (!fit.isDone()) {
        fit.step();
        if (fit.steps() < options.steps)
            lastSteps = double(clock.nsecsElapsed()) * 1e-9;
    }
    const double seconds = double(clock.nsecsElapsed()) * 1e-9;
    const FitPicture picture = fit.picture();
    const double ratio = peakRatio(meanSquare(picture, target.picture));
    out << QStringLiteral("%1  %2x%3  %4 strokes, %5 steps: %6 dB, MS-SSIM %7, %8 s (%9 s of steps), %10 of 100 moments back, %11\n")
               .arg(name, -20)
               .arg(target.picture.width)
               .arg(target.picture.height)
               .arg(fit.strokes().strokes.size())
               .arg(fit.steps())
               .arg(ratio, 0, 'f', 2)
               .arg(multiScaleSimilarity(picture, target.picture).value, 0, 'f', 4)
               .arg(seconds, 0, 'f', 1)
               .arg(lastSteps, 0, 'f', 1)
               .arg(momentsBack(fit.strokes(), target, 100))
               .arg(fit.differentiator().deviceName())
        << Qt::flush;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOptions({{"backend", "cpu, cuda or both.", "name", "cpu"},
                       {"strokes", "Numbers of strokes, separated by commas.", "list", "24"},
                       {"steps", "Steps of each fit.", "count", "1200"},
                       {"pixels", "Pictures are averaged down to so many pixels.", "count", "600000"},
                       {"threads", "Threads; 0: one a core.", "count", "0"},
                       {"seed", "Of the fit.", "number", "1"}});
    parser.addPositionalArgument("pictures", "Binary PPM files.", "[PICTURE.ppm …]");
    parser.addHelpOption();
    parser.process(app);
    QTextStream out(stdout);
    std::vector<Backend> backends;
    if (parser.value("backend") != "cuda")
        backends.push_back(Backend::Cpu);
    if (parser.value("backend") != "cpu")
        backends.push_back(Backend::Cuda);
    FitOptions options;
    options.steps = std::max(1, parser.value("steps").toInt());
    options.seed = parser.value("seed").toULongLong();
    options.threads = parser.value("threads").toInt();
    const auto fitAll = [&](const QString &name, const FitTarget &target) {
        for (const QString &strokes : parser.value("strokes").split(','))
            for (const Backend backend : backends) {
                options.strokes = std::max(1, strokes.toInt());
                report(name, target, options, backend, out);
            }
    };
    if (parser.positionalArguments().isEmpty())
        fitAll("landscape", landscape(192, 128));
    for (const QString &path : parser.positionalArguments()) {
        const FitPicture picture = ppm(path);
        if (picture.isEmpty()) {
            out << path << ": is no binary PPM file of 8 bits a channel\n";
            return 1;
        }
        fitAll(QFileInfo(path).completeBaseName(), targetOf(picture, std::max(1, parser.value("pixels").toInt())));
    }
    return 0;
}
