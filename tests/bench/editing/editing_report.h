// How benches of the window tell what they measured: for people, or for programs.
#pragma once

#include "tests/bench/editing/editing_session.h"

#include <QJsonObject>

namespace suffuse {

/// One line of the report, with the names and the values of its columns.
struct Row {
    QString name;
    std::vector<std::pair<QString, double>> values;
};

struct Report {
    QString title;
    std::vector<Row> rows;
};

/// Median, 99th percentile and maximum.
Row rowOf(const QString &name, const Times &times);
/// The same, and what else there is to say of events at the pace of a hand.
Row rowOf(const QString &name, const DragTimes &times);
void print(const Report &report);
QJsonObject jsonOf(const Report &report);

} // namespace suffuse
