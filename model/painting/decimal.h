// Sums that people expect to be exact in decimals.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse {

/// a + b; if that is a number of at most nine decimals but for rounding, it is that number: 0.1 + 0.2 is 0.3. So steps
/// there and back end where they began, and files contain what was meant.
inline double decimalSum(double a, double b)
{
    constexpr double decimals = 1e9;
    const double sum = a + b, nearest = std::round(sum * decimals) / decimals;
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * std::max({std::abs(a), std::abs(b)});
    return std::abs(nearest - sum) <= rounding ? nearest : sum;
}

} // namespace suffuse
