// Which figures a bench measures: the rows of the performance page, one after the other.
#pragma once

#include "render/bench/generator.h"
#include "render/bench/measure.h"

#include <QStringList>

#include <functional>

namespace suffuse::bench {

/// What is measured. Without `painting`, a painting is generated from `generated`.
struct Plan {
    PaintingPtr painting; ///< null: a painting is generated
    QString name = QStringLiteral("figure11f");
    PaintingOptions generated;
    MakeRenderer make; ///< makeRenderer (render/backends.h)
    /// the backends, one after the other; their `threads` come from `threads` below
    std::vector<RendererOptions> devices;
    /// full renders are measured with each number, the rest with the last; 0: all cores
    std::vector<int> threads{0};
    std::vector<int> widths; ///< widths of full renders in pixels; the rest is measured at the first
    std::vector<int> growth; ///< segments of the growth rows
    bool table2 = false;     ///< whether all paintings of the paper's Table 2 are rendered, too
    QStringList only;        ///< names of rows (all those of "growth" have this name); empty: all rows
    int runs = 9;
    const std::atomic<bool> *cancel = nullptr;
};

/// All names that `Plan::only` may have.
QStringList rowNames();

/// Measures the figures. `progress`, which may be empty, is told what is measured next (translated).
Result<std::vector<Row>> run(const Plan &plan, const std::function<void(const QString &)> &progress = {});

} // namespace suffuse::bench
