// Files of given chunks, for tests of the document format.
#pragma once

#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_layout.h"

#include <QCryptographicHash>

#include <algorithm>
#include <utility>
#include <vector>

namespace suffuse::test {

using ChunkList = std::vector<std::pair<QByteArray, QByteArray>>; ///< type and payload

/// A file of the given chunks with right checksums and end.
inline QByteArray fileOf(const ChunkList &chunks)
{
    QByteArray out = QByteArray(suffuseName) + suffuseLineEnds;
    for (const auto &[type, payload] : chunks)
        appendChunk(out, type.constData(), payload);
    appendChunk(out, "ENDS", QCryptographicHash::hash(out, QCryptographicHash::Sha256));
    return out;
}

/// Those of a whole file, without the end.
inline ChunkList chunksOf(const QByteArray &file)
{
    ChunkList list;
    if (const auto chunks = splitChunks(file, QString()))
        for (const Chunk &chunk : *chunks)
            if (chunk.type != "ENDS")
                list.emplace_back(chunk.type, chunk.payload.toByteArray());
    return list;
}

/// Where the chunk number `which` of a type starts in a whole file, or -1.
inline qsizetype startOf(const QByteArray &file, const char *type, int which = 0)
{
    if (const auto chunks = splitChunks(file, QString()))
        for (const Chunk &chunk : *chunks)
            if (chunk.type == type && which-- == 0)
                return chunk.start;
    return -1;
}

} // namespace suffuse::test
