// Documents: as they come, and with lengths, checksums and hash put right, so that what is inside is reached.
#include "fuzzing.h"

#include "model/formats/files.h"

using namespace suffuse;

namespace {

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
    read(repaired(bytes, QByteArray(suffuseName).append(suffuseLineEnds, 4), true));
    return 0;
}
