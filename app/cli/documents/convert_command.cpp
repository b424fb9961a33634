#include "app/cli/documents/convert_drawing.h"
#include "model/formats/brushes/brush_file.h"
#include "model/formats/files.h"
#include "model/formats/picture_links.h"
#include "render/drawing/drawing_file.h"
#include "render/image_io/image_io.h"
#include "render/layered/layered_file.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace suffuse::cli {

namespace {

/// A built-in brush by its name, or the brush of a file.
Result<Brush> brushOf(const QString &value)
{
    if (const Brush *builtin = findBrush(value))
        return *builtin;
    if (QFileInfo(value).isFile()) {
        Result<LoadedBrush> loaded = loadBrush(value);
        return loaded ? Result<Brush>(loaded->brush) : Result<Brush>(Error{loaded.error()});
    }
    QStringList names;
    for (const Brush &b : builtinBrushes())
        names.append(b.name);
    return Error{
        QCoreApplication::translate("Cli", "--brush %1: there is no such brush nor file; choose a file or one of %2")
            .arg(value, names.join(QStringLiteral(", ")))};
}

/// The drawing that OUT is to be, if it is one.
std::optional<DrawingFormat> drawingFormatOf(const CommandLine &line, const QString &out)
{
    return drawingFormatFor(out == QLatin1String("-") ? QLatin1Char('.') + line.value("format") : out);
}

/// By OUT's ending, or by --format where OUT is standard output; Unknown for drawings. Errors are usage errors.
Result<FileFormat> formatOf(const CommandLine &line, const QString &out)
{
    const bool isToStdout = out == QLatin1String("-");
    if (!isToStdout && line.isSet("format"))
        return Error{
            QCoreApplication::translate("Cli", "--format is for an OUT of -; the ending of %1 chooses the format")
                .arg(out)};
    if (drawingFormatOf(line, out))
        return FileFormat::Unknown;
    const FileFormat format =
        formatForSaving(isToStdout ? QLatin1Char('.') + (line.isSet("format") ? line.value("format") : "json") : out);
    if (format != FileFormat::Unknown)
        return format;
    if (!isToStdout &&
        (imageFormatForPath(out) != ImageFormat::Unknown || layeredFormatFor(out) != LayeredFormat::None))
        return Error{QCoreApplication::translate("Cli", "%1 is a picture: suffuse-cli render IN -o OUT writes pictures")
                         .arg(out)};
    return Error{
        isToStdout ? QCoreApplication::translate("Cli", "--format %1: give suffuse, json, svg or pdf")
                         .arg(line.value("format"))
                   : QCoreApplication::translate("Cli", "%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf")
                         .arg(out)};
}

/// What goes wrong with --fit and --strokes; empty if nothing does.
QString fitProblem(const CommandLine &line)
{
    if (!line.isSet("fit"))
        return line.isSet("strokes")
                   ? QCoreApplication::translate("Cli", "--strokes goes with --fit, which makes strokes of a picture")
                   : QString();
    for (const char *option : {"brush", "format", "plain", "salvage", "as"})
        if (line.isSet(QLatin1String(option)))
            return QCoreApplication::translate("Cli", "--%1 says nothing of a picture that is fitted; leave it out")
                .arg(QLatin1String(option));
    if (line.several().size() > 1)
        return QCoreApplication::translate("Cli", "--fit takes one IN at a time");
    return {};
}

/// The painting with links to pictures that hold from another file's folder.
Painting movedTo(const QString &out, const QString &in, const Painting &painting)
{
    const QString from = QFileInfo(in).absolutePath(), to = QFileInfo(out).absolutePath();
    return from == to ? painting : withRelativeLinks(withAbsoluteLinks(painting, from), to);
}

/// A document as it is converted. What it has and nobody can write is said; it fails where too little is whole.
Result<LoadedDocument> documentOf(const QString &in, const Brush *brush, bool salvages)
{
    Result<LoadedDocument> document = loadDocument(in, brush);
    if (!document)
        return document;
    for (const QString &said : {document->leftOut, document->missing})
        if (!said.isEmpty())
            warn(QStringLiteral("%1: %2").arg(in, said));
    using enum FileFormat;
    if (const FileFormat format = document->format;
        brush && (format == Suffuse || format == Text || format == DiffusionCurves || format == Pdf))
        warn(QCoreApplication::translate("Cli", "--brush is ignored: the strokes of %1 have their looks already")
                 .arg(in));
    for (const QString &loss : document->losses)
        warn(QStringLiteral("%1: %2").arg(in, loss));
    if (!document->losses.empty() && !salvages)
        return Error{
            QCoreApplication::translate("Cli", "%1: is damaged; --salvage writes what is whole of it").arg(in)};
    if (document->lostStrokes > 0 && document->painting.strokes.empty())
        return Error{QCoreApplication::translate("Cli", "%1: none of its %n stroke(s) is whole; open a backup of it",
                                                 nullptr, int(document->lostStrokes))
                         .arg(in)};
    return document;
}

} // namespace

