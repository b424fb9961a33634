// Which figures a bench takes: the rows of the performance page, one after the other.
#pragma once

#include "render/bench/generator.h"
#include "render/bench/measure.h"

#include <QStringList>

#include <functional>

namespace suffuse::bench {

/// What is measured. Without `painting`, a painting is generated from `generated`.
struct Plan {
    PaintingPtr painting; ///< null: generate one
    QString name = QStringLiteral("figure11f");
    PaintingOptions generated;
    MakeRenderer make;                    ///< makeRenderer (render/backends.h)
    std::vector<RendererOptions> devices; ///< backends, one after the other; `threads` is taken from `threads` below
    std::vector<int> threads{0};          ///< full renders are taken with each, the rest with the last; 0: all cores
    std::vector<int> widths;              ///< of full renders, pixels; the rest is taken at the first
    std::vector<int> growth;              ///< segments of the growth rows
    bool table2 = false;                  ///< full renders of all paintings of the paper's Table 2 too
    QStringList only;                     ///< names of rows ("growth": all of them); empty: all
    int runs = 9;
    const std::atomic<bool> *cancel = nullptr;
};

/// Every name that `Plan::only` may hold.
QStringList rowNames();

/// Takes the figures. `progress` is told what is measured next (translated); may be empty.
Result<std::vector<Row>> run(const Plan &plan, const std::function<void(const QString &)> &progress = {});

} // namespace suffuse::bench
