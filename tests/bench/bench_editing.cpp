// How fluid editing is: the real window, events as a hand sends them, and the time until the screen shows what they
// did.
#include "app/settings.h"
#include "model/formats/files.h"
#include "render/bench/generator.h"
#include "tests/bench/editing_benches.h"

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTextStream>

using namespace suffuse;

namespace {

Result<Painting> paintingFrom(const QCommandLineParser &parser)
{
    if (parser.isSet("painting"))
        return loadPainting(parser.value("painting"));
    bench::PaintingOptions options;
    if (parser.isSet("strokes")) {
        options.strokes = std::max(parser.value("strokes").toInt(), 1);
        options.segments = 10 * options.strokes;
    }
    return bench::makePainting(options);
}

} // namespace

int main(int argc, char *argv[])
{
    QTemporaryDir folder; // settings of its own: two threads, no window that was left anywhere
    qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
    if (qEnvironmentVariableIsEmpty("SUFFUSE_BACKEND"))
        qputenv("SUFFUSE_BACKEND", "cpu");
    if (qEnvironmentVariableIsEmpty("SUFFUSE_PRESENTER"))
        qputenv("SUFFUSE_PRESENTER", "raster");
    Application application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions({{"painting", "A document; without it one of the size of the paper's figure 11f.", "file"},
                       {"strokes", "A generated painting of so many strokes of ten segments.", "count"},
                       {"events", "Events of a drag (300).", "count", "300"},
                       {"only", "Parts, separated by commas: drags, views, selecting, tools, undo, memory.", "parts"},
                       {"drag", "Only drags that have this in their names.", "text"},
                       {"json", "For programs."}});
    parser.process(application);
    const int events = std::max(parser.value("events").toInt(), 3);
    const Result<Painting> painting = paintingFrom(parser);
    if (!painting) {
        QTextStream(stderr) << painting.error() << '\n';
        return 1;
    }
    const QStringList only = parser.value("only").split(',', Qt::SkipEmptyParts);
    settings::setThreads(2);
    EditingSession session(application, std::make_shared<const Painting>(*painting));
    const std::pair<const char *, std::function<Report()>> parts[] = {
        {"drags", [&] { return measureDrags(session, events, parser.value("drag")); }},
        {"views", [&] { return measureViews(session, events); }},
        {"selecting", [&] { return measureSelecting(session, events); }},
        {"tools", [&] { return measureTools(session, events); }},
        {"undo", [&] { return measureUndo(session, std::max(events / 6, 3)); }},
        {"memory", [&] { return measureMemory(*painting, 3 * events); }}};
    QJsonArray json;
    for (const auto &[name, measure] : parts) {
        if (!only.isEmpty() && !only.contains(QLatin1String(name)))
            continue;
        const Report report = measure();
        if (parser.isSet("json"))
            json << jsonOf(report);
        else
            print(report);
    }
    if (parser.isSet("json"))
        QTextStream(stdout) << QJsonDocument(json).toJson();
    return 0;
}
