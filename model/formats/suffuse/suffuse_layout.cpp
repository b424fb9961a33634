#include "model/formats/suffuse/suffuse_layout.h"

#include "model/formats/files.h"
#include "model/formats/messages.h"

#include <QCryptographicHash>

namespace suffuse {

namespace {

constexpr std::array<std::uint32_t, 256> crcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t k = 0; k < 256; ++k) {
        std::uint32_t value = k;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ (value & 1 ? 0x82f63b78u : 0);
        table[k] = value;
    }
    return table;
}();

std::uint32_t readU32(const char *p)
{
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k)
        value = value << 8 | static_cast<unsigned char>(p[k]);
    return value;
}

QString damaged()
{
    return FileMessages::tr("the file is damaged, take a backup copy");
}

} // namespace

std::uint32_t crc32c(const char *bytes, std::size_t size)
{
    std::uint32_t crc = ~0u;
    for (std::size_t k = 0; k < size; ++k)
        crc = (crc >> 8) ^ crcTable[(crc ^ static_cast<unsigned char>(bytes[k])) & 255];
    return ~crc;
}

void appendU32(QByteArray &out, std::uint32_t value)
{
    for (int k = 0; k < 4; ++k, value >>= 8)
        out.append(char(value & 255));
}

void appendVarint(QByteArray &out, std::uint64_t value)
{
    for (; value >= 128; value >>= 7)
        out.append(char(value & 127) | char(-128));
    out.append(char(value));
}

void appendChunk(QByteArray &out, const char *type, const QByteArray &payload)
{
    const qsizetype start = out.size();
    out.append(type, 4);
    appendU32(out, std::uint32_t(payload.size()));
    out.append(payload);
    appendU32(out, crc32c(out.constData() + start, std::size_t(out.size() - start)));
}

QString chunkText(const Chunk &chunk, const QString &what)
{
    return FileMessages::tr("chunk %1 at byte %2: %3")
        .arg(excerpt({chunk.type.constData(), std::size_t(chunk.type.size())}))
        .arg(chunk.start)
        .arg(what);
}

Error chunkError(const QString &fileName, const Chunk &chunk, const QString &what)
{
    return fileError(fileName, chunkText(chunk, what) + QStringLiteral("; ") + damaged());
}

bool startsAsSuffuse(const QByteArray &bytes)
{
    return bytes.startsWith(suffuseName);
}

QString problemOfSignature(const QByteArray &bytes)
{
    if (bytes.startsWith(QByteArray(suffuseName) + suffuseLineEnds))
        return {};
    if (bytes.size() < suffuseSignatureSize)
        return FileMessages::tr("ends after %1 bytes").arg(bytes.size());
    const QByteArray ends = bytes.mid(8, 5);
    // These arise when a file is transferred as text between systems.
    for (const char *changed : {"\n\x1a\n", "\r\r\n", "\r\n\x1a\r\n"})
        if (startsAsSuffuse(bytes) && ends.startsWith(changed))
            return FileMessages::tr("its line endings were changed on the way, transfer it as a binary file");
    return FileMessages::tr("its first bytes are damaged");
}

Result<void> checkSignature(const QByteArray &bytes, const QString &fileName)
{
    const QString problem = problemOfSignature(bytes);
    if (problem.isEmpty())
        return {};
    if (!startsAsSuffuse(bytes) && !hasAnyChunk(bytes))
        return fileError(fileName, FileMessages::tr("is not a .suffuse file"));
    return fileError(fileName, problem + QStringLiteral("; ") + damaged());
}

ChunkAttempt chunkAt(const QByteArray &bytes, qsizetype at)
{
    const qsizetype left = bytes.size() - at;
    ChunkAttempt out{{bytes.mid(at, 4), at, {}}, {}};
    if (left < 12) {
        out.problem = FileMessages::tr("is cut off after %1 bytes").arg(bytes.size());
        return out;
    }
    const qsizetype length = qsizetype(readU32(bytes.constData() + at + 4));
    if (length > left - 12) {
        out.problem = FileMessages::tr("has %1 bytes, but the file only %2 more").arg(length).arg(left - 12);
        return out;
    }
    out.chunk.payload = QByteArrayView(bytes).sliced(at + 8, length);
    if (readU32(bytes.constData() + at + 8 + length) != crc32c(bytes.constData() + at, std::size_t(length + 8)))
        out.problem = FileMessages::tr("checksum differs");
    return out;
}

QString problemOfEnd(const QByteArray &bytes, const Chunk &end, qsizetype first)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArrayView(suffuseName));
    hash.addData(QByteArrayView(suffuseLineEnds));
    hash.addData(QByteArrayView(bytes).sliced(first, end.start - first));
    if (end.payload != hash.result())
        return FileMessages::tr("the hash of the whole differs");
    if (end.start + end.size() != bytes.size())
        return FileMessages::tr("%1 bytes follow after the end").arg(bytes.size() - end.start - end.size());
    return {};
}

Result<std::vector<Chunk>> splitChunks(const QByteArray &bytes, const QString &fileName)
{
    if (const auto good = checkSignature(bytes, fileName); !good)
        return Error{good.error()};
    std::vector<Chunk> chunks;
    for (qsizetype at = suffuseSignatureSize; chunks.empty() || chunks.back().type != "ENDS";) {
        const ChunkAttempt attempt = chunkAt(bytes, at);
        if (bytes.size() - at < 12)
            return fileError(fileName, attempt.problem + QStringLiteral("; ") + damaged());
        if (!attempt.problem.isEmpty())
            return chunkError(fileName, attempt.chunk, attempt.problem);
        at += attempt.chunk.size();
        chunks.push_back(attempt.chunk);
    }
    if (const QString problem = problemOfEnd(bytes, chunks.back()); !problem.isEmpty())
        return chunkError(fileName, chunks.back(), problem);
    return chunks;
}

std::uint8_t ByteCursor::u8()
{
    const QByteArrayView one = take(1);
    return one.isEmpty() ? 0 : static_cast<std::uint8_t>(one[0]);
}

std::uint32_t ByteCursor::u32()
{
    const QByteArrayView four = take(4);
    return four.isEmpty() ? 0 : readU32(four.data());
}

std::uint64_t ByteCursor::varint()
{
    std::uint64_t value = 0;
    for (int shift = 0; m_ok; shift += 7) {
        const std::uint8_t byte = u8();
        if (shift > 63 || (shift == 63 && byte > 1))
            m_ok = false;
        else
            value |= std::uint64_t(byte & 127) << shift;
        if (byte < 128)
            break;
    }
    return m_ok ? value : 0;
}

QByteArrayView ByteCursor::take(std::uint64_t size)
{
    m_ok = m_ok && size <= std::uint64_t(left());
    if (!m_ok)
        return {};
    const QByteArrayView part = m_bytes.sliced(m_at, qsizetype(size));
    m_at += qsizetype(size);
    return part;
}

} // namespace suffuse
