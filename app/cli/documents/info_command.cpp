#include "app/cli/options.h"
#include "model/formats/files.h"
#include "model/painting/influence.h"
#include "model/painting/paper_presets.h"
#include "model/painting/resolution.h"
#include "render/backends.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>

namespace suffuse::cli {

namespace {

/// What `info` tells; the moment is the end.
struct Facts {
    QString file;
    FileFormat format = FileFormat::Unknown;
    qint64 bytes = 0;
    Painting painting;
    std::vector<QString> losses; ///< of a damaged file
    QString leftOut;             ///< of a foreign file, a sentence, or empty
    QString missing;             ///< linked pictures, sentences, or empty
    double resolution = 0;       ///< canvas units an inch; 0: it is not said
    Rect bounds;
    Microseconds begin = 0;
    Microseconds end = 0;
    std::vector<ChunkInfo> chunks;
};

const char *idOf(FileFormat format)
{
    switch (format) {
    case FileFormat::Suffuse:
        return "suffuse";
    case FileFormat::Text:
        return "suffuse-text";
    case FileFormat::InkCsv:
        return "ink-csv";
    case FileFormat::UniversalInk:
        return "universal-ink";
    case FileFormat::Excalidraw:
        return "excalidraw";
    case FileFormat::MyPaintEvents:
        return "mypaint-events";
    case FileFormat::DiffusionCurves:
        return "diffusion-curves";
    case FileFormat::Svg:
        return "svg";
    case FileFormat::OpenRaster:
        return "openraster";
    case FileFormat::Photoshop:
        return "photoshop";
    case FileFormat::Xournal:
        return "xournal";
    case FileFormat::InkMl:
        return "inkml";
    case FileFormat::Rnote:
        return "rnote";
    case FileFormat::Pdf:
        return "pdf";
    case FileFormat::Unknown:
        break;
    }
    return "unknown";
}

const char *idOf(PaperKind kind)
{
    return kind == PaperKind::None ? "none" : kind == PaperKind::Procedural ? "procedural" : "image";
}

const char *idOf(PaperGrain grain)
{
    return grain == PaperGrain::Tooth ? "tooth" : grain == PaperGrain::Fibres ? "fibres" : "weave";
}

/// The paper, and which grain it has where it has one.
QString paperText(const Paper &paper)
{
    const int preset = presetOf(paper);
    const QString kind = QLatin1String(idOf(paper.kind));
    if (paper.kind != PaperKind::Procedural)
        return kind;
    const QString grain = QLatin1String(idOf(paper.grain));
    return preset < 0 ? QStringLiteral("%1, %2").arg(kind, grain)
                      : QStringLiteral("%1, %2 (%3)").arg(kind, grain, titleOf(paperPresets()[std::size_t(preset)]));
}

Result<QByteArray> readInput(const QString &path)
{
    QFile file(path);
    const bool opened = path == "-" ? file.open(stdin, QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly);
    if (!opened)
        return Error{QCoreApplication::translate("Cli", "%1: cannot be read (%2). Check the name and its permissions.")
                         .arg(path, file.errorString())};
    QByteArray bytes;
    constexpr qint64 step = 16 << 20, most = qint64(2) << 30; // what the loader takes
    for (QByteArray part = file.read(step); !part.isEmpty() && bytes.size() <= most; part = file.read(step))
        bytes += part;
    if (file.error() != QFileDevice::NoError)
        return Error{QCoreApplication::translate("Cli", "%1: cannot be read (%2). Check the name and its permissions.")
                         .arg(path, file.errorString())};
    if (bytes.size() > most)
        return Error{
            QCoreApplication::translate("Cli", "%1: has more than 2 GB; that is more than can be opened").arg(path)};
    return bytes;
}

Result<Facts> factsOf(const QString &path)
{
    // The painting first: its loader knows every way in which a file can be bad.
    Facts facts;
    facts.file = path;
    QByteArray bytes;
    if (path == "-" || QFileInfo(path).isFile()) {
        const Result<QByteArray> input = readInput(path);
        if (!input)
            return Error{input.error()};
        bytes = *input;
    }
    Result<LoadedDocument> document = bytes.isEmpty() && path != "-" ? loadDocument(path) : readDocument(bytes, path);
    if (!document)
        return Error{document.error()};
    facts.painting = std::move(document->painting);
    facts.losses = std::move(document->losses);
    if (document->format == FileFormat::Suffuse) { // then it is damage
        if (!document->leftOut.isEmpty())
            facts.losses.push_back(document->leftOut);
    } else {
        facts.leftOut = document->leftOut;
    }
    facts.missing = document->missing;
    facts.resolution = document->extras.resolution;
    facts.format = detectFormat(bytes);
    facts.bytes = bytes.size();
    facts.end = facts.painting.end();
    facts.begin = facts.end;
    for (const StrokePtr &s : facts.painting.strokes)
        facts.begin = std::min(facts.begin, s->born());
    facts.bounds = influenceOf(facts.painting, facts.end);
    if (facts.format == FileFormat::Suffuse) {
        Result<std::vector<ChunkInfo>> chunks = suffuseChunks(bytes, path);
        if (!chunks)
            return Error{chunks.error()};
        facts.chunks = std::move(*chunks);
    }
    return facts;
}

/// How many groups there are of each kind that is more than strokes which stand together.
struct GroupCounts {
    explicit GroupCounts(const std::vector<Group> &groups)
        : blending(std::ranges::count_if(groups, &Group::isIsolated)),
          clipped(std::ranges::count_if(groups, &Group::clips)), masks(std::ranges::count_if(groups, &Group::mask)),
          washes(std::ranges::count_if(groups, [](const Group &group) { return group.wash.has_value(); })),
          solo(std::ranges::count_if(groups, &Group::solo)), drafts(std::ranges::count_if(groups, &Group::draft))
    {}

