// What the inspector's sections show: the target segments with their strokes, and values that they have in common.
#pragma once

#include "model/document/document.h"

#include <optional>
#include <vector>

namespace suffuse {

struct InspectedSegment {
    const Stroke *stroke = nullptr;
    const Segment *segment = nullptr;
    const Style &style() const { return stroke->styleOf(*segment); }
};

/// Pointers live as long as `painting`.
struct Inspected {
    PaintingPtr painting;
    std::vector<SegmentRef> refs;
    std::vector<InspectedSegment> segments; ///< in step with refs
    std::vector<const Stroke *> strokes;    ///< each once, bottom to top
    bool isEmpty() const { return segments.empty(); }
};

/// Of the document's selection (targetSegments). One pass over the painting.
Inspected inspect(const Document &document);

/// The value that all items have; none if they differ, or there are none.
template <typename Items, typename Get>
auto commonValue(const Items &items, Get get) -> std::optional<std::decay_t<decltype(get(*items.begin()))>>
{
    if (items.empty())
        return std::nullopt;
    const auto first = get(*items.begin());
    for (const auto &item : items)
        if (!(get(item) == first))
            return std::nullopt;
    return first;
}

/// As commonValue, for fields that show doubles.
template <typename Items, typename Get>
std::optional<double> commonNumber(const Items &items, Get get)
{
    const auto value = commonValue(items, get);
    return value ? std::optional<double>(double(*value)) : std::nullopt;
}

} // namespace suffuse
