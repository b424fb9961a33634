#include "app/cli/documents/diff_picture.h"
#include "app/cli/options.h"
#include "model/document/difference.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

namespace suffuse::cli {

namespace {

/// As diff and cmp have it: trouble is not a difference.
enum DiffCode { Same = 0, Different = 1, Trouble = 2 };

struct Comparison {
    QString nameA, nameB;
    PaintingPtr a, b;
    PaintingDifference difference;
    std::vector<ValueDifference> values; ///< of the painting without its strokes
};

struct Cli {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

QString lineOf(const ValueDifference &v)
{
    if (v.before.isEmpty())
        return QStringLiteral("%1: + %2").arg(v.path, v.after);
    if (v.after.isEmpty())
        return QStringLiteral("%1: - %2").arg(v.path, v.before);
    return QStringLiteral("%1: %2 → %3").arg(v.path, v.before, v.after);
}

/// "stroke 17 “sky”"
QString titleOf(const Stroke &stroke)
{
    const QString title = Cli::tr("stroke %1").arg(stroke.id);
    return stroke.name.isEmpty() ? title : QStringLiteral("%1 “%2”").arg(title, stroke.name);
}

/// "3, 7-9"
QString textOfPlaces(const std::vector<std::size_t> &places)
{
    QStringList list;
    for (std::size_t from = 0; from < places.size();) {
        std::size_t to = from;
        while (to + 1 < places.size() && places[to + 1] == places[to] + 1)
            ++to;
        list << (to == from ? QString::number(places[from])
                            : QStringLiteral("%1-%2").arg(places[from]).arg(places[to]));
        from = to + 1;
    }
    return list.join(QStringLiteral(", "));
}

void appendChanged(QStringList &lines, const Stroke &before, const Stroke &after)
{
    const StrokeDifference d = differenceOf(before, after);
    lines << QStringLiteral("~ %1").arg(titleOf(after));
    if (!d.added.empty())
        lines << QStringLiteral("    ") + Cli::tr("segments added: %1").arg(textOfPlaces(d.added));
    if (!d.removed.empty())
        lines << QStringLiteral("    ") + Cli::tr("segments removed: %1").arg(textOfPlaces(d.removed));
    for (const ValueDifference &v : d.values)
        lines << QStringLiteral("    ") + lineOf(v);
}

QString textOf(const Comparison &c)
{
    const PaintingDifference &d = c.difference;
    if (d.isEmpty())
        return Cli::tr("%1 and %2 hold the same painting").arg(c.nameA, c.nameB) + '\n';
    QStringList lines;
    lines << Cli::tr("%1 → %2: %3, %4 removed, %5 changed, %6 moved")
                 .arg(c.nameA, c.nameB, Cli::tr("%n stroke(s) added", nullptr, int(d.added.size())))
                 .arg(d.removed.size())
                 .arg(d.changed.size())
                 .arg(d.moved.size());
    for (const ValueDifference &v : c.values)
        lines << lineOf(v);
    for (const StrokeId id : d.removed)
        lines << QStringLiteral("- ") +
                     Cli::tr("%1, segments: %2").arg(titleOf(*c.a->find(id))).arg(c.a->find(id)->segments.size());
    for (const StrokeId id : d.added)
        lines << QStringLiteral("+ ") +
                     Cli::tr("%1, segments: %2").arg(titleOf(*c.b->find(id))).arg(c.b->find(id)->segments.size());
    for (const StrokeId id : d.changed)
        appendChanged(lines, *c.a->find(id), *c.b->find(id));
    for (const StrokeId id : d.moved)
        lines << QStringLiteral("^ ") + Cli::tr("%1: from place %2 to %3")
                                            .arg(titleOf(*c.b->find(id)))
                                            .arg(c.a->indexOf(id))
                                            .arg(c.b->indexOf(id));
    return lines.join('\n') + '\n';
}

/// The text form's value as JSON; null where there is none.
QJsonValue jsonOf(const QString &value)
{
    return QJsonDocument::fromJson('[' + value.toUtf8() + ']').array().at(0);
}

QJsonArray jsonOf(const std::vector<ValueDifference> &values)
{
    QJsonArray list;
    for (const ValueDifference &v : values)
        list.append(QJsonObject{{"path", v.path}, {"before", jsonOf(v.before)}, {"after", jsonOf(v.after)}});
    return list;
}

QJsonArray jsonOf(const std::vector<std::size_t> &places)
{
    QJsonArray list;
    for (const std::size_t place : places)
        list.append(qint64(place));
    return list;
}

QJsonArray strokesJson(const Painting &painting, const std::vector<StrokeId> &ids)
{
    QJsonArray list;
    for (const StrokeId id : ids) {
        const StrokePtr stroke = painting.find(id);
        list.append(
            QJsonObject{{"id", qint64(id)}, {"name", stroke->name}, {"segments", qint64(stroke->segments.size())}});
    }
    return list;
}

QJsonObject jsonOf(const Comparison &c)
{
    const PaintingDifference &d = c.difference;
    QJsonArray changed, moved;
    for (const StrokeId id : d.changed) {
        const StrokePtr after = c.b->find(id);
        const StrokeDifference s = differenceOf(*c.a->find(id), *after);
        changed.append(QJsonObject{{"id", qint64(id)},
                                   {"name", after->name},
                                   {"segmentsAdded", jsonOf(s.added)},
                                   {"segmentsRemoved", jsonOf(s.removed)},
                                   {"segmentsChanged", jsonOf(s.changed)},
                                   {"values", jsonOf(s.values)}});
    }
    for (const StrokeId id : d.moved)
        moved.append(QJsonObject{{"id", qint64(id)}, {"before", c.a->indexOf(id)}, {"after", c.b->indexOf(id)}});
    return {{"a", c.nameA},
            {"b", c.nameB},
            {"same", d.isEmpty()},
            {"values", jsonOf(c.values)},
            {"added", strokesJson(*c.b, d.added)},
            {"removed", strokesJson(*c.a, d.removed)},
            {"changed", changed},
            {"moved", moved}};
}

Result<Comparison> compare(const QString &nameA, const QString &nameB)
{
    Comparison out{nameA, nameB, {}, {}, {}, {}};
    for (const auto &[name, painting] : {std::pair(&nameA, &out.a), std::pair(&nameB, &out.b)}) {
        Result<Painting> loaded = paintingOf(*name);
        if (!loaded)
            return Error{loaded.error()};
        *painting = std::make_shared<const Painting>(std::move(*loaded));
    }
    out.difference = differenceOf(*out.a, *out.b);
    out.values = valuesThatDiffer(*out.a, *out.b);
    return out;
}

} // namespace

int diffCommand(const QStringList &arguments)
{
    CommandLine line("diff",
                     Cli::tr("Compares two paintings and tells what was added, removed and changed from A to B."),
                     {"A", "B"});
    line.add({"json"}, Cli::tr("Prints JSON (docs/cli.md)."));
    addDiffPictureOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    if (line.argument(0) == "-" && line.argument(1) == "-")
        return failUsage("diff", Cli::tr("only one of the two can be standard input"));
    if (const Result<void> usable = checkDiffPictureOptions(line); !usable)
        return failUsage("diff", usable.error());
    if (const QString problem = line.isSet("output") ? problemOfPictureFile(line.value("output")) : QString(); !problem.isEmpty())
        return fail(problem, ExitCode(Trouble));
    const Result<Comparison> comparison = compare(line.argument(0), line.argument(1));
    if (!comparison)
        return fail(comparison.error(), ExitCode(Trouble));
    if (line.isSet("output")) {
        if (const Result<void> drawn = writeDiffPicture(line, comparison->a, comparison->b, comparison->difference);
            !drawn)
            return fail(drawn.error(), ExitCode(Trouble));
    }
    const int printed = line.isSet("json") ? printJson(jsonOf(*comparison)) : print(textOf(*comparison));
    return printed != Done ? Trouble : comparison->difference.isEmpty() ? Same : Different;
}

} // namespace suffuse::cli
