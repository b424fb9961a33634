// What is whole of a damaged .suffuse file.
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/suffuse_layout.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr std::array<const char *, 8> knownTypes{"HEAD", "IMAG", "DOCU", "STRK", "ENDS", "prev", "view", "hist"};

bool isKnown(QByteArrayView type)
{
    return std::any_of(knownTypes.begin(), knownTypes.end(),
                       [&](const char *known) { return type == QByteArrayView(known); });
}

class Salvage {
public:
    explicit Salvage(const QByteArray &bytes) : m_bytes(bytes), m_budget(8 * bytes.size()) {}

    std::vector<FilePiece> run()
    {
        for (qsizetype at = suffuseSignatureSize; !m_ended;) {
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

private:
    void add(const Chunk &chunk, const QString &damage) { m_pieces.push_back({chunk, damage}); }

    void take(const Chunk &chunk)
    {
        m_ended = chunk.type == "ENDS";
        if (!m_ended) {
            add(chunk, {});
            return;
        }
        const bool before =
            std::any_of(m_pieces.begin(), m_pieces.end(), [](const FilePiece &p) { return !p.damage.isEmpty(); });
        const QString problem = problemOfEnd(m_bytes, chunk);
        // Where something is damaged the hash differs anyway.
        if (problem.isEmpty() || (before && chunk.start + chunk.size() == m_bytes.size()))
            add(chunk, {});
        else
            add(chunk, problem);
    }

    /// The next whole chunk of a known type after a damaged one, or -1: right behind it, as its length says, or where
    /// one is found.
    qsizetype nextWhole(const Chunk &broken)
    {
        if (!broken.payload.isNull()) {
            const qsizetype behind = broken.start + broken.size();
            if (behind == m_bytes.size())
                return broken.type == "ENDS" ? -1 : behind;
            if (isWhole(behind))
                return behind;
        }
        for (qsizetype at = broken.start + 1; at + 12 <= m_bytes.size() && m_budget > 0; ++at) {
            if (isWhole(at))
                return at;
        }
        return -1;
    }

    /// Each check costs its bytes, so that a hostile file cannot make this long.
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
    bool m_ended = false;
};

} // namespace

std::vector<FilePiece> salvageChunks(const QByteArray &bytes)
{
    return Salvage(bytes).run();
}

Result<std::vector<ChunkInfo>> suffuseChunks(const QByteArray &bytes, const QString &fileName)
{
    if (const auto good = checkSignature(bytes, fileName); !good)
        return Error{good.error()};
    std::vector<ChunkInfo> list;
    for (const FilePiece &piece : salvageChunks(bytes))
        list.push_back({QString::fromLatin1(piece.chunk.type), piece.chunk.start,
                        piece.chunk.payload.isNull() ? 0 : piece.chunk.size(), piece.damage});
    return list;
}

} // namespace suffuse
