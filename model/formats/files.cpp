#include "model/formats/files.h"

#include "model/formats/gzip.h"
#include "model/formats/ink/diffusion_curves.h"
#include "model/formats/ink/recording.h"
#include "model/formats/messages.h"
#include "model/formats/ora/ora_layers.h"
#include "model/formats/ora/ora_parts.h"
#include "model/formats/pdf/pdf_embedding.h"
#include "model/formats/picture_links.h"
#include "model/formats/psd/psd_layers.h"
#include "model/formats/suffuse/suffuse_layout.h"
#include "model/formats/svg/svg_embedding.h"
#include "model/formats/svg/svg_length.h"
#include "model/formats/svg/svg_painting.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace suffuse {

namespace {

/// What is wrong with a file that is of no format that can be read, and what can be.
QString unknownFormat(const QByteArray &bytes)
{
    const QString known =
        FileMessages::tr("Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, "
                         "Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)");
    if (bytes.isEmpty())
        return FileMessages::tr("This file is empty: nothing was saved in it.");
    if (bytes.startsWith("\xff\xfe") || bytes.startsWith("\xfe\xff"))
        return FileMessages::tr("This is UTF-16 text. Save it as UTF-8.");
    if (bytes.startsWith("\x1f\x8b"))
        return FileMessages::tr("This file is compressed with gzip, and what is in it is neither an SVG nor a "
                                "notebook of Xournal++ or Rnote. Unpack it first. %1.")
            .arg(known);
    if (bytes.startsWith("\x89PNG") || bytes.startsWith("\xff\xd8\xff"))
        return FileMessages::tr("This is a picture, not a painting. %1.").arg(known);
    return FileMessages::tr("This is neither a painting nor a recording that can be read. %1. Other programs can "
                            "export SVG.")
        .arg(known);
}

Result<QByteArray> readAll(QFile &file, const QString &path)
{
    const auto tooLarge = [&] {
        return fileError(path, FileMessages::tr("has more than 2 GB; that is more than can be opened"));
    };
    if (!file.isSequential() && file.size() > largestFile)
        return tooLarge();
    QByteArray bytes;
    constexpr qint64 step = 16 << 20;
    for (;;) {
        const QByteArray part = file.read(std::max(step, file.isSequential() ? 0 : file.size() - bytes.size()));
        if (part.isEmpty())
            break;
        bytes.append(part); // The first part is shared, not copied.
        if (bytes.size() > largestFile)
            return tooLarge();
    }
    if (file.error() != QFileDevice::NoError)
        return fileError(path, FileMessages::tr("could not be read: %1").arg(file.errorString()));
    return bytes;
}

/// The painting that an OpenRaster file has beside its layers, or the layers themselves.
Result<Painting> readOpenRaster(const QByteArray &bytes, const QString &fileName, QString &leftOut)
{
    const Result<ora::EmbeddedPainting> embedded = ora::readEmbedded(bytes);
    if (!embedded)
        return fileError(fileName, embedded.error());
    if (embedded->document.isEmpty()) {
        Result<Painting> layers = ora::readLayers(bytes, leftOut);
        return layers ? std::move(layers) : Result<Painting>(fileError(fileName, layers.error()));
    }
    if (embedded->isChanged)
        leftOut = FileMessages::tr("Another program changed this picture. What was opened is the painting as Suffuse "
                                   "exported it.");
    return readSuffuseFile(embedded->document, fileName);
}

/// The painting that a PDF file was made of. What its pages show is not read.
Result<Painting> readPdf(const QByteArray &bytes, const QString &fileName, QString &leftOut)
{
    const Result<pdf::AttachedPainting> attached = pdf::readAttached(bytes);
    if (!attached)
        return fileError(fileName, attached.error());
    if (attached->document.isEmpty())
        return fileError(fileName, FileMessages::tr("This PDF file holds no painting. Suffuse opens those that it "
                                                    "wrote; open a picture of its pages as a layer instead."));
    QStringList said;
    if (attached->isChanged)
        said << FileMessages::tr("Another program changed this PDF file. What was opened is the painting as Suffuse "
                                 "exported it.");
    if (attached->count > 1)
        said << FileMessages::tr("Of %n painting(s) in this PDF file the first one was opened.", nullptr,
                                 attached->count);
    leftOut = joinedSentences(said);
    return readSuffuseFile(attached->document, fileName);
}

/// Reads a drawing: the painting that it was made of, if it is in it and no other program has changed the drawing
/// since. `resolution`, if not null, gets how many canvas units an inch has, where the drawing says its size on paper.
Result<Painting> readDrawing(const QByteArray &bytes, const QString &fileName, const Brush *brush, QString &leftOut,
                             double *resolution)
{
    QByteArray svg = bytes;
    if (isGzip(bytes)) {
        Result<QByteArray> unpacked = unpackedGzip(bytes, largestUnpacked);
        if (!unpacked)
            return fileError(fileName, unpacked.error());
        svg = std::move(*unpacked);
    }
    const std::optional<EmbeddedDocument> embedded = embeddedIn(svg);
    if (embedded && embedded->matches) // If it is damaged, what is drawn is whole all the same.
        if (Result<Painting> painting = readSuffuseFile(embedded->document, fileName, resolution))
            return painting;
    Result<Painting> painting = readSvg(svg, fileName, brush, &leftOut);
    if (painting && resolution && saysSizeOnPaper(svg))
        *resolution = svgUnitsOfInch;
    if (painting && embedded && !embedded->matches)
        leftOut =
            (leftOut.isEmpty() ? QString() : leftOut + QLatin1Char(' ')) +
            FileMessages::tr("Another program has changed the drawing since Suffuse wrote it. It is opened as it is "
                             "drawn now, not as the painting that is in it.");
    return painting;
}

/// Reads all formats except .suffuse, which the caller reads. `leftOut` is that of LoadedDocument, `resolution` that of
/// readDrawing.
Result<Painting> readOther(const QByteArray &bytes, const QString &fileName, FileFormat format, const Brush *brush,
                           QString &leftOut, double *resolution)
{
    const auto painted = [&](const Result<Recording> &recording) -> Result<Painting> {
        if (!recording)
            return Error{recording.error()};
        leftOut = recording->leftOut;
        return paintRecording(*recording, brush ? *brush : builtinBrushes().front(), fileName);
    };
    switch (format) {
    case FileFormat::Text:
        return readTextForm(bytes, fileName);
    case FileFormat::InkCsv:
        return painted(readInkCsv(bytes, fileName));
    case FileFormat::UniversalInk:
        return painted(readUniversalInk(bytes, fileName));
    case FileFormat::Excalidraw:
        return painted(readExcalidraw(bytes, fileName));
    case FileFormat::MyPaintEvents:
        return painted(readMyPaintEvents(bytes, fileName));
    case FileFormat::Xournal:
        return painted(readXournal(bytes, fileName));
    case FileFormat::InkMl:
        return painted(readInkml(bytes, fileName));
    case FileFormat::Rnote:
        return painted(readRnote(bytes, fileName));
    case FileFormat::DiffusionCurves:
        return readDiffusionCurves(bytes, fileName);
    case FileFormat::Svg:
        return readDrawing(bytes, fileName, brush, leftOut, resolution);
    case FileFormat::OpenRaster:
        return readOpenRaster(bytes, fileName, leftOut);
    case FileFormat::Photoshop: {
        Result<Painting> layers = psd::readLayers(bytes, leftOut);
        return layers ? std::move(layers) : Result<Painting>(fileError(fileName, layers.error()));
    }
    case FileFormat::Pdf:
        return readPdf(bytes, fileName, leftOut);
    case FileFormat::Suffuse:
    case FileFormat::Unknown:
        break;
    }
    return fileError(fileName, unknownFormat(bytes));
}

/// Gives linked pictures their images, as they are seen from a file's folder. Returns what LoadedDocument::missing has.
QString takeLinks(Painting &painting, const QString &fileName)
{
    return readLinks(painting, QFileInfo(fileName).absolutePath());
}

/// Reads any format, and refuses a damaged file.
Result<Painting> readWhole(const QByteArray &bytes, const QString &fileName, const Brush *brush, QString &leftOut,
                           double *resolution = nullptr)
{
    const FileFormat format = detectFormat(bytes);
    Result<Painting> painting = format == FileFormat::Suffuse
                                    ? readSuffuseFile(bytes, fileName, resolution)
                                    : readOther(bytes, fileName, format, brush, leftOut, resolution);
    if (painting)
        leftOut = QStringList{leftOut, takeLinks(*painting, fileName)}.join(QLatin1Char(' ')).trimmed();
    return painting;
}

Result<QByteArray> loadBytes(const QString &path)
{
    QFile file;
    if (path == QLatin1String("-")) {
        if (!file.open(stdin, QIODevice::ReadOnly))
            return fileError(path, FileMessages::tr("could not be read: %1").arg(file.errorString()));
        return readAll(file, path);
    }
    const QFileInfo info(path);
    if (!info.exists())
        return fileError(
            path, FileMessages::tr("there is no such file: %1").arg(QDir::toNativeSeparators(info.absoluteFilePath())));
    if (info.isDir())
        return fileError(path, FileMessages::tr("is a folder; give a file inside it"));
    file.setFileName(path);
    if (!file.open(QIODevice::ReadOnly))
        return fileError(path,
                         FileMessages::tr("could not be opened: %1; check its permissions").arg(file.errorString()));
    return readAll(file, path);
}

} // namespace

