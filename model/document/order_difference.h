// What differs between two orders of strokes. Its size is in proportion to the strokes that moved.
#pragma once

#include "model/painting/ids.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace suffuse {

/// A stroke and its place in an order, counted from 0 at the bottom.
struct StrokePlace {
    std::uint32_t index = 0;
    StrokeId stroke = 0;

    bool operator==(const StrokePlace &) const = default;
};

/// The strokes that were added or moved, by rising index. The others keep their order. Strokes that were removed are
/// not named, since an edit knows them.
using OrderDifference = std::vector<StrokePlace>;

/// What turns `before` into `after`, which are both without repeats. It names as few strokes as possible (the others
/// are a longest rising sequence), and costs n + m log m, where m strokes stand between the first and the last
/// difference.
OrderDifference orderDifference(const std::vector<StrokeId> &before, const std::vector<StrokeId> &after);

/// The order `before` without the strokes that are removed, and with those of the difference in their places.
std::vector<StrokeId> reordered(const std::vector<StrokeId> &before, const OrderDifference &difference,
                                const std::function<bool(StrokeId)> &goes);

} // namespace suffuse
