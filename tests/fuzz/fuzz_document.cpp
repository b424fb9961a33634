// Documents: as they come, and with lengths, checksums and hash put right, so that what is inside is reached.
#include "fuzzing.h"

#include "model/formats/files.h"
#include "model/formats/suffuse_layout.h"

#include <QCryptographicHash>

using namespace suffuse;

namespace {

/// The same chunks with checksums that fit, the last one as long as there are bytes, and an end of its own.
QByteArray repaired(const QByteArray &bytes)
{
    QByteArray out = QByteArray(suffuseName).append(suffuseLineEnds, 4);
    for (qsizetype at = suffuseSignatureSize; at + 8 <= bytes.size();) {
        const QByteArray type = bytes.mid(at, 4);
        ByteCursor cursor(QByteArrayView(bytes).sliced(at + 4));
        const qsizetype length = std::min(qsizetype(cursor.u32()), bytes.size() - at - 8);
        if (type == "ENDS")
            break;
        appendChunk(out, type.constData(), bytes.mid(at + 8, length));
        at += 8 + length + 4;
    }
    const QByteArray hash = QCryptographicHash::hash(out, QCryptographicHash::Sha256);
    appendChunk(out, "ENDS", hash);
    return out;
}

void read(const QByteArray &bytes)
{
    const Result<LoadedDocument> loaded = readDocument(bytes, QStringLiteral("a.suffuse"));
    if (!loaded)
        return;
    const QByteArray written = writeDocument(loaded->painting, loaded->extras, FileFormat::Suffuse);
    const Result<LoadedDocument> again = readDocument(written, QStringLiteral("b.suffuse"));
    require(again && again->losses.empty(), "what is written is whole");
    require(again->painting == loaded->painting, "written = read");
    require(again->extras == loaded->extras, "the extras too");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    read(bytes);
    read(repaired(bytes));
    return 0;
}