int convertCommand(const QStringList &arguments)
{
    CommandLine line("convert",
                     QCoreApplication::translate("Cli",
                                                 "Converts between documents (.suffuse) and the text form (.json), and "
                                                 "from pen recordings and drawings, and to drawings (.svg, .svgz, "
                                                 ".pdf). What IN is, is found from its content; what OUT is, from its "
                                                 "ending."),
                     {"IN", "OUT"});
    line.add({"brush"},
             QCoreApplication::translate("Cli", "The brush that recordings and drawings are painted with: a name, or a "
                                                "brush file."),
             "PRESET");
    line.add({"format"},
             QCoreApplication::translate("Cli", "Where OUT is -: suffuse, json, svg or pdf (default: json)."),
             "FORMAT");
    line.add({"plain"}, QCoreApplication::translate(
                            "Cli", "Leaves out what lies beside the picture: preview, view, undo history."));
    line.add({"salvage"}, QCoreApplication::translate(
                              "Cli", "Of a damaged document takes what is whole, and says what is missing."));
    line.add({"fit"}, QCoreApplication::translate(
                          "Cli", "Solves the diffusion curves of IN, or reads its picture, and makes strokes that look "
                                 "like it, as suffuse-cli fit does."));
    line.add({"strokes"}, QCoreApplication::translate("Cli", "With --fit: at most so many strokes (default 512)."), "N");
    addDrawingOptions(line);
    line.allowSeveral();
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const QString out = line.argument(1);
    if (const QString problem = fitProblem(line); !problem.isEmpty())
        return failUsage("convert", problem);
    if (line.isSet("fit")) {
        QStringList fit{arguments.value(0), "fit", line.argument(0), "-o", out};
        if (line.isSet("strokes"))
            fit += {"--strokes", line.value("strokes")};
        return fitCommand(fit);
    }
    const Result<FileFormat> format = formatOf(line, out);
    if (!format)
        return failUsage("convert", format.error());
    const std::optional<DrawingFormat> drawing = drawingFormatOf(line, out);
    if (const QString problem = drawingProblem(line, drawing); !problem.isEmpty())
        return failUsage("convert", problem);
    const QStringList ins = line.several();
    if (ins.size() > 1 && drawing != DrawingFormat::Pdf)
        return failUsage("convert", QCoreApplication::translate(
                                        "Cli", "several INs become the pages of a PDF; give OUT the ending .pdf"));
    for (const QString &in : ins)
        if (isSameFile(in, out))
            return failUsage("convert", inputWouldBeLost(out));
    std::optional<Brush> brush;
    if (line.isSet("brush")) {
        const Result<Brush> found = brushOf(line.value("brush"));
        if (!found)
            return failUsage("convert", found.error());
        brush = *found;
    }
    std::vector<LoadedDocument> documents;
    for (const QString &in : ins) {
        Result<LoadedDocument> document = documentOf(in, brush ? &*brush : nullptr, line.isSet("salvage"));
        if (!document)
            return fail(document.error());
        if (out != QLatin1String("-"))
            document->painting = movedTo(out, in, document->painting);
        documents.push_back(std::move(*document));
    }
    if (drawing)
        return convertToDrawing(line, documents, *drawing, out);
    const LoadedDocument &document = documents.front();
    const DocumentExtras extras = line.isSet("plain") ? DocumentExtras() : document.extras;
    if (out == QLatin1String("-"))
        return printBytes(writeDocument(document.painting, extras, *format));
    const Result<void> saved = saveDocument(document.painting, extras, out);
    return saved ? Done : fail(saved.error());
}

} // namespace suffuse::cli
