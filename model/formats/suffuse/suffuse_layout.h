// The outer layout of a .suffuse file (docs/file-format.md): signature, chunks, checksums.
#pragma once

#include "model/result.h"

#include <QByteArray>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace suffuse {

/// First bytes: not ASCII, the name, then a line ending that transfers as text would change.
inline constexpr char suffuseName[] = "\x89SUFFUSE";
inline constexpr char suffuseLineEnds[] = "\r\n\x1a\n";
inline constexpr qsizetype suffuseSignatureSize = 12;

/// The version that is understood; what is written is of the least version that holds it, which is at least the other.
inline constexpr int suffuseVersion = 2;
inline constexpr int suffuseLeastReader = 1;

/// Segments (and rewettings) that a small file may declare; beyond it has at least one byte for each.
inline constexpr std::uint64_t freeElements = 500'000;
/// Most segments of a stroke chunk, but for one stroke that has more: a sixteenth of the painting's, so that damage at
/// one place loses little of a small painting too, within bounds that keep chunks worth packing and small beside a
/// large one.
constexpr std::size_t segmentsPerChunk(std::size_t total)
{
    return std::clamp<std::size_t>(total / 16, 64, 4'096);
}
/// Names and palettes that are stored compressed, bytes before compression in the whole file; more is stored raw.
inline constexpr std::uint64_t blockBudget = std::uint64_t(64) << 20;

/// CRC-32C (Castagnoli), as iSCSI has it.
std::uint32_t crc32c(const char *bytes, std::size_t size);

void appendU32(QByteArray &out, std::uint32_t value);
/// Seven bits a byte, low ones first, high bit set where more follow.
void appendVarint(QByteArray &out, std::uint64_t value);

/// type (4 letters), length, payload, CRC-32C of those three. A capital first letter: a reader must understand it.
void appendChunk(QByteArray &out, const char *type, const QByteArray &payload);

struct Chunk {
    QByteArray type;
    qsizetype start = 0; ///< of its type, from the start of the file
    QByteArrayView payload;
    qsizetype size() const { return payload.size() + 12; }
};

/// "chunk STRK at byte 1234: WHAT"
QString chunkText(const Chunk &chunk, const QString &what);
/// "a.suffuse: chunk STRK at byte 1234: WHAT; REMEDY"
Error chunkError(const QString &fileName, const Chunk &chunk, const QString &what);

/// Whether the file starts as a document does, what follows the name aside.
bool startsAsSuffuse(const QByteArray &bytes);
/// What became of the first bytes; empty where they are as they should be.
QString problemOfSignature(const QByteArray &bytes);
Result<void> checkSignature(const QByteArray &bytes, const QString &fileName);
/// The chunk that starts at a byte, with `problem` empty; else what is wrong, and as much of the chunk as can be told.
struct ChunkAttempt {
    Chunk chunk;
    QString problem;
};
ChunkAttempt chunkAt(const QByteArray &bytes, qsizetype at);
/// Empty, or why the end chunk does not fit what is behind it and before it: the signature as it should be, and the
/// chunks from byte `first` on.
QString problemOfEnd(const QByteArray &bytes, const Chunk &end, qsizetype first = suffuseSignatureSize);

/// Checks signature, chunk lengths, checksums and the hash at the end. The views look into `bytes`.
Result<std::vector<Chunk>> splitChunks(const QByteArray &bytes, const QString &fileName);

/// A chunk of a damaged file, or a stretch that is none: then `damage` says why, and of `chunk` only the start counts,
/// and the type where it is one.
struct FilePiece {
    Chunk chunk;
    QString damage;
    /// The first bytes, which hold nothing of the painting.
    bool isSignature() const { return chunk.start == 0 && !damage.isEmpty(); }
};
/// All that is whole of a file, in order, and the stretches between; a damaged signature is the first of them. Never
/// fails; the end chunk is among the pieces only if it is whole and fits.
std::vector<FilePiece> salvageChunks(const QByteArray &bytes);
/// Whether the chunk behind the signature, which may be damaged, is whole. Costs next to nothing.
bool hasFirstChunk(const QByteArray &bytes);
/// Whether any chunk of a painting is whole, wherever it is. Looks through the file, but not through a journal
/// (docs/recovery.md), which is made of such chunks too.
bool hasAnyChunk(const QByteArray &bytes);

/// Reads little-endian numbers from memory that may be too short; after the first failure everything fails.
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
