// Recordings of every format, found from their content as a window finds it; they become valid paintings or errors.
#include "fuzzing.h"

#include "model/formats/files.h"

using namespace suffuse;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    const FileFormat format = detectFormat(bytes);
    if (format == FileFormat::Suffuse || format == FileFormat::Text)
        return 0; // these have fuzzers of their own
    const Result<Painting> painting = readPainting(bytes, QStringLiteral("a.csv"));
    if (!painting)
        return 0;
    const Result<Painting> again = readTextForm(writeTextForm(*painting), QStringLiteral("b.json"));
    require(again && *again == *painting, "an imported painting is a valid one");
    return 0;
}
