#include "app/cli/stroke_choice.h"

#include <QCoreApplication>
#include <QStringList>

namespace suffuse::cli {

Result<std::unordered_set<StrokeId>> strokesNamed(const QString &text, const Painting &painting)
{
    std::unordered_set<StrokeId> out;
    for (const QString &part : text.split(QLatin1Char(','))) {
        const QStringList ends = part.split(QLatin1Char('-'));
        bool isFirst = false, isLast = false;
        const qulonglong first = ends.first().toULongLong(&isFirst), last = ends.last().toULongLong(&isLast);
        if (!isFirst || !isLast || ends.size() > 2 || last < first)
            return Error{
                QCoreApplication::translate("Cli", "--select %1: give ids of strokes, such as 3,7,20-180").arg(text)};
        const std::size_t before = out.size();
        for (const StrokePtr &stroke : painting.strokes)
            if (stroke->id >= first && stroke->id <= last)
                out.insert(stroke->id);
        if (out.size() == before)
            return Error{QCoreApplication::translate("Cli",
                                                     "--select %1: there is no stroke %2; suffuse-cli convert IN "
                                                     "OUT.json shows the ids")
                             .arg(text, part)};
    }
    return out;
}

Result<GroupId> layerNamed(const QString &name, const Painting &painting)
{
    GroupId layer = 0;
    for (const Group &group : painting.groups) {
        if (group.name != name)
            continue;
        if (layer)
            return Error{
                QCoreApplication::translate("Cli", "--layer %1: several groups have that name; rename one of them")
                    .arg(name)};
        layer = group.id;
    }
    if (!layer)
        return Error{QCoreApplication::translate("Cli", "--layer %1: there is no group of that name").arg(name)};
    return layer;
}

} // namespace suffuse::cli
