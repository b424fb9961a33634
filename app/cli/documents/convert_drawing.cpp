#include "app/cli/documents/convert_drawing.h"

#include "app/cli/progress.h"
#include "render/backends.h"
#include "render/drawing/drawing_file.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <cmath>

namespace suffuse::cli {

namespace {

Result<DrawingOptions> drawingOptions(const CommandLine &line, const Painting &painting)
{
    DrawingOptions options;
    const QString as = line.isSet("as") ? line.value("as") : QStringLiteral("bands");
    if (as == QLatin1String("outlines"))
        options.kind = DrawingKind::Outlines;
    else if (as == QLatin1String("hybrid"))
        options.kind = DrawingKind::Hybrid;
    else if (as != QLatin1String("bands"))
        return Error{QCoreApplication::translate("Cli", "--as %1: give outlines, bands or hybrid").arg(as)};
    if (line.isSet("bands")) {
        const std::optional<double> bands = toNumber(line.value("bands"));
        if (!bands || *bands != std::floor(*bands) || *bands < 1 || *bands > mostBands)
            return Error{QCoreApplication::translate("Cli", "--bands %1: give a whole number from 1 to %2")
                             .arg(line.value("bands"))
                             .arg(mostBands)};
        if (options.kind != DrawingKind::Bands)
            return Error{QCoreApplication::translate("Cli", "--bands is for --as bands; leave one of them out")};
        options.bands = int(*bands);
    }
    const Result<Microseconds> time = timeOption(line, painting);
    if (!time)
        return Error{time.error()};
    options.time = *time;
    return options;
}

} // namespace

void addDrawingOptions(CommandLine &line)
{
    line.add({"as"},
             QCoreApplication::translate(
                 "Cli", "Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands "
                        "(contours within each other, as opaque as the paint; the default) or "
                        "hybrid (the exact picture under unpainted outlines)."),
             "KIND");
    line.add({"bands"}, QCoreApplication::translate("Cli", "How many bands full opacity has, 1 to 256 (default: 16)."),
             "K");
    line.add({"time"}, QCoreApplication::translate("Cli", "The moment that is drawn, in seconds (default: all dried)."),
             "SECONDS");
    line.add({"page"},
             QCoreApplication::translate("Cli", "Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm "
                                                "or 8x6in, into which the sheet fits (default: the sheet as large as "
                                                "it is on paper; where that is not said, 96 units are an inch)."),
             "SIZE");
}

QString drawingProblem(const CommandLine &line, std::optional<DrawingFormat> format)
{
    for (const char *option : {"as", "bands", "time"})
        if (line.isSet(option) && !format)
            return QCoreApplication::translate("Cli", "--%1 is for drawings; give OUT the ending .svg or .pdf")
                .arg(QLatin1String(option));
    if (!line.isSet("page"))
        return {};
    if (format != DrawingFormat::Pdf)
        return QCoreApplication::translate("Cli", "--page is for PDF; give OUT the ending .pdf");
    if (!pageSizeFrom(line.value("page")))
        return QCoreApplication::translate("Cli", "--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or "
                                                  "8x6in")
            .arg(line.value("page"));
    return {};
}

namespace {

/// Draws one of the paintings, with a line on stderr that says how far it is.
Result<PreparedDrawing> drawnPage(const Painting &painting, DrawingOptions &options, Renderer &renderer)
{
    std::optional<ProgressLine> progress(QCoreApplication::translate("Cli", "Drawing"));
    options.progress = [&](int done, int all) { progress->show(done, all); };
    return prepareDrawing(std::make_shared<const Painting>(painting), options, renderer);
}

} // namespace

int convertToDrawing(const CommandLine &line, const std::vector<LoadedDocument> &documents, DrawingFormat format,
                     const QString &out)
{
    const bool isToStdout = out == QLatin1String("-");
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
    if (!renderer)
        return fail(renderer.error());
    std::vector<PreparedDrawing> drawings;
    std::vector<Painting> paintings;
    for (std::size_t k = 0; k < documents.size(); ++k) {
        const Painting &painting = documents[k].painting;
        Result<DrawingOptions> options = drawingOptions(line, painting);
        if (!options)
            return failUsage("convert", options.error());
        options->format = format;
        options->cancel = &interrupted();
        Result<PreparedDrawing> prepared = drawnPage(painting, *options, **renderer);
        if (!prepared)
            return fail(QStringLiteral("%1: %2").arg(out, prepared.error()));
        (*renderer)->invalidate();
        // Which of several it is about.
        const QString name = documents.size() > 1 ? line.several().at(qsizetype(k)) : out;
        if (const QString leftOut = leftOutOf(*prepared); !leftOut.isEmpty())
            warn(QStringLiteral("%1: %2").arg(name, leftOut));
        const QString difference =
            (documents.size() > 1 ? name + QStringLiteral(": ") : QString()) + differenceText(prepared->difference);
        if (isToStdout)
            warn(difference);
        else if (const int code = print(difference + QLatin1Char('\n')); code != Done)
            return code;
        if (line.isSet("page"))
            prepared->paper = pageSizeFrom(line.value("page"));
        prepared->resolution = documents[k].extras.resolution;
        drawings.push_back(std::move(*prepared));
        paintings.push_back(painting);
    }
    drawings.front().about = {isToStdout ? QString() : QFileInfo(out).completeBaseName(),
                              documents.front().extras.profile};
    const QString name = isToStdout ? QStringLiteral("svg") : out;
    const Result<QByteArray> bytes = bytesOf(drawings, paintings, name, &interrupted());
    if (!bytes)
        return fail(bytes.error());
    if (isToStdout)
        return printBytes(*bytes);
    const Result<void> saved = writeFileAtomically(out, *bytes);
    return saved ? Done : fail(saved.error());
}

} // namespace suffuse::cli