    qint64 blending, clipped, masks, washes, solo, drafts;
};

qint64 picturesIn(const Painting &painting)
{
    return std::ranges::count_if(painting.strokes, [](const StrokePtr &stroke) { return bool(stroke->picture); });
}

QJsonObject jsonOf(const Facts &f)
{
    const Canvas &canvas = f.painting.canvas;
    const Colour &b = canvas.background;
    const GroupCounts counts(f.painting.groups);
    QJsonObject object{
        {"file", f.file},
        {"format", idOf(f.format)},
        {"bytes", f.bytes},
        {"canvas",
         QJsonObject{{"width", canvas.width},
                     {"height", canvas.height},
                     {"background", QJsonArray{double(b.red), double(b.yellow), double(b.blue), double(b.opacity)}},
                     {"resolution", isResolution(f.resolution) ? QJsonValue(f.resolution) : QJsonValue()},
                     {"paper", idOf(canvas.paper.kind)},
                     {"grain", canvas.paper.kind == PaperKind::Procedural ? QJsonValue(idOf(canvas.paper.grain))
                                                                          : QJsonValue()}}},
        {"strokes", qint64(f.painting.strokes.size())},
        {"segments", qint64(f.painting.segmentCount())},
        {"groups", qint64(f.painting.groups.size())},
        {"blendingGroups", counts.blending},
        {"clippedGroups", counts.clipped},
        {"masks", counts.masks},
        {"washes", counts.washes},
        {"soloGroups", counts.solo},
        {"drafts", counts.drafts},
        {"pictures", picturesIn(f.painting)},
        {"begin", toSeconds(f.begin)},
        {"end", toSeconds(f.end)},
        {"duration", toSeconds(f.end - f.begin)},
        {"bounds", QJsonValue()}};
    if (!f.bounds.isEmpty())
        object["bounds"] = QJsonArray{f.bounds.left, f.bounds.top, f.bounds.width(), f.bounds.height()};
    QJsonArray chunks;
    for (const ChunkInfo &c : f.chunks)
        chunks.append(QJsonObject{{"name", c.name}, {"start", c.start}, {"bytes", c.bytes}, {"damage", c.damage}});
    object["chunks"] = chunks;
    object["leftOut"] = f.leftOut;
    object["missing"] = f.missing;
    object["losses"] = QJsonArray::fromStringList(QStringList(f.losses.begin(), f.losses.end()));
    return object;
}

/// What a chunk beside the picture is for; empty for those of the picture.
QString meaningOf(const QString &name)
{
    if (name == QLatin1String("prev"))
        return QCoreApplication::translate("Cli", "preview");
    if (name == QLatin1String("view"))
        return QCoreApplication::translate("Cli", "how it was last looked at");
    if (name == QLatin1String("hist"))
        return QCoreApplication::translate("Cli", "undo history");
    if (name == QLatin1String("prof"))
        return QCoreApplication::translate("Cli", "colour profile");
    if (name == QLatin1String("inch"))
        return QCoreApplication::translate("Cli", "size on paper");
    return name.isEmpty() || name.front().isUpper()
               ? QString()
               : QCoreApplication::translate("Cli", "unknown to this version, kept");
}

QString lineOf(const ChunkInfo &c)
{
    if (!c.damage.isEmpty())
        return QCoreApplication::translate("Cli", "  chunk     %1 at byte %2 is damaged: %3")
            .arg(c.name.isEmpty() ? QStringLiteral("?") : c.name)
            .arg(c.start)
            .arg(c.damage);
    const QString line = QCoreApplication::translate("Cli", "  chunk     %1, %2 bytes").arg(c.name).arg(c.bytes);
    const QString meaning = meaningOf(c.name);
    return meaning.isEmpty() ? line : QStringLiteral("%1 (%2)").arg(line, meaning);
}

QString groupsLine(const Painting &painting)
{
    const GroupCounts counts(painting.groups);
    QStringList said{QCoreApplication::translate("Cli", "  groups    %1").arg(painting.groups.size())};
    if (counts.blending > 0)
        said << QCoreApplication::translate("Cli", "%1 of them blending").arg(counts.blending);
    if (counts.clipped > 0)
        said << QCoreApplication::translate("Cli", "%1 clipped").arg(counts.clipped);
    if (counts.masks > 0)
        said << QCoreApplication::translate("Cli", "%1 masking").arg(counts.masks);
    if (counts.washes > 0)
        said << QCoreApplication::translate("Cli", "%1 a wash").arg(counts.washes);
    if (counts.solo > 0)
        said << QCoreApplication::translate("Cli", "%1 shown alone").arg(counts.solo);
    if (counts.drafts > 0)
        said << QCoreApplication::translate("Cli", "%1 a draft").arg(counts.drafts);
    return said.join(QLatin1String(", "));
}

QString textOf(const Facts &f)
{
    const Canvas &canvas = f.painting.canvas;
    QStringList lines{
        QStringLiteral("%1: %2").arg(f.file, nameOf(f.format)),
        QCoreApplication::translate("Cli", "  bytes     %1").arg(f.bytes),
        QCoreApplication::translate("Cli", "  canvas    %1 × %2").arg(canvas.width).arg(canvas.height),
        QCoreApplication::translate("Cli", "  paper     %1").arg(paperText(canvas.paper)),
        QCoreApplication::translate("Cli", "  strokes   %1").arg(f.painting.strokes.size()),
        QCoreApplication::translate("Cli", "  segments  %1").arg(f.painting.segmentCount()),
        groupsLine(f.painting),
        f.bounds.isEmpty() ? QCoreApplication::translate("Cli", "  bounds    none: nothing is painted")
                           : QCoreApplication::translate("Cli", "  bounds    x %1, y %2, %3 × %4")
                                 .arg(f.bounds.left, 0, 'f', 1)
                                 .arg(f.bounds.top, 0, 'f', 1)
                                 .arg(f.bounds.width(), 0, 'f', 1)
                                 .arg(f.bounds.height(), 0, 'f', 1),
        QCoreApplication::translate("Cli", "  duration  %1 s").arg(toSeconds(f.end - f.begin), 0, 'f', 3)};
    if (isResolution(f.resolution)) {
        const auto onPaper = [&f](double side) {
            return QString::number(side / f.resolution * millimetresOfInch, 'f', 1);
        };
        lines.insert(3, QCoreApplication::translate("Cli", "  on paper  %1 × %2 mm, %3 units an inch")
                            .arg(onPaper(canvas.width), onPaper(canvas.height))
                            .arg(f.resolution));
    }
    if (const qint64 pictures = picturesIn(f.painting); pictures > 0)
        lines.append(QCoreApplication::translate("Cli", "  pictures  %1").arg(pictures));
    for (const ChunkInfo &c : f.chunks)
        lines.append(lineOf(c));
    return lines.join('\n') + '\n';
}

int printBackends(bool json)
{
    QString text;
    QJsonArray list;
    for (const BackendInfo &b : backends()) {
        list.append(QJsonObject{{"name", nameOf(b.backend)},
                                {"device", b.device},
                                {"available", b.unavailable.isEmpty()},
                                {"reason", b.unavailable}});
        text += b.unavailable.isEmpty() ? QStringLiteral("%1%2\n").arg(nameOf(b.backend), -11).arg(b.device)
                                        : QCoreApplication::translate("Cli", "%1not available: %2")
                                                  .arg(nameOf(b.backend), -11)
                                                  .arg(b.unavailable) +
                                              '\n';
    }
    return json ? printJson({{"backends", list}}) : print(text);
}

} // namespace

int infoCommand(const QStringList &arguments)
{
    CommandLine line("info", QCoreApplication::translate("Cli", "Tells what a painting or a recording holds."), {"IN"});
    line.add({"json"}, QCoreApplication::translate("Cli", "Prints JSON (docs/cli.md)."));
    line.add({"backends"},
             QCoreApplication::translate("Cli", "The backends and devices there are, and why one is missing."));
    if (const std::optional<int> code = line.parse(arguments, 0))
        return *code;
    if (line.isSet("backends") == !line.argument(0).isEmpty())
        return failUsage("info", QCoreApplication::translate("Cli", "give a file, or --backends"));
    if (line.isSet("backends"))
        return printBackends(line.isSet("json"));
    const Result<Facts> facts = factsOf(line.argument(0));
    if (!facts)
        return fail(facts.error());
    const int printed = line.isSet("json") ? printJson(jsonOf(*facts)) : print(textOf(*facts));
    for (const QString &said : {facts->leftOut, facts->missing})
        if (!said.isEmpty())
            warn(QStringLiteral("%1: %2").arg(line.argument(0), said));
    for (const QString &loss : facts->losses)
        warn(QStringLiteral("%1: %2").arg(line.argument(0), loss));
    return facts->losses.empty() ? printed : Failed;
}

} // namespace suffuse::cli
