// Random numbers that depend on what they are for and on nothing else, so that a stroke is the same whenever it is
// made.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace suffuse {

/// A number in [0, 1) that depends on all of its arguments: Steele, Lea and Flood's mixing function. `channel` is below
/// 64.
inline double randomAt(std::uint64_t seed, int channel, std::int64_t cell)
{
    std::uint64_t z = seed + 0x9E3779B97F4A7C15u * (std::uint64_t(cell) * 64 + std::uint64_t(channel) + 1);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// One value for the whole of what has the seed.
inline double strokeRandom(std::uint64_t seed, int channel)
{
    return randomAt(seed, channel, -1);
}

/// A value that goes smoothly from one random number to the next every unit of `x`.
inline double driftAt(std::uint64_t seed, int channel, double x)
{
    x = std::min(x, 1e15); // Cells are whole numbers.
    const double cell = std::floor(x), u = x - cell;
    const double from = randomAt(seed, channel, std::int64_t(cell)),
                 to = randomAt(seed, channel, std::int64_t(cell) + 1);
    return from + (to - from) * u * u * (3 - 2 * u);
}

} // namespace suffuse
