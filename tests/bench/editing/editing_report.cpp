#include "tests/bench/editing/editing_report.h"

#include <QJsonArray>
#include <QTextStream>

#include <cmath>

namespace suffuse {

Row rowOf(const QString &name, const Times &times)
{
    return {name, {{"median", times.at(0.5)}, {"p99", times.at(0.99)}, {"max", times.at(1)}}};
}

Row rowOf(const QString &name, const DragTimes &times)
{
    Row row = rowOf(name, times.toFrame);
    row.values.insert(row.values.end(), {{"frames/s", times.framesASecond},
                                         {"coarse %", times.coarse},
                                         {"frame ms", times.frameMs},
                                         {"GUI ms", times.guiMs},
                                         {"all ms", times.allMs},
                                         {"skipped", double(times.skipped)}});
    return row;
}

void print(const Report &report)
{
    QTextStream out(stdout);
    if (report.rows.empty())
        return;
    out << "\n" << report.title << "\n" << QString().leftJustified(34);
    for (const auto &[column, value] : report.rows.front().values)
        out << ' ' << column.rightJustified(std::max(9, int(column.size())));
    out << '\n';
    for (const Row &row : report.rows) {
        out << row.name.leftJustified(34);
        for (const auto &[column, value] : row.values)
            out << ' '
                << QString::number(value, 'f', std::abs(value) < 1e4 ? 2 : 0)
                       .rightJustified(std::max(9, int(column.size())));
        out << '\n';
    }
}

QJsonObject jsonOf(const Report &report)
{
    QJsonArray rows;
    for (const Row &row : report.rows) {
        QJsonObject values{{"name", row.name}};
        for (const auto &[column, value] : row.values)
            values[column] = value;
        rows << values;
    }
    return {{"title", report.title}, {"rows", rows}};
}

} // namespace suffuse
