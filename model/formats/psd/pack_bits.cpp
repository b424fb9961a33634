#include "model/formats/psd/pack_bits.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr std::size_t longestRun = 128; ///< bytes of one run

/// How many bytes from a place on are the same.
std::size_t runAt(const std::uint8_t *row, std::size_t bytes, std::size_t at)
{
    std::size_t n = 1;
    while (n < longestRun && at + n < bytes && row[at + n] == row[at])
        ++n;
    return n;
}

} // namespace

void packBits(const std::uint8_t *row, std::size_t bytes, QByteArray &out)
{
    constexpr std::size_t worthwhile = 3; // Two alike are better among others: a run of its own would cut those.
    for (std::size_t at = 0; at < bytes;) {
        if (const std::size_t run = runAt(row, bytes, at); run >= worthwhile) {
            out.append(char(1 - int(run)));
            out.append(char(row[at]));
            at += run;
            continue;
        }
        const std::size_t from = at;
        while (at < bytes && at - from < longestRun && runAt(row, bytes, at) < worthwhile)
            ++at;
        out.append(char(at - from - 1));
        out.append(reinterpret_cast<const char *>(row + from), qsizetype(at - from));
    }
}

bool unpackBits(const std::uint8_t *packed, std::size_t size, std::uint8_t *row, std::size_t bytes)
{
    std::size_t at = 0, done = 0;
    while (at < size) {
        const int head = std::int8_t(packed[at++]);
        if (head == -128) // It stands for nothing.
            continue;
        const std::size_t count = std::size_t(head < 0 ? 1 - head : head + 1), taken = head < 0 ? 1 : count;
        if (taken > size - at || count > bytes - done)
            return false;
        if (head < 0)
            std::fill_n(row + done, count, packed[at]);
        else
            std::copy_n(packed + at, count, row + done);
        at += taken, done += count;
    }
    return done == bytes;
}

} // namespace suffuse
