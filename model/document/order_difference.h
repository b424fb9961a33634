// What differs between two orders of strokes, at the cost of what moved.
#pragma once

#include "model/painting/ids.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace suffuse {

/// A stroke and where it stands in an order, 0 at the bottom.
struct StrokePlace {
    std::uint32_t index = 0;
    StrokeId stroke = 0;

    bool operator==(const StrokePlace &) const = default;
};

/// The strokes that came or moved, by rising index. The others keep their turn, and strokes that went are not named: an
/// edit knows them.
using OrderDifference = std::vector<StrokePlace>;

/// What makes `after` of `before`, both without repeats. As few strokes as there can be (the others are a longest
/// rising sequence). Costs n + m log m, where m stand between the first and the last that differ.
OrderDifference orderDifference(const std::vector<StrokeId> &before, const std::vector<StrokeId> &after);

/// `before` without the strokes that go, with those of the difference at their places.
std::vector<StrokeId> reordered(const std::vector<StrokeId> &before, const OrderDifference &difference,
                                const std::function<bool(StrokeId)> &goes);

} // namespace suffuse
