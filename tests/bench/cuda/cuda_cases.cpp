#include "tests/bench/cuda/cuda_cases.h"

#include "model/formats/files.h"

namespace suffuse {

namespace {

/// The samples that come with the program; each is drawn at the widths below.
const QStringList samples{"ink-landscape", "still-life", "flat", "moonrise", "lanterns", "sheet"};
constexpr int sampleWidths[] = {512, 1024, 2048};

std::vector<CudaCase> cases()
{
    bench::PaintingOptions wide, million;
    wide.spreadLow = 32;
    wide.spreadHigh = 72;
    million.strokes = 1'000'000 / 23;
    million.segments = 1'000'000;
    million.width = 3840;
    million.height = 2160;
    std::vector<CudaCase> all{{"figure11f", {}, 1024, {}},
                              {"figure11f-2880", {}, 2880, {}},
                              {"spread-32-72", wide, 1024, {}},
                              {"million", million, 3840, {}}};
    for (const QString &sample : samples)
        for (const int width : sampleWidths)
            all.push_back({QStringLiteral("%1-%2").arg(sample).arg(width), {}, width, sample});
    return all;
}

} // namespace

QStringList filledCases()
{
    return {"shapes-1000", "shapes-1000-crisp", "disc-8", "disc-100", "coast-100000"};
}

QStringList sampleCases()
{
    QStringList names;
    for (const CudaCase &c : cases())
        if (!c.sample.isEmpty())
            names << c.name;
    return names;
}

Result<CudaCase> caseOf(const QString &name)
{
    for (const CudaCase &c : cases())
        if (c.name == name)
            return c;
    if (filledCases().contains(name))
        return CudaCase{name, {}, 1024, {}};
    return Error{QStringLiteral("there is no painting %1").arg(name)};
}

QString &samplesFolder()
{
    static QString folder = QStringLiteral("packaging/samples");
    return folder;
}

Result<PaintingPtr> paintingOf(const CudaCase &c)
{
    if (c.sample.isEmpty())
        return std::make_shared<const Painting>(bench::makePainting(c.painting));
    Result<LoadedDocument> loaded = loadDocument(QStringLiteral("%1/%2.suffuse").arg(samplesFolder(), c.sample));
    if (!loaded)
        return Error{loaded.error()};
    return std::make_shared<const Painting>(std::move(loaded->painting));
}

} // namespace suffuse
