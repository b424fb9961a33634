// What the harness kills and lets fail. Says on stdout what it has done, a line each, flushed.
//   victim save FILE SEED      saves paintings for ever; the k-th is 100 + k wide
//   victim paint FOLDER SEED   paints for ever, with its journal in the folder
//   victim fault FILE OTHER    saves once with faults armed, then once under another name
//   victim settings            reads all settings
#include "app/session/editor.h"
#include "app/session/files/journal.h"
#include "app/session/settings/settings.h"
#include "model/brush/stroke_builder.h"
#include "undo/edits.h"

#include <QCoreApplication>
#include <QEventLoop>

#include <cstdio>
#include <dlfcn.h>
#include <random>

using namespace suffuse;

namespace {

using Random = std::mt19937;

double real(Random &random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

StrokePtr scribble(Random &random, StrokeId id, Microseconds from)
{
    std::vector<PenSample> samples;
    Point at{real(random, 0, 1000), real(random, 0, 700)};
    for (int i = 0; i < 24; ++i) {
        at = at + Point{real(random, -8, 20), real(random, -12, 12)};
        samples.push_back({at, from + 8'000 * i, float(real(random, 0.2, 1))});
    }
    return buildStroke(builtinBrushes().front(), id, samples);
}

PaintingPtr paintingOf(int k, Random &random)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = 100 + k;
    for (int i = 1; i <= 1 + k % 20; ++i)
        if (StrokePtr stroke = scribble(random, StrokeId(i), 1'000'000 * i))
            painting->strokes.push_back(stroke);
    return painting;
}

void say(const char *what, int k, const QByteArray &more = {})
{
    std::printf("%s %d %s\n", what, k, more.constData());
    std::fflush(stdout);
}

SaveOrder orderFor(const PaintingPtr &painting, const QString &path)
{
    SaveOrder order;
    order.painting = painting;
    order.path = path;
    order.extras.preview = QByteArray(1000, 'p');
    return order;
}

int save(const QString &path, unsigned seed)
{
    Random random(seed);
    for (int k = 1;; ++k) {
        const PaintingPtr painting = paintingOf(k, random);
        say("saving", k);
        const Result<void> saved = savePainting(*painting, path);
        if (!saved)
            return 1;
        say("saved", k);
    }
}

/// The next stroke is not begun before the one before is on disk: people are slower than that.
int paint(const QString &folder, unsigned seed)
{
    Journal::setFolder(folder);
    Random random(seed);
    Editor editor;
    editor.clock().setManual(true);
    Journal journal(editor);
    for (int k = 1;; ++k) {
        Document &document = editor.document();
        if (random() % 5 == 0 && editor.undoStack().canUndo())
            editor.undoStack().undo();
        else if (StrokePtr stroke = scribble(random, document.takeStrokeId(), 1'000'000 * k))
            editor.push(addStrokes(document, {stroke}, false), QStringLiteral("Stroke"));
        say("finished", k, hashOf(*document.painting()).toHex());
        journal.flush();
        say("written", k);
    }
}

int fault(const QString &path, const QString &other)
{
    Random random(1);
    const PaintingPtr painting = paintingOf(15, random);
    // From the preloaded library; absent without it.
    const auto arm = reinterpret_cast<void (*)(int)>(::dlsym(RTLD_DEFAULT, "suffuseArmFaults"));
    const auto hits = reinterpret_cast<int (*)()>(::dlsym(RTLD_DEFAULT, "suffuseFaultHits"));
    if (!arm || !hits)
        return 2;
    arm(1);
    SaveOrder order = orderFor(painting, path);
    order.backups = 1;
    const SaveOutcome outcome = carryOut(order);
    arm(0);
    say(outcome.isSaved() ? "saved" : "failed", hits(), outcome.message.toUtf8());
    const SaveOutcome elsewhere = carryOut(orderFor(painting, other));
    say(elsewhere.isSaved() ? "elsewhere" : "nowhere", 0, elsewhere.message.toUtf8());
    return 0;
}

int readSettings()
{
    settings::beginStart();
    settings::language();
    settings::theme();
    settings::presenter();
    settings::backend();
    settings::penSettings();
    settings::canvasAids();
    settings::setThreads(settings::threads());
    settings::recentFiles();
    settings::store().sync();
    settings::startSucceeded();
    say("up", 0);
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("suffuse"));
    const QStringList words = app.arguments();
    const QString mode = words.value(1);
    const unsigned seed = words.value(3).toUInt();
    return mode == "save"       ? save(words.value(2), seed)
           : mode == "paint"    ? paint(words.value(2), seed)
           : mode == "fault"    ? fault(words.value(2), words.value(3))
           : mode == "settings" ? readSettings()
                                : 2;
}
