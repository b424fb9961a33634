// The gradient of the picture: nodes, picture, way back, and both at once.
// bench_gradient [--size 768x512] [--strokes 512] [--threads 2] [--runs 20] [--spread 3,20] [--unseen 5e-4]
#include "tests/render/flat_scenes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

#include <algorithm>
#include <array>

using namespace suffuse;
using namespace suffuse::test;

namespace {

struct Options {
    int width, height, strokes, threads, runs;
    double least, greatest;
    Precision precision;
};

/// The median and the least of some times, in milliseconds.
struct Times {
    std::vector<double> ms;

    template <class Act>
    void measure(Act act)
    {
        QElapsedTimer timer;
        timer.start();
        act();
        ms.push_back(double(timer.nsecsElapsed()) * 1e-6);
    }
    QString text() const
    {
        std::vector<double> sorted = ms;
        std::ranges::sort(sorted);
        return QStringLiteral("%1 (%2)").arg(sorted[sorted.size() / 2], 7, 'f', 2).arg(sorted.front(), 6, 'f', 2);
    }
};

void measure(const char *name, const SceneKind &kind, const Options &options, QTextStream &out)
{
    FlatScene scene = randomScene(1, options.strokes, options.width, options.height, kind);
    scene.byXi = false;
    const auto by = randomLoss<float>(1, options.width, options.height);
    const auto loss = [&](std::size_t first, std::size_t count, const float *rgb, float *slopes) {
        for (std::size_t i = 0; i < 3 * count; ++i)
            slopes[i] = rgb[i] - by[3 * first + i];
    };
    SceneGradient<float> gradient{Threads(options.threads)};
    Times choose, draw, back, both;
    for (int run = 0; run < options.runs; ++run) {
        choose.measure([&] { gradient.choose(scene, options.precision); });
        draw.measure([&] { gradient.draw(scene); });
        back.measure([&] { gradient.backward(by); });
        both.measure([&] { gradient.drawAndDifferentiate(scene, loss); });
    }
    out << QString::fromLatin1(name).leftJustified(22) << choose.text() << draw.text() << back.text() << both.text()
        << Qt::endl;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addOptions({{"size", {}, "WxH", "768x512"},
                       {"strokes", {}, "N", "512"},
                       {"threads", {}, "N", "2"},
                       {"runs", {}, "N", "20"},
                       {"spread", {}, "A,B", "3,20"},
                       {"unseen", {}, "E", "5e-4"}});
    parser.process(application);
    const QStringList size = parser.value("size").split('x'), spread = parser.value("spread").split(',');
    if (size.size() != 2 || spread.size() != 2)
        return 2;
    const Options options{size[0].toInt(),
                          size[1].toInt(),
                          parser.value("strokes").toInt(),
                          parser.value("threads").toInt(),
                          std::max(1, parser.value("runs").toInt()),
                          spread[0].toDouble(),
                          spread[1].toDouble(),
                          {parser.value("unseen").toDouble()}};
    QTextStream out(stdout);
    out << "milliseconds: median (least)  nodes          picture         back            both at once" << Qt::endl;
    SceneKind kind;
    kind.least = options.least, kind.greatest = options.greatest, kind.length = 40;
    const std::array<const char *, 3> names{"uniform", "feathering", "edge darkening"};
    for (int style = 0; style < 3; ++style) {
        kind.style = StyleKind(style);
        measure(names[std::size_t(style)], kind, options, out);
    }
    kind.style = StyleKind::Uniform;
    kind.pigment = true;
    measure("uniform, pigment", kind, options, out);
    kind.oneColour = false;
    measure("the same, colours vary", kind, options, out);
    kind.oneColour = true, kind.pigment = false, kind.filled = true;
    kind.least = 1.5, kind.greatest = 5, kind.length = 12;
    measure("filled, s = 2 to 6 px", kind, options, out);
    return 0;
}
