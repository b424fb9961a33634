// How fluid editing is: the real window, events as a hand sends them, and the time until the screen shows what they
// did.
#include "tests/bench/bench_start.h"
#include "tests/bench/editing/editing_benches.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTextStream>

using namespace suffuse;

int main(int argc, char *argv[])
{
    const QTemporaryDir folder;
    useOwnSettings(folder);
    Application application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOptions(
        {{"painting", "A document; without it one of the size of the paper's figure 11f.", "file"},
         {"strokes", "A generated painting of so many strokes of ten segments.", "count"},
         {"events", "Events of a drag (300).", "count", "300"},
         {"only", "Parts, separated by commas: drags, views, selecting, tools, erasing, typing, undo, memory.",
          "parts"},
         {{"rows", "drag"}, "Only drags, selections, tools and undo steps that have this in their names.", "text"},
         {"json", "For programs."}});
    parser.process(application);
    const int events = std::max(parser.value("events").toInt(), 3);
    const Result<Painting> painting = paintingFrom(parser);
    if (!painting) {
        QTextStream(stderr) << painting.error() << '\n';
        return 1;
    }
    const QStringList only = parser.value("only").split(',', Qt::SkipEmptyParts);
    const QString rows = parser.value("rows");
    settings::setThreads(2);
    EditingSession session(application, std::make_shared<const Painting>(*painting));
    const std::pair<const char *, std::function<Report()>> parts[] = {
        {"drags", [&] { return measureDrags(session, events, rows); }},
        {"views", [&] { return measureViews(session, events); }},
        {"selecting", [&] { return measureSelecting(session, events, rows); }},
        {"tools", [&] { return measureTools(session, events, rows); }},
        {"erasing", [&] { return measureErasing(session, events, rows); }},
        {"typing", [&] { return measureTyping(session, events, rows); }},
        {"undo", [&] { return measureUndo(session, std::max(events / 6, 3), rows); }},
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
