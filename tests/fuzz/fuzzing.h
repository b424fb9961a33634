// What the fuzzers share.
#pragma once

#include "model/formats/suffuse/suffuse_layout.h"

#include <QByteArray>
#include <QCryptographicHash>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace suffuse {

inline QByteArray bytesOf(const std::uint8_t *data, std::size_t size)
{
    return {reinterpret_cast<const char *>(data), qsizetype(size)};
}

/// The chunks of a document or journal with checksums that fit, the last one as long as there are bytes; documents get
/// an end of their own, and a journal's document inside is put right as well.
inline QByteArray repaired(const QByteArray &bytes, const QByteArray &signature, bool isDocument)
{
    QByteArray out = signature;
    for (qsizetype at = signature.size(); at + 8 <= bytes.size();) {
        const QByteArray type = bytes.mid(at, 4);
        ByteCursor cursor(QByteArrayView(bytes).sliced(at + 4));
        const qsizetype length = std::min(qsizetype(cursor.u32()), bytes.size() - at - 8);
        if (isDocument && type == "ENDS")
            break;
        QByteArray payload = bytes.mid(at + 8, length);
        if (!isDocument && type == "BASE")
            payload = repaired(payload, QByteArray(suffuseName).append(suffuseLineEnds, 4), true);
        appendChunk(out, type.constData(), payload);
        at += 8 + length + 4;
    }
    if (isDocument)
        appendChunk(out, "ENDS", QCryptographicHash::hash(out, QCryptographicHash::Sha256));
    return out;
}

/// Ends the program, so that libFuzzer keeps the input.
inline void require(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

} // namespace suffuse

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);
