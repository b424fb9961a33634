// Reading and writing paintings. The input's format is found from its content, the output's from its ending.
#pragma once

#include "model/brush/brush.h"
#include "model/painting/painting.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace suffuse {

enum class FileFormat { Unknown, Suffuse, Text, InkCsv, UniversalInk, Excalidraw, MyPaintEvents, DiffusionCurves, Svg };

/// From the first bytes; never from the name.
FileFormat detectFormat(const QByteArray &bytes);
/// ".suffuse" or ".json"; Unknown for other endings.
FileFormat formatForSaving(const QString &path);
QString nameOf(FileFormat format); ///< for people, translated

/// A painting from a file's bytes, whatever its format. `fileName` is used in messages ("a.json: strokes[3]…") and to
/// find images beside it. Recordings and drawings are painted with `brush` (default: the first built-in one).
Result<Painting> readPainting(const QByteArray &bytes, const QString &fileName, const Brush *brush = nullptr);
/// Reads a file ("-": standard input). Errors name the file, the place and the remedy.
Result<Painting> loadPainting(const QString &path, const Brush *brush = nullptr);

/// The bytes of a painting in a format that can be saved (Suffuse or Text).
QByteArray writePainting(const Painting &painting, FileFormat format);
/// Atomic: the old file stays until the new one is whole and on disk. Errors name the file and the remedy.
Result<void> savePainting(const Painting &painting, const QString &path);

/// How a painting was last looked at; no part of the picture.
struct WorkspaceState {
    Point centre;        ///< canvas units, in the middle of the view
    double scale = 1;    ///< pixels of a screen of usual density a canvas unit
    double rotation = 0; ///< radians
    bool mirrored = false;
    std::optional<Microseconds> time; ///< the moment looked at; none: the end
    friend bool operator==(const WorkspaceState &, const WorkspaceState &) = default;
};

/// A part of a file that this program does not know and carries along: type of four letters, a small one first.
struct AncillaryChunk {
    QByteArray type;
    QByteArray payload;
    friend bool operator==(const AncillaryChunk &, const AncillaryChunk &) = default;
};

/// What a .suffuse file holds beside the picture. The text form holds none of it.
struct DocumentExtras {
    QByteArray preview; ///< PNG, at most 256 pixels a side; empty: none
    std::optional<WorkspaceState> view;
    QByteArray history;                  ///< undo steps as bytes (model/formats/suffuse/suffuse_history.h); empty: none
    std::vector<AncillaryChunk> unknown; ///< in the file's order
    friend bool operator==(const DocumentExtras &, const DocumentExtras &) = default;
};

/// A document as it was opened. Where `losses` is not empty the file is damaged, and these are the parts that are
/// missing, as sentences for people; the painting holds what is whole and must not replace the file unasked.
struct LoadedDocument {
    Painting painting;
    DocumentExtras extras;
    FileFormat format = FileFormat::Unknown;
    std::vector<QString> losses;
    qint64 lostStrokes = 0; ///< as far as the file tells
    /// What is not here though the picture is whole, as a sentence: what a foreign file holds and a painting cannot, or
    /// damaged parts beside the picture. Empty: nothing.
    QString leftOut;
};

/// As readPainting and loadPainting, which refuse a damaged file: these give what is whole of it.
Result<LoadedDocument> readDocument(const QByteArray &bytes, const QString &fileName, const Brush *brush = nullptr);
Result<LoadedDocument> loadDocument(const QString &path, const Brush *brush = nullptr);

/// As writePainting and savePainting, with what belongs beside the picture. Any thread.
QByteArray writeDocument(const Painting &painting, const DocumentExtras &extras, FileFormat format);
Result<void> saveDocument(const Painting &painting, const DocumentExtras &extras, const QString &path);

/// Replaces a file's content or leaves it as it was: every write, the flush, the size and the rename are checked, and
/// the folder is synced (QSaveFile alone reports success over a truncated file on a full disk).
Result<void> writeFileAtomically(const QString &path, const QByteArray &bytes);

/// Exact text form (docs/text-form.md) and binary document (docs/file-format.md).
Result<Painting> readTextForm(const QByteArray &bytes, const QString &fileName);
QByteArray writeTextForm(const Painting &painting);
Result<Painting> readSuffuseFile(const QByteArray &bytes, const QString &fileName);
Result<LoadedDocument> readSuffuseDocument(const QByteArray &bytes, const QString &fileName);
QByteArray writeSuffuseFile(const Painting &painting, const DocumentExtras &extras = {});
/// Chunks of a .suffuse file for `info`, damaged ones too.
struct ChunkInfo {
    QString name; ///< four letters; empty where they cannot be told
    qint64 start = 0;
    qint64 bytes = 0; ///< 0 where it cannot be told
    QString damage;   ///< empty: it is whole
};
Result<std::vector<ChunkInfo>> suffuseChunks(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
