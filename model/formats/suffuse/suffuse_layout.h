// The outer layout of a .suffuse file (docs/file-format.md): signature, chunks, checksums.
#pragma once

#include "model/result.h"

#include <QByteArray>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace suffuse {

/// The first bytes: one that is not ASCII, the name, then a line ending that a transfer as text would change.
inline constexpr char suffuseName[] = "\x89SUFFUSE";
inline constexpr char suffuseLineEnds[] = "\r\n\x1a\n";
inline constexpr qsizetype suffuseSignatureSize = 12;

/// The version that is understood. A document is written in the least version that can hold it, which is at least the
/// other one here.
inline constexpr int suffuseVersion = 4;
inline constexpr int suffuseLeastReader = 1;

/// A small file may declare so many segments (and rewettings). Beyond that a file has at least one byte for each.
inline constexpr std::uint64_t freeElements = 500'000;
/// The greatest number of segments in a stroke chunk, unless one stroke has more. It is a sixteenth of the painting's
/// segments, so that damage at one place loses little of a small painting, too. Its bounds keep chunks worth packing,
/// and small relative to a large painting.
constexpr std::size_t segmentsPerChunk(std::size_t total)
{
    return std::clamp<std::size_t>(total / 16, 64, 4'096);
}
/// So many bytes of names and palettes, counted before compression in the whole file, are stored compressed. The rest
/// is stored raw.
inline constexpr std::uint64_t blockBudget = std::uint64_t(64) << 20;

/// The checksum CRC-32C (Castagnoli), as in iSCSI.
std::uint32_t crc32c(const char *bytes, std::size_t size);

void appendU32(QByteArray &out, std::uint32_t value);
/// Appends a number with seven bits in each byte, low ones first. The high bit is set where more follow.
void appendVarint(QByteArray &out, std::uint64_t value);

/// Appends a chunk: type (4 letters), length, payload, and the CRC-32C of those three. If the first letter of the type
/// is a capital, a reader must understand the chunk.
void appendChunk(QByteArray &out, const char *type, const QByteArray &payload);

struct Chunk {
    QByteArray type;
    qsizetype start = 0; ///< the place of its type, from the start of the file
    QByteArrayView payload;
    qsizetype size() const { return payload.size() + 12; }
};

/// A text such as "chunk STRK at byte 1234: WHAT".
QString chunkText(const Chunk &chunk, const QString &what);
/// An error such as "a.suffuse: chunk STRK at byte 1234: WHAT; REMEDY".
Error chunkError(const QString &fileName, const Chunk &chunk, const QString &what);

/// Whether a file starts as a document does, whatever follows the name.
bool startsAsSuffuse(const QByteArray &bytes);
/// What has happened to the first bytes; empty if they are as they should be.
QString problemOfSignature(const QByteArray &bytes);
Result<void> checkSignature(const QByteArray &bytes, const QString &fileName);
/// The chunk that starts at a byte, with an empty `problem`. Otherwise `problem` says what is wrong, and the chunk is
/// filled in as far as it can be read.
struct ChunkAttempt {
    Chunk chunk;
    QString problem;
};
ChunkAttempt chunkAt(const QByteArray &bytes, qsizetype at);
/// Empty, or why the end chunk does not fit the file. It is compared with the signature as it should be, and with the
/// chunks from byte `first` on.
QString problemOfEnd(const QByteArray &bytes, const Chunk &end, qsizetype first = suffuseSignatureSize);

/// Checks signature, lengths of chunks, checksums, and the hash at the end. The views refer to `bytes`.
Result<std::vector<Chunk>> splitChunks(const QByteArray &bytes, const QString &fileName);

/// A chunk of a damaged file, or a part that is none. In the second case `damage` says why; of `chunk` only the start
/// counts, and the type if it can be read.
struct FilePiece {
    Chunk chunk;
    QString damage;
    /// Whether this is the signature, which has nothing of the painting.
    bool isSignature() const { return chunk.start == 0 && !damage.isEmpty(); }
};
/// All chunks of a file that are whole, in order, and the parts between them. A damaged signature is the first of them.
/// It never fails. The end chunk is among the pieces only if it is whole and fits.
std::vector<FilePiece> salvageChunks(const QByteArray &bytes);
/// Whether the chunk behind the signature, which may be damaged, is whole. This costs very little.
bool hasFirstChunk(const QByteArray &bytes);
/// Whether any chunk of a painting is whole, wherever it is. It looks through the whole file, but not through a journal
/// (docs/recovery.md), which has such chunks, too.
bool hasAnyChunk(const QByteArray &bytes);

/// Reads little-endian numbers from memory that may be too short. After the first failure all calls fail.
class ByteCursor {
public:
    explicit ByteCursor(QByteArrayView bytes) : m_bytes(bytes) {}

    bool ok() const { return m_ok; }
    qsizetype left() const { return m_bytes.size() - m_at; }
    std::uint8_t u8();
    std::uint32_t u32();
    std::uint64_t varint();
    QByteArrayView take(std::uint64_t size);

private:
    QByteArrayView m_bytes;
    qsizetype m_at = 0;
    bool m_ok = true;
};

} // namespace suffuse
