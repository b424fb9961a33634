// Deflate (RFC 1951) without a search for matches, by Huffman codes and runs of one byte. After PNG's filters, runs of
// zeros are most of what a search would find. Pictures of soft paint get 2 % larger by what is left out.
#include "render/image_io/module/formats.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <queue>
#include <span>
#include <vector>

namespace suffuse {

namespace {

using Byte = unsigned char;

constexpr int shortestRun = 3, longestRun = 258;
constexpr int endOfBlock = 256, firstLength = 257, codes = 286, longestCode = 15;
constexpr std::size_t blockBytes = 1 << 17;

/// The elements of a block: a byte, or 256 plus the length of a run of the byte before.
using Token = std::uint16_t;
constexpr int tokens = endOfBlock + longestRun + 1;

struct Bits {
    std::uint64_t value = 0; ///< the first one is the lowest
    int count = 0;

    Bits then(Bits next) const { return {value | next.value << count, count + next.count}; }
};

/// The code for the length of a run, and its extra bits.
std::pair<int, Bits> lengthCode(int length)
{
    if (length == longestRun)
        return {codes - 1, {}};
    const auto over = unsigned(length - shortestRun);
    const int extra = over < 8 ? 0 : std::bit_width(over) - 3;
    return {firstLength + 4 * extra + int(over >> extra), {over & ((1u << extra) - 1), extra}};
}

/// The lengths of a Huffman code's words; 0 where a count is 0. Counts are evened out until no word is too long.
std::array<Byte, codes> wordLengths(std::array<std::uint32_t, codes> counts)
{
    using Node = std::pair<std::uint64_t, int>; // count and index
    while (true) {
        std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
        std::array<int, 2 * codes> parent{};
        for (int i = 0; i < codes; ++i)
            if (counts[std::size_t(i)] > 0)
                open.emplace(counts[std::size_t(i)], i);
        int next = codes;
        for (; open.size() > 1; ++next) {
            const Node a = open.top();
            open.pop();
            const Node b = open.top();
            open.pop();
            parent[std::size_t(a.second)] = parent[std::size_t(b.second)] = next;
            open.emplace(a.first + b.first, next);
        }
        std::array<int, 2 * codes> depth{};
        for (int i = next - 2; i >= codes; --i)
            depth[std::size_t(i)] = depth[std::size_t(parent[std::size_t(i)])] + 1;
        std::array<Byte, codes> lengths{};
        for (std::size_t i = 0; i < codes; ++i)
            if (counts[i] > 0)
                lengths[i] = Byte(depth[std::size_t(parent[i])] + 1);
        if (*std::max_element(lengths.begin(), lengths.end()) <= longestCode)
            return lengths;
        for (std::uint32_t &count : counts)
            count = (count + 1) / 2;
    }
}

std::uint32_t reversed(std::uint32_t word, int count)
{
    std::uint32_t out = 0;
    for (int i = 0; i < count; ++i)
        out |= (word >> i & 1) << (count - 1 - i);
    return out;
}

/// The canonical words that have these lengths.
std::array<Bits, codes> wordsOf(const std::array<Byte, codes> &lengths)
{
    std::array<Bits, codes> words;
    std::uint32_t word = 0;
    for (int length = 1; length <= longestCode; ++length, word <<= 1)
        for (std::size_t i = 0; i < codes; ++i)
            if (lengths[i] == length)
                words[i] = {reversed(word++, length), length};
    return words;
}

class BitWriter {
public:
    explicit BitWriter(Byte *to) : m_to(to) {}

    /// Writes at most 56 bits. Eight bytes are written, of which the whole ones count.
    void put(Bits bits)
    {
        m_waiting |= bits.value << m_count;
        m_count += bits.count;
        std::memcpy(m_to, &m_waiting, sizeof m_waiting);
        m_to += m_count >> 3;
        m_waiting >>= m_count & ~7;
        m_count &= 7;
    }
    /// The end, after filling up the last byte.
    Byte *finish() { return m_to + (m_count > 0); }

private:
    static_assert(std::endian::native == std::endian::little);

