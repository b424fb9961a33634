#include "render/nodes/blocks.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace suffuse {

namespace {

/// Hashes a point, so that its number has nothing to do with where it lies. −0 counts as 0, since equal points must
/// have equal numbers.
std::uint64_t numberOf(const Offset &point)
{
    const auto bits = [](float value) { return std::uint64_t(std::bit_cast<std::uint32_t>(value == 0 ? 0 : value)); };
    // The bits are mixed as the generator splitmix64 does it.
    std::uint64_t x = (bits(point.x) << 32 | bits(point.y)) + 0x9e3779b97f4a7c15;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 27) * 0x94d049bb133111eb;
    return x ^ x >> 31;
}

/// Tells whether a stroke is cut before the segment, whatever its points are.
bool isCutBefore(const std::vector<Segment> &segments, std::size_t k)
{
    const Segment &before = segments[k - 1], &here = segments[k];
    return here.start || here.lift != before.lift || here.fade != before.fade;
}

/// Tells whether number k is less than the `reach` numbers on each side, which must all be there. Of equal numbers the
/// first counts as the least.
bool isLeast(std::span<const std::uint64_t> numbers, std::size_t k, std::size_t reach)
{
    if (k < reach || k + reach >= numbers.size())
        return false;
    for (std::size_t i = 1; i <= reach; ++i)
        if (numbers[k] >= numbers[k - i])
            return false;
    for (std::size_t i = 1; i <= reach; ++i)
        if (numbers[k] > numbers[k + i])
            return false;
    return true;
}

/// Finds the places of numbers that are the least within reach, in order. With a reach of 0 that is every place but the
/// first.
///
/// The numbers may be those between two such places of a greater reach, and the numbers beyond are then not asked. That
/// makes no difference: within reach of a place all other numbers are greater, so none of them is the least.
std::vector<std::size_t> leastOf(std::span<const std::uint64_t> numbers, std::size_t reach)
{
    std::vector<std::size_t> places;
    for (std::size_t k = std::max<std::size_t>(reach, 1); k + reach < numbers.size(); ++k)
        if (isLeast(numbers, k, reach)) {
            places.push_back(k);
            k += reach; // None of these is the least, since number k is within their reach.
        }
    return places;
}

/// Appends the ends of the blocks of a run that begins with segment `first` and is cut at `places`, which are counted
/// within it. A piece that is too long is cut again with half the reach.
void appendEnds(std::span<const std::uint64_t> numbers, std::vector<std::size_t> places, std::size_t reach,
                std::size_t first, std::vector<std::size_t> &borders)
{
    places.push_back(numbers.size());
    std::size_t from = 0;
    for (const std::size_t to : places) {
        const auto between = numbers.subspan(from, to - from);
        if (between.size() <= std::max<std::size_t>(4 * reach, 1))
            borders.push_back(first + to);
        else
            appendEnds(between, leastOf(between, reach / 2), reach / 2, first + from, borders);
        from = to;
    }
}

} // namespace

StrokeBlocks blocksOf(const Stroke &stroke, std::size_t from)
{
    const std::vector<Segment> &segments = stroke.segments;
    StrokeBlocks blocks{{from}, {}};
    std::vector<std::uint64_t> numbers;
    for (std::size_t begin = from; begin < segments.size();) {
        numbers.clear();
        std::size_t end = begin;
        do
            numbers.push_back(numberOf(segments[end].bezier[0]));
        while (++end < segments.size() && !isCutBefore(segments, end));
        const std::vector<std::size_t> places = leastOf(numbers, blockReach);
        blocks.firm.push_back(begin);
        for (const std::size_t place : places)
            blocks.firm.push_back(begin + place);
        appendEnds(numbers, places, blockReach, begin, blocks.borders);
        begin = end;
    }
    return blocks;
}

bool isFirmBorder(const Stroke &stroke, std::size_t segment)
{
    const std::vector<Segment> &segments = stroke.segments;
    if (segment == 0 || segment >= segments.size())
        return segment == 0 && !segments.empty();
    if (isCutBefore(segments, segment))
        return true;
    std::size_t begin = segment, end = segment + 1; // These bound the part of its run that decides.
    while (begin > 0 && segment - begin < blockReach && !isCutBefore(segments, begin))
        --begin;
    while (end < segments.size() && end - segment <= blockReach && !isCutBefore(segments, end))
        ++end;
    std::vector<std::uint64_t> numbers;
    for (std::size_t k = begin; k < end; ++k)
        numbers.push_back(numberOf(segments[k].bezier[0]));
    return isLeast(numbers, segment - begin, blockReach);
}

} // namespace suffuse
