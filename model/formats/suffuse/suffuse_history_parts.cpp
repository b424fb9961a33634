#include "model/formats/suffuse/suffuse_history_parts.h"

#include <algorithm>

namespace suffuse {

QByteArray packHistory(const std::vector<StrokePtr> &strokes, const QByteArray &cbor)
{
    if (std::uint64_t(cbor.size()) > mostHistoryCbor)
        return {};
    std::uint64_t segments = 0, rewets = 0;
    for (const StrokePtr &stroke : strokes) {
        segments += stroke->segments.size();
        for (const Segment &s : stroke->segments)
            rewets += s.rewet.size();
    }
    Density density{segments > freeElements, rewets > freeElements, blockBudget};
    const std::vector<std::span<const StrokePtr>> parts = inChunks(strokes);
    QByteArray out;
    appendVarint(out, parts.size());
    for (const auto &part : parts) {
        const QByteArray chunk = writeStrokes(part, density);
        appendVarint(out, std::uint64_t(chunk.size()));
        out.append(chunk);
    }
    ColumnWriter block;
    std::uint64_t budget = mostHistoryCbor;
    block.putBlock(cbor, budget);
    return out + block.bytes();
}

bool unpackHistory(const QByteArray &bytes, std::vector<StrokePtr> &strokes, QByteArray &cbor)
{
    Allowance allowance(freeElements + std::uint64_t(bytes.size()), blockBudget);
    ByteCursor in(bytes);
    for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left) {
        const QByteArrayView chunk = in.take(in.varint());
        if (!in.ok() || !readStrokes(chunk, allowance, strokes).isEmpty())
            return false;
    }
    ColumnReader block(in.take(std::uint64_t(in.left())));
    cbor = block.getBlock([](std::uint64_t size) { return size <= mostHistoryCbor; });
    return in.ok() && block.atEnd();
}

} // namespace suffuse