    Byte *m_to;
    std::uint64_t m_waiting = 0;
    int m_count = 0;
};

/// Writes the tokens of a block, and counts their codes. Returns the end of the tokens.
Token *findRuns(const Byte *from, const Byte *end, Token *to, std::array<std::uint32_t, codes> &counts)
{
    const auto put = [&](Byte byte) {
        *to++ = byte;
        ++counts[byte];
    };
    while (end - from > shortestRun) {
        std::uint32_t four;
        std::memcpy(&four, from, sizeof four);
        put(*from++);
        if (four != std::rotl(four, 8)) // The bytes differ.
            continue;
        const Byte *const most = from + std::min<std::ptrdiff_t>(end - from, longestRun);
        const int length = int(std::find_if(from, most, [four](Byte b) { return b != Byte(four); }) - from);
        *to++ = Token(endOfBlock + length);
        ++counts[std::size_t(lengthCode(length).first)];
        from += length;
    }
    while (from < end)
        put(*from++);
    return to;
}

/// Writes the head of a dynamic block: the lengths of all words, each in four bits, and one distance, 1.
void putHead(BitWriter &out, const std::array<Byte, codes> &lengths, bool last)
{
    constexpr std::uint32_t dynamic = 2;
    out.put({last | dynamic << 1, 3});
    out.put({codes - firstLength, 5});
    out.put({0, 5});
    out.put({15, 4});
    for (int i = 0; i < 19; ++i)
        out.put({i < 3 ? 0u : 4u, 3}); // 16, 17 and 18, which repeat lengths, are not used
    for (const Byte length : lengths)
        out.put({reversed(length, 4), 4});
    out.put({reversed(1, 4), 4});
}

void putBlock(BitWriter &out, std::span<const Token> found, const std::array<std::uint32_t, codes> &counts, bool last)
{
    const std::array<Byte, codes> lengths = wordLengths(counts);
    const std::array<Bits, codes> words = wordsOf(lengths);
    putHead(out, lengths, last);
    std::array<Bits, tokens> of; // whole words: length, extra bits, and the one bit of the distance
    std::copy(words.begin(), words.begin() + firstLength, of.begin());
    for (int length = shortestRun; length <= longestRun; ++length) {
        const auto [code, extra] = lengthCode(length);
        const Bits word = words[std::size_t(code)];
        of[std::size_t(endOfBlock + length)] = word.then(extra).then({0, 1});
    }
    for (; found.size() > 1; found = found.subspan(2)) // Two are written at once, since this takes most of the time.
        out.put(of[found[0]].then(of[found[1]]));
    for (const Token token : found)
        out.put(of[token]);
    out.put(words[endOfBlock]);
}

} // namespace

std::size_t packedRunsBound(std::size_t size)
{
    return size / 8 * 15 + (size / blockBytes + 1) * 256 + 64; // No word is longer than 15 bits.
}

std::size_t packRuns(const unsigned char *from, std::size_t size, unsigned char *to)
{
    constexpr Byte zlibHead[] = {0x78, 0x01};
    std::memcpy(to, zlibHead, 2);
    BitWriter out(to + 2);
    std::vector<Token> found(std::min(size, blockBytes));
    for (std::size_t at = 0; at < size; at += blockBytes) {
        std::array<std::uint32_t, codes> counts{};
        counts[endOfBlock] = 1;
        const std::size_t end = std::min(size, at + blockBytes);
        const Token *last = findRuns(from + at, from + end, found.data(), counts);
        putBlock(out, {found.data(), last}, counts, end == size);
    }
    Byte *tail = out.finish();
    const std::uint32_t check = libdeflate_adler32(1, from, size);
    for (int shift = 24; shift >= 0; shift -= 8)
        *tail++ = Byte(check >> shift);
    return std::size_t(tail - to);
}

} // namespace suffuse
