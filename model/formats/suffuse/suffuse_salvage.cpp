// Finds what is whole of a damaged .suffuse file.
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/suffuse_layout.h"
#include "model/journal/journal_layout.h"

#include <algorithm>
#include <cstring>

namespace suffuse {

namespace {

/// The four letters of a type as a number, for quick comparison: a chunk may start at every byte of a file.
std::uint32_t tagOf(const char *type)
{
    std::uint32_t tag = 0;
    std::memcpy(&tag, type, 4);
    return tag;
}

bool isKnown(QByteArrayView type)
{
    static const std::array<std::uint32_t, 8> known{tagOf("HEAD"), tagOf("IMAG"), tagOf("DOCU"), tagOf("STRK"),
                                                    tagOf("ENDS"), tagOf("prev"), tagOf("view"), tagOf("hist")};
    return type.size() == 4 && std::ranges::find(known, tagOf(type.data())) != known.end();
}

class Salvage {
public:
    explicit Salvage(const QByteArray &bytes) : m_bytes(bytes), m_budget(8 * bytes.size()) {}

    std::vector<FilePiece> run()
    {
        for (qsizetype at = start(); !m_ended;) {
            if (at == m_bytes.size()) {
                add({{}, at, {}}, FileMessages::tr("the end of the file is missing"));
                break;
            }
            ChunkAttempt attempt = chunkAt(m_bytes, at);
            if (attempt.problem.isEmpty()) {
                at += attempt.chunk.size();
                take(attempt.chunk);
                continue;
            }
            const qsizetype next = nextWhole(attempt.chunk);
            if (!isKnown(attempt.chunk.type))
                attempt.chunk.type.clear();
            add(attempt.chunk, attempt.problem);
            if (next < 0)
                break;
            at = next;
        }
        return std::move(m_pieces);
    }

    /// The place of the first whole chunk of a known type from byte `at` on, or -1.
    qsizetype findWhole(qsizetype at)
    {
        for (; at + 12 <= m_bytes.size() && m_budget > 0; ++at)
            if (isWhole(at))
                return at;
        return -1;
    }

private:
    /// The place where the chunks begin. A damaged signature may have become longer or shorter.
    qsizetype start()
    {
        const QString problem = problemOfSignature(m_bytes);
        if (problem.isEmpty())
            return m_first;
        const bool inPlace = m_bytes.size() >= m_first + 4 && isKnown(QByteArrayView(m_bytes).sliced(m_first, 4));
        if (const qsizetype found = inPlace ? m_first : findWhole(0); found >= 0)
            m_first = found;
        add({{}, 0, {}}, problem);
        return std::min(m_first, m_bytes.size());
    }

    void add(const Chunk &chunk, const QString &damage) { m_pieces.push_back({chunk, damage}); }

    void take(const Chunk &chunk)
    {
        m_ended = chunk.type == "ENDS";
        if (!m_ended) {
            add(chunk, {});
            return;
        }
        const bool before = std::any_of(m_pieces.begin(), m_pieces.end(),
                                        [](const FilePiece &p) { return !p.damage.isEmpty() && !p.isSignature(); });
        const QString problem = problemOfEnd(m_bytes, chunk, m_first);
        // If something is damaged, the hash differs anyway.
        if (problem.isEmpty() || (before && chunk.start + chunk.size() == m_bytes.size()))
            add(chunk, {});
        else
            add(chunk, problem);
    }

    /// The next whole chunk of a known type after a damaged one, or -1. It is directly behind it, as its length says,
    /// or where one is found.
    qsizetype nextWhole(const Chunk &broken)
    {
        if (!broken.payload.isNull()) {
            const qsizetype behind = broken.start + broken.size();
            if (behind == m_bytes.size())
                return broken.type == "ENDS" ? -1 : behind;
            if (isWhole(behind))
                return behind;
        }
        return findWhole(broken.start + 1);
    }

    /// Whether a chunk is whole. Each check counts its bytes, so that a hostile file cannot make this take long.
    bool isWhole(qsizetype at)
    {
        if (m_budget <= 0 || !isKnown(QByteArrayView(m_bytes).sliced(at, std::min<qsizetype>(4, m_bytes.size() - at))))
            return false;
        const ChunkAttempt attempt = chunkAt(m_bytes, at);
        m_budget -= attempt.chunk.size();
        return attempt.problem.isEmpty();
    }

    const QByteArray &m_bytes;
    std::vector<FilePiece> m_pieces;
    qint64 m_budget;
    qsizetype m_first = suffuseSignatureSize; ///< the byte where the first chunk begins
    bool m_ended = false;
};

} // namespace

std::vector<FilePiece> salvageChunks(const QByteArray &bytes)
{
    return Salvage(bytes).run();
}

bool hasFirstChunk(const QByteArray &bytes)
{
    if (bytes.startsWith(journalName) || bytes.size() < suffuseSignatureSize + 12 ||
        !isKnown(QByteArrayView(bytes).sliced(suffuseSignatureSize, 4)))
        return false;
    return chunkAt(bytes, suffuseSignatureSize).problem.isEmpty();
}

bool hasAnyChunk(const QByteArray &bytes)
{
    return !bytes.startsWith(journalName) && Salvage(bytes).findWhole(0) >= 0;
}

Result<std::vector<ChunkInfo>> suffuseChunks(const QByteArray &bytes, const QString &fileName)
{
    if (detectFormat(bytes) != FileFormat::Suffuse)
        return fileError(fileName, FileMessages::tr("is not a .suffuse file"));
    std::vector<ChunkInfo> list;
    for (const FilePiece &piece : salvageChunks(bytes))
        list.push_back({QString::fromLatin1(piece.chunk.type), piece.chunk.start,
                        piece.chunk.payload.isNull() ? 0 : piece.chunk.size(), piece.damage});
    return list;
}

} // namespace suffuse
