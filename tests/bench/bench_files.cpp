// Sizes and times of .suffuse files. bench_files [--segments N] [--repeat N] [FILE…]: each file as it is, and a
// painting made of N segments by a synthetic pen.
#include "model/formats/files.h"
#include "model/formats/ink/recording.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

#include <algorithm>
#include <cmath>
#include <ctime>

using namespace suffuse;

namespace {

/// Hand movements of a few slow waves each, sampled every 8 ms at full precision, until there are enough segments.
Painting penPainting(std::size_t segments)
{
    Recording recording;
    const auto path = [](int k, int samples) {
        Recording::Path out;
        for (int i = 0; i < samples; ++i) {
            const double t = 0.008 * i, phase = 0.7 * k;
            PenSample sample;
            sample.position = {1000 + 700 * std::sin(0.013 * k) + 120 * std::sin(1.3 * t + phase) + 9 * std::sin(7 * t),
                               800 + 600 * std::cos(0.017 * k) + 90 * std::cos(1.7 * t + phase) + 7 * std::sin(9 * t)};
            sample.pressure = float(0.5 + 0.3 * std::sin(2 * t + phase));
            sample.time = (qint64(k) * 4'000'000) + qint64(i) * 8'000;
            out.samples.push_back(sample);
        }
        return out;
    };
    const auto painted = [](const Recording &r) {
        Result<Painting> p = paintRecording(r, builtinBrushes().front(), QStringLiteral("pen"));
        return p ? *p : Painting();
    };
    constexpr int samples = 300;
    recording.paths = {path(1, samples)};
    const std::size_t each = std::max<std::size_t>(1, painted(recording).segmentCount());
    recording.paths.clear();
    for (std::size_t k = 0; k * each < segments; ++k)
        recording.paths.push_back(path(int(k), samples));
    return painted(recording);
}

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// Milliseconds since it was made, and those that the program's threads computed.
class Stopwatch {
public:
    Stopwatch() { m_wall.start(); }
    void stop(std::vector<double> &wall, std::vector<double> &cpu) const
    {
        cpu.push_back(1e3 * double(std::clock() - m_cpu) / CLOCKS_PER_SEC);
        wall.push_back(double(m_wall.nsecsElapsed()) * 1e-6);
    }

private:
    QElapsedTimer m_wall;
    std::clock_t m_cpu = std::clock();
};

struct Series {
    std::vector<double> wall, cpu;
    QString text() const
    {
        return QStringLiteral("%1 ms (%2 of CPU)").arg(median(wall), 0, 'f', 1).arg(median(cpu), 0, 'f', 1);
    }
};

/// Prints one line; false where what comes back is not what was saved.
bool measure(const QString &name, const Painting &painting, int repeat)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.suffuse"));
    Series write, save, open;
    qint64 size = 0;
    bool same = true;
    for (int k = 0; k < repeat; ++k) {
        const Stopwatch writing;
        size = writeSuffuseFile(painting).size();
        writing.stop(write.wall, write.cpu);
        const Stopwatch saving;
        same = same && savePainting(painting, path);
        saving.stop(save.wall, save.cpu);
        const Stopwatch opening;
        const Result<LoadedDocument> back = loadDocument(path);
        opening.stop(open.wall, open.cpu);
        same = same && back && back->losses.empty() && (k > 0 || back->painting == painting);
    }
    const auto segments = double(std::max<std::size_t>(1, painting.segmentCount()));
    QTextStream(stdout) << QStringLiteral("%1: %2 strokes, %3 segments, %4 bytes (%5 a segment); bytes made in %6, "
                                          "saved in %7, opened in %8%9\n")
                               .arg(name)
                               .arg(painting.strokes.size())
                               .arg(painting.segmentCount())
                               .arg(size)
                               .arg(double(size) / segments, 0, 'f', 2)
                               .arg(write.text(), save.text(), open.text())
                               .arg(same ? QString() : QStringLiteral("; NOT THE SAME"));
    return same;
}

} // namespace

int main(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({QStringLiteral("segments"), QStringLiteral("Also a painting of so many."), QStringLiteral("N")});
    parser.addOption({QStringLiteral("repeat"), QStringLiteral("Times; the median is printed."), QStringLiteral("N"),
                      QStringLiteral("9")});
    parser.process(app);
    const int repeat = std::max(1, parser.value(QStringLiteral("repeat")).toInt());
    bool good = true;
    for (const QString &file : parser.positionalArguments()) {
        const Result<Painting> painting = loadPainting(file);
        if (!painting)
            QTextStream(stderr) << painting.error() << '\n';
        good = good && painting && measure(file, *painting, repeat);
    }
    if (const int segments = parser.value(QStringLiteral("segments")).toInt(); segments > 0)
        good = good && measure(QStringLiteral("pen"), penPainting(std::size_t(segments)), repeat);
    return good ? 0 : 1;
}
