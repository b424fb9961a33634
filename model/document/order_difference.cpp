#include "model/document/order_difference.h"

#include <algorithm>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

using Ids = std::span<const StrokeId>;
constexpr std::size_t none = ~std::size_t(0);

/// Where only one block went past another: how many of `after` stood behind the others in `before`; else 0.
std::size_t blockMoved(Ids before, Ids after)
{
    if (before.empty() || before.size() != after.size())
        return 0;
    const auto middle = std::ranges::find(before, after.front());
    const auto size = std::size_t(before.end() - middle);
    const bool is = std::equal(middle, before.end(), after.begin()) &&
                    std::equal(before.begin(), middle, after.begin() + std::ptrdiff_t(size));
    return is ? size : 0;
}

/// Which elements of `after` belong to a longest sequence that rises in `before` (patience sorting).
std::vector<bool> staying(Ids before, Ids after)
{
    if (const std::size_t size = blockMoved(before, after); size > 0) {
        const bool isShorter = 2 * size < after.size();
        std::vector<bool> stays(after.size(), isShorter);
        std::fill_n(stays.begin(), size, !isShorter);
        return stays;
    }
    std::unordered_map<StrokeId, std::size_t> old;
    old.reserve(before.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        old.emplace(before[i], i);

    std::vector<std::size_t> place(after.size(), none), previous(after.size(), none);
    // ends[k] is where the sequence of k + 1 elements ends that has the lowest last place
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const auto it = old.find(after[i]);
        if (it == old.end())
            continue;
        place[i] = it->second;
        const auto pile =
            std::partition_point(ends.begin(), ends.end(), [&](std::size_t e) { return place[e] < place[i]; });
        if (pile != ends.begin())
            previous[i] = *(pile - 1);
        if (pile == ends.end())
            ends.push_back(i);
        else
            *pile = i;
    }
    std::vector<bool> stays(after.size(), false);
    for (std::size_t i = ends.empty() ? none : ends.back(); i != none; i = previous[i])
        stays[i] = true;
    return stays;
}

} // namespace

OrderDifference orderDifference(const std::vector<StrokeId> &before, const std::vector<StrokeId> &after)
{
    const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    const auto [bEnd, aEnd] =
        std::mismatch(before.rbegin(), std::make_reverse_iterator(b), after.rbegin(), std::make_reverse_iterator(a));
    const std::size_t first = std::size_t(a - after.begin());
    const Ids oldPart(b, bEnd.base()), newPart(a, aEnd.base());
    const std::vector<bool> stays = staying(oldPart, newPart);
    OrderDifference difference;
    for (std::size_t i = 0; i < newPart.size(); ++i)
        if (!stays[i])
            difference.push_back({std::uint32_t(first + i), newPart[i]});
    difference.shrink_to_fit();
    return difference;
}

std::vector<StrokeId> reordered(const std::vector<StrokeId> &before, const OrderDifference &difference,
                                const std::function<bool(StrokeId)> &goes)
{
    std::unordered_set<StrokeId> placed;
    placed.reserve(difference.size());
    for (const StrokePlace &place : difference)
        placed.insert(place.stroke);
    std::vector<StrokeId> after;
    after.reserve(before.size() + difference.size());
    auto next = difference.begin();
    const auto placeWhatIsDue = [&] {
        for (; next != difference.end() && next->index <= after.size(); ++next)
            after.push_back(next->stroke);
    };
    for (StrokeId id : before) {
        if (placed.contains(id) || goes(id))
            continue;
        placeWhatIsDue();
        after.push_back(id);
    }
    for (; next != difference.end(); ++next)
        after.push_back(next->stroke);
    return after;
}

} // namespace suffuse
