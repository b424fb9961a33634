// The text form: what is accepted is valid, and comes back from what is written of it.
#include "fuzzing.h"

#include "model/formats/files.h"

using namespace suffuse;

int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const Result<Painting> first = readTextForm(bytesOf(data, size), QStringLiteral("a.json"));
    if (!first) {
        require(!first.error().isEmpty(), "an error says what is wrong");
        return 0;
    }
    const Result<Painting> again = readTextForm(writeTextForm(*first), QStringLiteral("b.json"));
    require(again && *again == *first, "text form: written = read");
    const Result<Painting> packed = readSuffuseFile(writeSuffuseFile(*first), QStringLiteral("c.suffuse"));
    require(packed && *packed == *first, "document: written = read");
    return 0;
}
