// The content of a journal (docs/recovery.md): how a painting has changed since it was opened, record by record.
#pragma once

#include "model/document/order_difference.h"
#include "model/painting/painting.h"
#include "model/result.h"

#include <set>
#include <vector>

namespace suffuse {

/// What a journal says about its document, besides the painting.
struct JournalHead {
    QString name;          ///< of its file, or of the file that it was recovered from; empty if it has none
    QString path;          ///< the absolute path of its file; empty if it is untitled
    QByteArray fileHash;   ///< SHA-256 of that file as it was last read or written; empty if unknown
    double resolution = 0; ///< canvas units an inch of its paper; 0: it is not said
    friend bool operator==(const JournalHead &, const JournalHead &) = default;
};

/// The state to which a journal leads, as far as it is whole.
struct JournalContent {
    JournalHead head;
    Painting painting;
    bool modified = false; ///< whether it has something that the document's file does not have
    qint64 lastChange = 0; ///< the time of the last record, milliseconds since 1970
    qint64 wholeBytes = 0; ///< what follows these bytes was torn
    std::size_t edits = 0;
};

/// What leads from one snapshot to another. Shared strokes are recognised by their pointers.
struct SnapshotDifference {
    std::vector<StrokePtr> strokes; ///< strokes that are new or have another state
    std::vector<StrokeId> removed;
    OrderDifference places;
    bool rest = false; ///< whether canvas, groups, swatches or underlay differ

    bool isEmpty() const { return strokes.empty() && removed.empty() && places.empty() && !rest; }
};
SnapshotDifference snapshotDifference(const Painting &before, const Painting &after);

/// Writes the records of one journal. Each call returns bytes to append. Once they are on disk, `kept` must be called.
class JournalEncoder {
public:
    /// Writes the signature, the head and the whole painting.
    QByteArray begin(const JournalHead &head, PaintingPtr painting, bool modified, qint64 now);
    /// Writes what differs from the snapshot before. Returns nothing if nothing differs, not even `modified`.
    QByteArray edit(PaintingPtr painting, bool modified, qint64 now);
    /// Writes that the document was saved, perhaps under another name.
    QByteArray saved(const JournalHead &head, bool modified, qint64 now);
    /// Notes that what was returned last is on disk, so that the next record follows it.
    void kept();

    /// The number of strokes that a reader must look at to put them in order. Beyond `mostOrdering` a journal is
    /// refused, so it is begun anew before that.
    std::uint64_t ordering() const { return m_state.ordering; }
    static constexpr std::uint64_t mostOrdering = 50'000'000;

private:
    struct State {
        PaintingPtr painting;
        bool modified = false;
        std::vector<EncodedImage> images; ///< the images written so far, by their number
        std::set<QString> pictures;       ///< the SHA-256 of the images of pictures that were written
        std::uint64_t segments = 0;       ///< of all records
        std::uint64_t rewets = 0;
        std::uint64_t blocks = 0; ///< bytes of blocks that may still be compressed
        std::uint64_t ordering = 0;
    };
    QByteArray writeImages(const std::vector<EncodedImage> &images, std::vector<qint64> &numbers);
    QByteArray writePictures(const std::vector<StrokePtr> &strokes);

    State m_state; ///< the state that is on disk
    State m_next;  ///< the state once the last bytes are on disk
};

/// The state after the last whole record. It is an error if not even the first painting is whole. Time and memory are
/// bounded, whatever the bytes say.
Result<JournalContent> readJournal(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
