// Reading and writing paintings. The input's format is found from its content, the output's from its ending.
#pragma once

#include "model/brush.h"
#include "model/painting.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace suffuse {

enum class FileFormat { Unknown, Suffuse, Text, InkCsv, UniversalInk, Excalidraw, MyPaintEvents };

/// From the first bytes; never from the name.
FileFormat detectFormat(const QByteArray &bytes);
/// ".suffuse" or ".json"; Unknown for other endings.
FileFormat formatForSaving(const QString &path);
QString nameOf(FileFormat format); ///< for people, translated

/// A painting from a file's bytes, whatever its format. `fileName` is used in messages ("a.json: strokes[3]…") and to
/// find images beside it. Recordings are painted with `brush` (default: the first built-in one).
Result<Painting> readPainting(const QByteArray &bytes, const QString &fileName, const Brush *brush = nullptr);
/// Reads a file ("-": standard input). Errors name the file, the place and the remedy.
Result<Painting> loadPainting(const QString &path, const Brush *brush = nullptr);

/// The bytes of a painting in a format that can be saved (Suffuse or Text).
QByteArray writePainting(const Painting &painting, FileFormat format);
/// Atomic: the old file stays until the new one is whole and on disk. Errors name the file and the remedy.
Result<void> savePainting(const Painting &painting, const QString &path);

/// Replaces a file's content or leaves it as it was: every write, the flush, the size and the rename are checked, and
/// the folder is synced (QSaveFile alone reports success over a truncated file on a full disk).
Result<void> writeFileAtomically(const QString &path, const QByteArray &bytes);

/// Exact text form (docs/text-form.md) and binary document (docs/file-format.md).
Result<Painting> readTextForm(const QByteArray &bytes, const QString &fileName);
QByteArray writeTextForm(const Painting &painting);
Result<Painting> readSuffuseFile(const QByteArray &bytes, const QString &fileName);
QByteArray writeSuffuseFile(const Painting &painting);
/// Chunks of a .suffuse file for `info`: name and size in bytes.
struct ChunkInfo {
    QString name;
    qint64 bytes = 0;
};
Result<std::vector<ChunkInfo>> suffuseChunks(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
