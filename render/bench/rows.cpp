#include "render/bench/rows.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace suffuse::bench {

namespace {

/// A number to four places: to a tenth of a microsecond where the unit is milliseconds.
double rounded(double value)
{
    return std::round(value * 1e4) / 1e4;
}

QString msText(double ms)
{
    return QString::number(ms, 'f', ms < 1 ? 4 : 2);
}

QJsonValue textOrNull(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

QStringList cellsOf(const Row &row)
{
    return {row.name,
            row.baseline,
            row.painting,
            QStringLiteral("%1×%2").arg(row.width).arg(row.height),
            row.backend,
            row.device,
            msText(row.timing.medianMs),
            msText(row.timing.minMs),
            QString::number(row.timing.runs),
            row.ratio ? QString::number(*row.ratio, 'f', 2) : QString()};
}

} // namespace

Timing timingOf(std::vector<double> ms)
{
    if (ms.empty())
        return {};
    std::sort(ms.begin(), ms.end());
    const std::size_t half = ms.size() / 2;
    return {ms.size() % 2 == 1 ? ms[half] : 0.5 * (ms[half - 1] + ms[half]), ms.front(), int(ms.size())};
}

QByteArray toJson(const std::vector<Row> &rows)
{
    QJsonArray array;
    for (const Row &row : rows)
        array.append(QJsonObject{{"name", row.name},
                                 {"backend", row.backend},
                                 {"device", row.device},
                                 {"painting", row.painting},
                                 {"width", row.width},
                                 {"height", row.height},
                                 {"threads", row.threads},
                                 {"median_ms", rounded(row.timing.medianMs)},
                                 {"min_ms", rounded(row.timing.minMs)},
                                 {"runs", row.timing.runs},
                                 {"baseline", textOrNull(row.baseline)},
                                 {"ratio", row.ratio ? QJsonValue(rounded(*row.ratio)) : QJsonValue()}});
    return QJsonDocument(array).toJson(QJsonDocument::Indented);
}

QString toTable(const std::vector<Row> &rows)
{
    static constexpr const char *heading[] = {
        QT_TRANSLATE_NOOP("Bench", "name"),      QT_TRANSLATE_NOOP("Bench", "compared"),
        QT_TRANSLATE_NOOP("Bench", "painting"),  QT_TRANSLATE_NOOP("Bench", "size"),
        QT_TRANSLATE_NOOP("Bench", "backend"),   QT_TRANSLATE_NOOP("Bench", "device"),
        QT_TRANSLATE_NOOP("Bench", "median ms"), QT_TRANSLATE_NOOP("Bench", "min ms"),
        QT_TRANSLATE_NOOP("Bench", "runs"),      QT_TRANSLATE_NOOP("Bench", "ratio")};
    std::vector<QStringList> lines(1);
    for (const char *cell : heading)
        lines.front().append(QCoreApplication::translate("Bench", cell));
    for (const Row &row : rows)
        lines.push_back(cellsOf(row));
    constexpr int firstNumber = 6;
    QString text;
    for (const QStringList &line : lines) {
        QString out;
        for (int i = 0; i < line.size(); ++i) {
            qsizetype width = 0;
            for (const QStringList &other : lines)
                width = std::max(width, other.at(i).size());
            const QString cell = i < firstNumber ? line.at(i).leftJustified(width) : line.at(i).rightJustified(width);
            out += cell + QStringLiteral("  ");
        }
        while (out.endsWith(QLatin1Char(' ')))
            out.chop(1);
        text += out + QLatin1Char('\n');
    }
    return text;
}

} // namespace suffuse::bench
