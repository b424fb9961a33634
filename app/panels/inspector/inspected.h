// What the inspector's sections show: the target segments with their strokes, and the values that they have in common.
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

/// What is inspected. The pointers are valid as long as `painting` lives.
struct Inspected {
    PaintingPtr painting;
    std::vector<SegmentRef> refs;
    std::vector<InspectedSegment> segments; ///< in the order of `refs`
    std::vector<const Stroke *> strokes;    ///< each stroke once, bottom to top
    bool isEmpty() const { return segments.empty(); }
    /// Whether all of it takes paint away.
    bool isErasure() const;
};

/// Whether all of the strokes lie in washes (Group::wash), whose style and mixing are seen in place of their own.
bool areInWashes(const Inspected &inspected);

/// Finds what is inspected by the document's selection (see targetSegments), in one pass over the painting.
Inspected inspect(const Document &document);

/// The value that all items have. There is none if they differ, or if there is no item.
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

/// Does the same as commonValue, for fields that show doubles.
template <typename Items, typename Get>
std::optional<double> commonNumber(const Items &items, Get get)
{
    const auto value = commonValue(items, get);
    return value ? std::optional<double>(double(*value)) : std::nullopt;
}

} // namespace suffuse
