// What a journal holds (docs/recovery.md): how a painting came to be what it is since it was opened, record by record.
#pragma once

#include "model/document/order_difference.h"
#include "model/painting/painting.h"
#include "model/result.h"

#include <vector>

namespace suffuse {

/// What a journal says about its document, the painting aside.
struct JournalHead {
    QString name;        ///< as the window shows it
    QString path;        ///< of its file, absolute; empty: untitled
    QByteArray fileHash; ///< SHA-256 of that file as it was last read or written; empty: unknown
    friend bool operator==(const JournalHead &, const JournalHead &) = default;
};

/// Where a journal leads to, as far as it is whole.
struct JournalContent {
    JournalHead head;
    Painting painting;
    bool modified = false; ///< whether there is something that the document's file does not hold
    qint64 lastChange = 0; ///< of the last record, milliseconds since 1970
    qint64 wholeBytes = 0; ///< what follows them was torn
    std::size_t edits = 0;
};

/// What leads from one snapshot to another. Shared strokes are told by their pointers.
struct SnapshotDifference {
    std::vector<StrokePtr> strokes; ///< new ones and other states
    std::vector<StrokeId> removed;
    OrderDifference places;
    bool rest = false; ///< canvas, groups, swatches or underlay

    bool isEmpty() const { return strokes.empty() && removed.empty() && places.empty() && !rest; }
};
SnapshotDifference snapshotDifference(const Painting &before, const Painting &after);

/// Writes the records of one journal. Each call returns bytes to append; once they are on disk, tell `kept`.
class JournalEncoder {
public:
    /// Signature, head and the whole painting.
    QByteArray begin(const JournalHead &head, PaintingPtr painting, bool modified, qint64 now);
    /// What differs from the snapshot before; empty if nothing does, not even `modified`.
    QByteArray edit(PaintingPtr painting, bool modified, qint64 now);
    /// The document was saved, perhaps under another name.
    QByteArray saved(const JournalHead &head, bool modified, qint64 now);
    /// What was returned last is on disk: the next record goes on from it.
    void kept();

    /// So many strokes a reader has to look at to put them in order; what exceeds `mostOrdering` is refused, so a
    /// journal is begun anew before that.
    std::uint64_t ordering() const { return m_state.ordering; }
    static constexpr std::uint64_t mostOrdering = 50'000'000;

private:
    struct State {
        PaintingPtr painting;
        bool modified = false;
        std::vector<EncodedImage> images; ///< written so far, by their number
        std::uint64_t segments = 0;       ///< of all records
        std::uint64_t rewets = 0;
        std::uint64_t blocks = 0; ///< bytes of blocks that may still be compressed
        std::uint64_t ordering = 0;
    };
    QByteArray writeImages(const std::vector<EncodedImage> &images, std::vector<qint64> &numbers);

    State m_state; ///< what is on disk
    State m_next;  ///< once the last bytes are
};

/// The state after the last whole record; an error where not even the first painting is whole. Bounded in time and
/// memory, whatever the bytes say.
Result<JournalContent> readJournal(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse
