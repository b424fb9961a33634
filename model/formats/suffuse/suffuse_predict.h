// How the columns of a stroke are predicted from what was read before, by the same walk for writing and reading
// (docs/file-format.md, "Prediction"). It uses only +, −, ×, ÷ of doubles and rounding, so it gives the same bits
// everywhere.
#pragma once

#include "model/painting/fields.h"

#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <vector>

namespace suffuse {

/// How a column of one stroke is stored. With −1 digits it is stored by the bits of its floats, with 0…7 as decimals of
/// so many places. `predictor` is, for a series, the order of the extrapolation, 0…3; for handles see HandlePredictor.
struct ColumnMode {
    int digits = -1;
    int predictor = 1;

    std::uint8_t toByte() const { return std::uint8_t((digits + 1) * 4 + predictor); }
    static ColumnMode fromByte(std::uint8_t byte) { return {byte / 4 - 1, byte % 4}; }
    static constexpr std::uint8_t largestByte = 8 * 4 + 3;
};

enum HandlePredictor { StraightHandles, NeighbourHandles, SmoothHandles, TimedHandles };

inline constexpr std::array<double, 8> powersOfTen{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};

/// The bits of a float as an integer that grows with the value.
inline std::int32_t orderedBits(float value)
{
    const auto bits = std::bit_cast<std::int32_t>(value);
    return bits < 0 ? bits ^ 0x7fffffff : bits;
}

inline float fromOrderedBits(std::int32_t order)
{
    return std::bit_cast<float>(order < 0 ? order ^ 0x7fffffff : order);
}

inline std::int32_t quantised(double value, int digits)
{
    if (digits < 0)
        return orderedBits(float(value));
    const double scaled = value * powersOfTen[std::size_t(digits)];
    if (!(std::abs(scaled) < 2e9))
        return 0;
    const double up = scaled + 0.5;
    // This rounds towards 0. std::floor would be a function call where there is no SSE 4.1.
    const auto whole = std::int32_t(up);
    return whole - (double(whole) > up);
}

inline float dequantised(std::int32_t step, int digits)
{
    return digits < 0 ? fromOrderedBits(step) : float(double(step) / powersOfTen[std::size_t(digits)]);
}

/// Turns small numbers of either sign into small numbers without sign.
inline std::uint32_t zigzag(std::uint32_t difference)
{
    return difference << 1 ^ (difference & 0x80000000u ? ~0u : 0u);
}
inline std::uint32_t unzigzag(std::uint32_t code)
{
    return code >> 1 ^ (code & 1 ? ~0u : 0u);
}
inline std::uint64_t zigzag64(std::uint64_t difference)
{
    return difference << 1 ^ (difference >> 63 ? ~std::uint64_t(0) : 0);
}
inline std::uint64_t unzigzag64(std::uint64_t code)
{
    return code >> 1 ^ (code & 1 ? ~std::uint64_t(0) : 0);
}

/// The numbers of a stroke as columns. Segment k goes from node k to node k + 1; one that begins another chain goes
/// from a place of its own to node k + 1.
struct StrokeColumns {
    /// The numbers that are predicted: D, φ, ω, t_max, red, yellow, blue, opacity.
    static constexpr std::size_t attributeCount = predictedNumbersOf<Segment>.size();
    std::array<std::vector<float>, 2> node;                  ///< x, y
    std::array<std::array<std::vector<float>, 2>, 2> handle; ///< [first, second][x, y]
    std::array<std::vector<float>, attributeCount> attribute;
    std::vector<Microseconds> born;
    std::vector<std::uint8_t> starts; ///< 1 for each segment that begins another chain; empty where none does
    /// x and y by segment, for those that begin another chain; as long as `starts`
    std::array<std::vector<float>, 2> startsAt;

    bool isStart(std::size_t segment) const { return !starts.empty() && starts[segment]; }
    /// Where a segment begins, on one axis.
    float beginOf(std::size_t axis, std::size_t segment) const
    {
        return isStart(segment) ? startsAt[axis][segment] : node[axis][segment];
    }

    void resize(std::size_t segments)
    {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            node[axis].resize(segments + 1);
            handle[0][axis].resize(segments);
            handle[1][axis].resize(segments);
        }
        for (auto &a : attribute)
            a.resize(segments);
        born.resize(segments);
    }
};

/// Calls code(value, prediction) for each value in turn. A prediction uses only values before it. `carry` counts as the
/// value before the first.
template <typename Code>
void walkSeries(std::span<float> values, float carry, int predictor, Code code)
{
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double a = k > 0 ? values[k - 1] : carry;
        double prediction = a;
        if (predictor == 0)
            prediction = 0;
        else if (predictor >= 2 && k >= 2)
            prediction = predictor == 2 || k == 2 ? 2 * a - double(values[k - 2])
                                                  : 3 * a - 3 * double(values[k - 2]) + double(values[k - 3]);
        code(values[k], prediction);
    }
}

/// The ratio of the time of segment k to that of the one before, as far as `born` tells. If it is near a power of 2, it
/// is that.
inline double timeRatio(const std::vector<Microseconds> &born, std::size_t k)
{
    if (k + 1 >= born.size())
        return 1;
    const double before = double(born[k]) - double(born[k - 1]), now = double(born[k + 1]) - double(born[k]);
    if (!(before > 0 && now > 0))
        return 1;
    const double ratio = now / before;
    for (double power = 1.0 / 64; power <= 64; power *= 2) {
        if (std::abs(ratio - power) < 0.01 * power)
            return power;
    }
    return ratio;
}

/// Calls code(value, prediction) for the handles of one axis: the first and the second of each of the first `count`
/// segments in turn. All nodes and births are known.
template <typename Code>
void walkHandles(StrokeColumns &columns, std::size_t axis, std::size_t count, int predictor, Code code)
{
    const std::vector<float> &node = columns.node[axis];
    const std::vector<Microseconds> &born = columns.born;
    std::vector<float> &first = columns.handle[0][axis], &second = columns.handle[1][axis];
    for (std::size_t k = 0; k < count; ++k) {
        const bool begins = k == 0 || columns.isStart(k), ends = k + 1 == born.size() || columns.isStart(k + 1);
        const double a = columns.beginOf(axis, k), b = node[k + 1];
        if (predictor == NeighbourHandles) {
            code(first[k], a + (b - (begins ? a : double(columns.beginOf(axis, k - 1)))) / 6);
            code(second[k], b - ((ends ? b : double(node[k + 2])) - a) / 6);
        } else if (predictor == StraightHandles || begins) {
            code(first[k], a + (b - a) / 3);
            code(second[k], b - (b - a) / 3);
        } else {
            // Velocity and acceleration continue through the node, as in a spline with knots at the nodes.
            const double ratio = predictor == TimedHandles ? timeRatio(born, k) : 1;
            const double p1 = first[k - 1], p2 = second[k - 1];
            code(first[k], a + ratio * (a - p2));
            code(second[k], 2 * double(first[k]) - a + ratio * ratio * (a - 2 * p2 + p1));
        }
    }
}

} // namespace suffuse
