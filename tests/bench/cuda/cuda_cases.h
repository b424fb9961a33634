// What bench_cuda draws, and facts that it finds.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"
#include "render/bench/generator.h"

#include <QStringList>

#include <vector>

namespace suffuse {

/// What is no time: operations a second, frames a second, differences.
struct CudaFact {
    QString name;
    QString painting;
    double value = 0;
    QString unit;
};

/// A painting and the width that it is drawn at.
struct CudaCase {
    QString name;
    bench::PaintingOptions painting;
    int width = 1024;
    QString sample; ///< a file of the samples' folder, instead of a generated painting
};

/// The paintings that the group "fills" makes.
QStringList filledCases();
/// The names of the samples' cases.
QStringList sampleCases();
/// The case of that name.
Result<CudaCase> caseOf(const QString &name);
/// Where `--samples` says that the samples lie.
QString &samplesFolder();
/// Generated, or read from the samples' folder.
Result<PaintingPtr> paintingOf(const CudaCase &c);

} // namespace suffuse
