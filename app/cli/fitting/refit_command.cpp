#include "app/cli/fitting/fit_options.h"
#include "app/cli/fitting/refit_work.h"
#include "app/cli/progress.h"
#include "model/formats/files.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonArray>

#include <new>

namespace suffuse::cli {

namespace {

using refit::RefitGoal, refit::RefitPictures;

void addRefitOptions(CommandLine &line)
{
    const auto add = [&line](const QStringList &names, const char *text, const QString &value = {}) {
        line.add(names, QCoreApplication::translate("Cli", text), value);
    };
    add({"o", "output"}, QT_TRANSLATE_NOOP("Cli", "The painting to write: .suffuse or .json."), "OUT");
    add({"select"},
        QT_TRANSLATE_NOOP("Cli", "The strokes to make anew, by their ids, such as 3,7,20-180 (default: all)."), "IDS");
    add({"layer"}, QT_TRANSLATE_NOOP("Cli", "All strokes of the group of that name, in place of --select."), "NAME");
    add({"to"},
        QT_TRANSLATE_NOOP("Cli",
                          "A picture, or another painting, that the whole is to look like (default: as it does)."),
        "FILE");
    add({"strokes"}, QT_TRANSLATE_NOOP("Cli", "At most so many strokes (default: a quarter of those before)."), "N");
    add({"error"}, QT_TRANSLATE_NOOP("Cli", "As many strokes as this root mean square error needs, in 255ths."), "E");
    add({"style"}, QT_TRANSLATE_NOOP("Cli", "feathering (default), uniform or edge."), "STYLE");
    add({"iterations"}, QT_TRANSLATE_NOOP("Cli", "How many steps (default 1200)."), "N");
    add({"pixels"}, QT_TRANSLATE_NOOP("Cli", "What the strokes reach is fitted at so many pixels (default 600000)."),
        "N");
    add({"seed"}, QT_TRANSLATE_NOOP("Cli", "Other numbers give other strokes (default 1)."), "N");
    add({"threads"}, QT_TRANSLATE_NOOP("Cli", "Number of threads (default: one a core)."), "N");
    add({"json"}, QT_TRANSLATE_NOOP("Cli", "Says how near the painting comes as JSON (docs/cli.md)."));
}

QString refitContradiction(const CommandLine &line)
{
    const QString in = line.argument(0), out = line.value("output");
    if (out.isEmpty())
        return QCoreApplication::translate("Cli", "-o OUT is missing: name the painting to write");
    if (formatForSaving(out) == FileFormat::Unknown)
        return QCoreApplication::translate("Cli", "%1: unknown ending; use .suffuse or .json").arg(out);
    if (isSameFile(in, out) || isSameFile(line.value("to"), out))
        return inputWouldBeLost(out);
    if (line.isSet("select") && line.isSet("layer"))
        return QCoreApplication::translate("Cli", "--select and --layer both say which strokes; give one of them");
    return {};
}

/// Says where the result falls short of what was there or what was asked for.
void warnOf(const RefitReport &report)
{
    if (report.isWorse())
        warn(QCoreApplication::translate("Cli", "the new strokes are farther from %1 than those before: %2 of 255, and "
                                                "before it was %3. Give more --strokes or --iterations.")
                 .arg(report.goal)
                 .arg(report.is.rootMeanSquare, 0, 'f', 2)
                 .arg(report.was.rootMeanSquare, 0, 'f', 2));
    if (report.isTooFar())
        warn(QCoreApplication::translate("Cli", "--error %1 was not reached: it is %2. Give more --strokes or --iterations.")
                 .arg(report.wanted)
                 .arg(report.fitted, 0, 'f', 2));
}

int sayReport(const RefitReport &report, bool asJson)
{
    const auto numbers = [](const RefitPictures::Difference &d) {
        return QJsonObject{{"rootMeanSquare", d.rootMeanSquare}, {"greatest", d.greatest}};
    };
    if (asJson)
        return printJson(
            {{"strokesBefore", qint64(report.before)},
             {"strokes", qint64(report.now)},
             {"numbers", qint64(report.now * std::size_t(fitting::strokeNumbers))},
             {"between", qint64(report.between)},
             {"area", QJsonArray{report.area.left, report.area.top, report.area.width(), report.area.height()}},
             {"errorBefore", numbers(report.was)},
             {"error", numbers(report.is)},
             {"iterations", report.steps},
             {"worse", report.isWorse()},
             {"seed", qint64(report.seed)},
             {"seconds", report.seconds}});
    QString text =
        QCoreApplication::translate("Cli", "%1 strokes in place of %2. Where they are seen, the picture is %3 of "
                                           "255 from what it should be (root mean square), %4 at most.")
            .arg(report.now)
            .arg(report.before)
            .arg(report.is.rootMeanSquare, 0, 'f', 2)
            .arg(report.is.greatest, 0, 'f', 1);
    if (report.was.greatest > 0)
        text += QLatin1Char(' ') + QCoreApplication::translate("Cli", "Before it was %1, %2 at most.")
                                       .arg(report.was.rootMeanSquare, 0, 'f', 2)
                                       .arg(report.was.greatest, 0, 'f', 1);
    if (report.between > 0)
        text +=
            QLatin1Char(' ') + QCoreApplication::translate("Cli", "%n stroke(s) that lay between them lie below now.",
                                                           nullptr, int(report.between));
    return print(text + QLatin1Char('\n'));
}

int refitPainting(const CommandLine &line, const RefitRequest &request)
{
    QElapsedTimer clock;
    clock.start();
    const QString out = line.value("output");
    if (const QString why = problemOfOut(out); !why.isEmpty())
        return fail(why);
    const Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<std::unordered_set<StrokeId>> ids = chosenStrokes(line, *painting);
    if (!ids)
        return failUsage("refit", ids.error());
    const Result<RefitGoal> goal = goalOf(line);
    if (!goal)
        return fail(goal.error());
    Result<Refitted> made = Error{};
    {
        ProgressLine progress(QCoreApplication::translate("Cli", "fitting"), true);
        made = refitted(std::make_shared<const Painting>(*painting), *ids, *goal, request, interrupted(),
                        [&](double share) { progress.show(qint64(1000 * share), 1000); });
    }
    if (!made)
        return fail(interrupted() ? QCoreApplication::translate("Cli", "stopped; nothing was written") : made.error());
    if (const Result<void> saved = saveDocument(made->painting, {}, out); !saved)
        return fail(saved.error());
    made->report.seconds = double(clock.elapsed()) * 1e-3;
    warnOf(made->report);
    return sayReport(made->report, line.isSet("json"));
}

} // namespace

int refitCommand(const QStringList &arguments)
{
    CommandLine line("refit",
                     QCoreApplication::translate("Cli",
                                                 "Makes fewer strokes that look like those of a painting, or makes "
                                                 "them look like a picture, and says how near they come."),
                     {"IN"});
    addRefitOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (const QString problem = refitContradiction(line); !problem.isEmpty())
        return failUsage("refit", problem);
    const Result<RefitRequest> request = refitRequestOf(line);
    if (!request)
        return failUsage("refit", request.error());
    try {
        return refitPainting(line, *request);
    } catch (const std::bad_alloc &) {
        return fail(QCoreApplication::translate("Cli", "there is not enough memory to fit %1. Choose fewer --pixels.")
                        .arg(line.argument(0)));
    }
}

} // namespace suffuse::cli