Result<Painting> readPainting(const QByteArray &bytes, const QString &fileName, const Brush *brush)
{
    QString leftOut;
    return readWhole(bytes, fileName, brush, leftOut);
}

Result<LoadedDocument> readDocument(const QByteArray &bytes, const QString &fileName, const Brush *brush)
{
    const FileFormat format = detectFormat(bytes);
    if (format == FileFormat::Suffuse) {
        Result<LoadedDocument> read = readSuffuseDocument(bytes, fileName);
        if (read)
            read->missing = takeLinks(read->painting, fileName);
        return read;
    }
    LoadedDocument document;
    Result<Painting> painting =
        readOther(bytes, fileName, format, brush, document.leftOut, &document.extras.resolution);
    if (!painting)
        return Error{painting.error()};
    document.painting = std::move(*painting);
    document.format = format;
    document.missing = takeLinks(document.painting, fileName);
    return document;
}

Result<Painting> loadPainting(const QString &path, const Brush *brush, QString *leftOut, double *resolution)
{
    const auto bytes = loadBytes(path);
    QString ignored;
    return bytes ? readWhole(*bytes, path, brush, leftOut ? *leftOut : ignored, resolution) : Error{bytes.error()};
}

Result<LoadedDocument> loadDocument(const QString &path, const Brush *brush)
{
    const auto bytes = loadBytes(path);
    return bytes ? readDocument(*bytes, path, brush) : Error{bytes.error()};
}

QByteArray writePainting(const Painting &painting, FileFormat format)
{
    return writeDocument(painting, {}, format);
}

QByteArray writeDocument(const Painting &painting, const DocumentExtras &extras, FileFormat format)
{
    return format == FileFormat::Text ? writeTextForm(painting) : writeSuffuseFile(painting, extras);
}

Result<void> savePainting(const Painting &painting, const QString &path)
{
    return saveDocument(painting, {}, path);
}

Result<void> saveDocument(const Painting &painting, const DocumentExtras &extras, const QString &path)
{
    const FileFormat format = formatForSaving(path);
    if (format == FileFormat::Unknown)
        return fileError(path, FileMessages::tr("the ending is neither .suffuse nor .json; choose one of them"));
    return writeFileAtomically(path, writeDocument(painting, extras, format));
}

} // namespace suffuse
