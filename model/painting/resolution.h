// How large canvas units are on paper.
#pragma once

namespace suffuse {

inline constexpr double millimetresOfInch = 25.4;
/// Canvas units an inch, where a painting does not say how many.
inline constexpr double usualResolution = 150;
inline constexpr double leastResolution = 1, mostResolution = 10'000;

/// Whether a painting may have so many canvas units an inch; false for what is no number.
constexpr bool isResolution(double unitsOfInch)
{
    return unitsOfInch >= leastResolution && unitsOfInch <= mostResolution;
}

} // namespace suffuse
