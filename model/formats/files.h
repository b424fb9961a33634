// Reads and writes paintings. The format of an input is found from its content, that of an output from its ending.
#pragma once

#include "model/brush/brush.h"
#include "model/formats/print_setup.h"
#include "model/geometry/assistant.h"
#include "model/geometry/guide.h"
#include "model/geometry/symmetry.h"
#include "model/painting/painting.h"
#include "model/result.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace suffuse {

enum class FileFormat {
    Unknown,
    Suffuse,
    Text,
    InkCsv,
    UniversalInk,
    Excalidraw,
    MyPaintEvents,
    DiffusionCurves,
    Svg,
    OpenRaster,
    Photoshop,
    Xournal,
    Pdf,
    InkMl,
    Rnote
};

/// The format by the first bytes, never by the name.
FileFormat detectFormat(const QByteArray &bytes);
/// The format by the ending ".suffuse" or ".json"; Unknown for other endings.
FileFormat formatForSaving(const QString &path);
QString nameOf(FileFormat format); ///< translated, for people

/// Reads a painting from a file's bytes, whatever the format. `fileName` is used in messages ("a.json: strokes[3]…")
/// and to find images beside the file, those of linked pictures among them; links stay as the file has them. Recordings
/// and drawings are painted with `brush` (by default with the first built-in one).
Result<Painting> readPainting(const QByteArray &bytes, const QString &fileName, const Brush *brush = nullptr);
/// Reads a file, or the standard input for "-". Errors name the file, the place and the remedy. `leftOut` receives what
/// LoadedDocument::leftOut tells of a foreign file, and LoadedDocument::missing of any; `resolution` receives
/// DocumentExtras::resolution.
Result<Painting> loadPainting(const QString &path, const Brush *brush = nullptr, QString *leftOut = nullptr,
                              double *resolution = nullptr);

/// The bytes of a painting in a format that can be saved (Suffuse or Text).
QByteArray writePainting(const Painting &painting, FileFormat format);
/// Saves a painting. The old file stays until the new one is whole and on disk. Errors name the file and the remedy.
Result<void> savePainting(const Painting &painting, const QString &path);

/// A layer that was begun and has no stroke yet: a group without strokes has no place in the order.
struct BegunLayer {
    QString name;
    bool clips = false;
    GroupId parent = 0; ///< the group that it will be in; 0: none
    GroupId above = 0;  ///< the group above which it will come; 0: on top of what is in its parent
    friend bool operator==(const BegunLayer &, const BegunLayer &) = default;
};

/// How a painting was looked at last. This is no part of the picture.
struct WorkspaceState {
    Point centre;        ///< the centre of the view, canvas units
    double scale = 1;    ///< pixels of a screen of usual density for each canvas unit
    double rotation = 0; ///< radians
    bool mirrored = false;
    std::optional<Microseconds> time;     ///< the moment that was looked at; no value: the end
    bool isFitted = false;                ///< all of the canvas was shown, whatever the four above say
    GroupId layer = 0;                    ///< the group that was painted on; 0: none
    std::vector<GroupId> open = {};       ///< the groups that were open in the list of strokes
    std::optional<BegunLayer> begun = {}; ///< what was painted on, where it has no stroke yet; layer is 0 then
    std::optional<Symmetry> symmetry = {}; ///< in which one paints; no value: as every painting begins
    std::vector<Guide> guides = {};
    std::vector<Assistant> assistants = {};
    std::optional<PrintSetup> print = {}; ///< how it was printed last; no value: not yet
    friend bool operator==(const WorkspaceState &, const WorkspaceState &) = default;
};

/// A part of a file that this program does not know, but keeps. Its type has four letters, and the first is small.
struct AncillaryChunk {
    QByteArray type;
    QByteArray payload;
    friend bool operator==(const AncillaryChunk &, const AncillaryChunk &) = default;
};

/// The largest colour profile that a document keeps, bytes.
inline constexpr qsizetype largestKeptProfile = 1 << 20;

/// What a .suffuse file has besides the picture. The text form has none of it.
struct DocumentExtras {
    QByteArray preview; ///< PNG of at most 256 pixels a side; empty if there is none
    std::optional<WorkspaceState> view;
    /// undo steps as bytes (model/formats/suffuse/suffuse_history.h); empty if there are none
    QByteArray history;
    /// the ICC profile in which pictures of the painting go out; empty: sRGB
    QByteArray profile;
    double resolution = 0; ///< canvas units an inch of paper (model/painting/resolution.h); 0: it is not said
    std::vector<AncillaryChunk> unknown; ///< in the order of the file
    friend bool operator==(const DocumentExtras &, const DocumentExtras &) = default;
};

/// A document that was opened. If `losses` is not empty, the file is damaged, and these are sentences for people about
/// the parts that are missing. The painting then has what is whole, and must not replace the file without asking.
struct LoadedDocument {
    Painting painting;
    DocumentExtras extras;
    FileFormat format = FileFormat::Unknown;
    std::vector<QString> losses;
    qint64 lostStrokes = 0; ///< as far as the file tells
    /// What was left out although the picture is whole, as a sentence: what a foreign file has and a painting cannot
    /// have, or damaged parts besides the picture. It is empty if there is nothing.
    QString leftOut;
    /// Which linked pictures are missing, as sentences that say what to do. It is empty if there are none.
    QString missing;
};

/// Reads a document like readPainting and loadPainting. While these refuse a damaged file, this returns what is whole
/// of it.
Result<LoadedDocument> readDocument(const QByteArray &bytes, const QString &fileName, const Brush *brush = nullptr);
Result<LoadedDocument> loadDocument(const QString &path, const Brush *brush = nullptr);

/// Write a document like writePainting and savePainting, with what it has besides the picture. They may be called on
/// any thread.
QByteArray writeDocument(const Painting &painting, const DocumentExtras &extras, FileFormat format);
Result<void> saveDocument(const Painting &painting, const DocumentExtras &extras, const QString &path);

/// Replaces a file's content, or leaves it as it was. Every write, the flush, the size and the rename are checked, and
/// the folder is synced (QSaveFile alone reports success for a truncated file on a full disk).
Result<void> writeFileAtomically(const QString &path, const QByteArray &bytes);

/// Read and write the exact text form (docs/text-form.md) and the binary document (docs/file-format.md).
Result<Painting> readTextForm(const QByteArray &bytes, const QString &fileName);
QByteArray writeTextForm(const Painting &painting);
Result<Painting> readSuffuseFile(const QByteArray &bytes, const QString &fileName, double *resolution = nullptr);
Result<LoadedDocument> readSuffuseDocument(const QByteArray &bytes, const QString &fileName);
QByteArray writeSuffuseFile(const Painting &painting, const DocumentExtras &extras = {});
/// The chunks of a .suffuse file for `info`, including damaged ones.
struct ChunkInfo {
    QString name; ///< four letters; empty where they are not known
    qint64 start = 0;
    qint64 bytes = 0; ///< 0 where the size is not known
    QString damage;   ///< empty if the chunk is whole
};
Result<std::vector<ChunkInfo>> suffuseChunks(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
