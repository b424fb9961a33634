#include "model/formats/suffuse/suffuse_preview.h"

#include "model/formats/suffuse/suffuse_extras.h"

namespace suffuse {

QByteArray previewIn(const QByteArray &start)
{
    DocumentExtras extras;
    if (!startsAsSuffuse(start))
        return {};
    for (qsizetype at = suffuseSignatureSize; at < start.size();) {
        const ChunkAttempt attempt = chunkAt(start, at);
        if (!attempt.problem.isEmpty())
            break;
        if (attempt.chunk.type == previewType) {
            readExtra(attempt.chunk, extras);
            break;
        }
        at += attempt.chunk.size();
    }
    return extras.preview;
}

} // namespace suffuse
