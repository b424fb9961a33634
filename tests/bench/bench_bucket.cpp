// What a click of the bucket costs: the picture that is looked at, and its region with its outlines.
// bench_bucket [--runs N] [FILE…]
#include "app/session/painting/paint_region.h"
#include "model/formats/files.h"
#include "render/bench/rows.h"
#include "tests/bench/filled_shapes.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTextStream>

using namespace suffuse;
using namespace suffuse::baseline;

namespace {

void measure(QTextStream &out, const QString &name, const PaintingPtr &painting, double gap, int runs)
{
    const Rect sheet = painting->canvas.area();
    const Point places[] = {sheet.centre(), {sheet.left + 5, sheet.top + 5}};
    std::vector<double> times;
    std::size_t curves = 0;
    for (int run = 0; run < runs; ++run)
        for (const Point at : places) {
            QElapsedTimer timer;
            timer.start();
            const auto outlines = paintRegion(painting, painting->end(), at, {0.1, gap, 1}, 1);
            times.push_back(double(timer.nsecsElapsed()) * 1e-6);
            for (const auto &loop : outlines)
                curves = std::max(curves, loop.size());
        }
    out << name.leftJustified(44) << QString::number(bench::timingOf(times).medianMs, 'f', 0).rightJustified(9)
        << QString::number(*std::ranges::max_element(times), 'f', 0).rightJustified(9)
        << QString::number(curves).rightJustified(9) << Qt::endl;
}

PaintingPtr emptySheet(double width, double height)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = width;
    painting->canvas.height = height;
    return painting;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addOption({"runs", "Runs of each (default 5).", "N", "5"});
    parser.addPositionalArgument("file", "Paintings to be filled, too.");
    parser.process(app);
    const int runs = std::max(1, parser.value("runs").toInt());
    QTextStream out(stdout);
    out << "ms of a click, of " << 2 * runs << " (the middle and a corner), and curves of the longest outline\n"
        << QStringLiteral("painting").leftJustified(44) << "   median      max   curves\n";
    for (const auto &[width, height] : {std::pair{640.0, 480.0}, {1920.0, 1080.0}, {4000.0, 3000.0}})
        for (const double gap : {0.0, 20.0})
            measure(out, QString("empty, %1 × %2, gap %3").arg(width).arg(height).arg(gap), emptySheet(width, height),
                    gap, runs);
    for (const QString &file : parser.positionalArguments()) {
        const Result<Painting> painting = loadPainting(file);
        if (!painting) {
            QTextStream(stderr) << painting.error() << '\n';
            return 1;
        }
        for (const double gap : {0.0, 20.0})
            measure(out,
                    QString("%1, %2 × %3, gap %4")
                        .arg(QFileInfo(file).fileName())
                        .arg(painting->canvas.width)
                        .arg(painting->canvas.height)
                        .arg(gap),
                    std::make_shared<const Painting>(*painting), gap, runs);
    }
    return 0;
}
