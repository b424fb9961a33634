// What keeping a journal costs the window's thread, a stroke, and how soon a stroke is on disk.
//   bench_journal [FILE.suffuse]...    without a file: 10,000 strokes of ten segments; --quick: a hundred
// Prints a line a painting: median, 99th percentile and most of the thread's own time and of the time on the wall, for
// handing over a snapshot; and from there until it is synced. Then how many syncs a second the disk takes.
#include "app/session/editor.h"
#include "app/session/files/journal.h"
#include "model/formats/files.h"
#include "render/bench/generator.h"
#include "undo/edits.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <cstdio>
#include <ctime>

using namespace suffuse;

namespace {

double threadMs()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

void print(const char *what, std::vector<double> ms)
{
    std::sort(ms.begin(), ms.end());
    std::printf("  %-34s median %8.4f  99 %% %8.4f  most %8.4f ms\n", what, ms[ms.size() / 2], ms[ms.size() * 99 / 100],
                ms.back());
}

void measure(const QString &name, PaintingPtr painting, int strokes)
{
    QTemporaryDir folder;
    Editor editor;
    editor.clock().setManual(true);
    editor.openRecovered(*painting, name, {});
    JournalWriter writer(folder.path(), {});
    writer.begin({name, {}, {}}, editor.document().painting(), true);
    writer.flush();
    const StrokePtr model = painting->strokes.back();
    std::vector<double> cpu, wall, disk;
    for (int i = 0; i < strokes; ++i) {
        auto stroke = std::make_shared<Stroke>(*model);
        stroke->id = editor.document().takeStrokeId();
        stroke->group = 0;
        stroke->origin.x += i;
        editor.push(addStrokes(editor.document(), {stroke}, false), QStringLiteral("Stroke"));
        QElapsedTimer clock;
        clock.start();
        const double from = threadMs();
        writer.record(editor.document().painting(), true);
        cpu.push_back(threadMs() - from);
        wall.push_back(double(clock.nsecsElapsed()) * 1e-6);
        writer.flush();
        disk.push_back(double(clock.nsecsElapsed()) * 1e-6);
    }
    std::printf("%s: %zu strokes, %zu segments, %d painted on top\n", qPrintable(name), painting->strokes.size(),
                painting->segmentCount(), strokes);
    print("handed over, thread's own time", cpu);
    print("handed over, on the wall", wall);
    print("until it is on disk", disk);
}

void measureDisk(int count)
{
    QTemporaryDir folder;
    const auto file = JournalFile::create(folder.filePath("a"));
    if (!file)
        return;
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < count; ++i)
        if (!(*file)->append(QByteArray(700, 'x')))
            return;
    std::printf("appending 700 bytes and fdatasync: %.0f a second\n", count / (double(clock.nsecsElapsed()) * 1e-9));
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    const QStringList files = app.arguments().mid(1);
    const bool quick = files.contains("--quick");
    const int strokes = quick ? 20 : 300;
    for (const QString &file : files) {
        if (file.startsWith("--"))
            continue;
        Result<Painting> painting = loadPainting(file);
        if (!painting) {
            std::fprintf(stderr, "%s\n", qPrintable(painting.error()));
            return 1;
        }
        measure(QFileInfo(file).fileName(), std::make_shared<const Painting>(std::move(*painting)), strokes);
    }
    bench::PaintingOptions options;
    options.strokes = quick ? 100 : 10'000;
    options.segments = 10 * options.strokes;
    measure("generated", std::make_shared<const Painting>(bench::makePainting(options)), strokes);
    measureDisk(quick ? 20 : 1'000);
    return 0;
}
