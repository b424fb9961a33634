// What a bench reports: rows, as JSON and as a table.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace suffuse::bench {

/// The times of several runs, summed up.
struct Timing {
    double medianMs = 0;
    double minMs = 0;
    int runs = 0;
};
/// The median (of an even number, the mean of the middle two) and the minimum. Without runs both are zero.
Timing timingOf(std::vector<double> milliseconds);

/// One figure (docs/cli.md describes the members).
struct Row {
    QString name;    ///< "full-render", "drag" …
    QString backend; ///< "CPU"
    QString device;  ///< "2 threads · AVX2"
    QString painting;
    int width = 0; ///< pixels
    int height = 0;
    int threads = 0;
    Timing timing;
    QString baseline;            ///< the method that was measured, or the row that it is compared with; empty: none
    std::optional<double> ratio; ///< this median divided by that of the row it is compared with
};

/// A JSON array with one object for each row, UTF-8.
QByteArray toJson(const std::vector<Row> &rows);
/// A table of aligned columns with a heading.
QString toTable(const std::vector<Row> &rows);

} // namespace suffuse::bench
