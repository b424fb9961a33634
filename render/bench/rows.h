// What a bench reports: rows, as JSON and as a table.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace suffuse::bench {

/// Of the times of several runs.
struct Timing {
    double medianMs = 0;
    double minMs = 0;
    int runs = 0;
};
/// Median (of an even number: the mean of the middle two) and minimum. Zero runs give zeros.
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
    QString baseline;            ///< the method timed, or the row compared with; empty: none
    std::optional<double> ratio; ///< this median over that of the row it is compared with
};

/// A JSON array with one object a row, UTF-8.
QByteArray toJson(const std::vector<Row> &rows);
/// Aligned columns with a heading.
QString toTable(const std::vector<Row> &rows);

} // namespace suffuse::bench
