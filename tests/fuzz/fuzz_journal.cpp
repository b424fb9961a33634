// Journals: as they come, and with lengths and checksums put right.
#include "fuzzing.h"

#include "model/journal/journal_format.h"
#include "model/painting/validate.h"

using namespace suffuse;

namespace {

void read(const QByteArray &bytes)
{
    if (const Result<JournalContent> content = readJournal(bytes, QStringLiteral("a.journal")))
        require(problemOf(content->painting).isEmpty(), "what a journal gives back is valid");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes = bytesOf(data, size);
    read(bytes);
    read(repaired(bytes, QByteArray("\x89SUFFJRN\r\n\x1a\n", 12), false));
    return 0;
}
