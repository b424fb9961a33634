#include "model/shaping/curves/chain_strokes.h"

#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/painting/influence.h"

#include <numeric>

namespace suffuse {

namespace {

std::vector<std::vector<Chain>> eachAlone(const std::vector<Chain> &chains)
{
    std::vector<std::vector<Chain>> groups;
    for (const Chain &chain : chains)
        groups.push_back({chain});
    return groups;
}

/// Those of the chains of a filled stroke together that enclose a part of the same area. Pieces that meet along a cut
/// have that in common by as much as numbers are rounded.
std::vector<std::vector<Chain>> chainsByArea(const Stroke &stroke, const std::vector<Chain> &chains)
{
    constexpr double rounding = 1e-5; // of the square of their size
    std::vector<Area> areas;
    std::vector<Rect> boxes;
    for (const Chain &chain : chains) {
        areas.push_back(areaOf(closedOutline(chainOnly(stroke, chain)), FillRule::NonZero));
        boxes.push_back(areas.back().box());
    }
    std::vector<std::size_t> group(chains.size());
    std::iota(group.begin(), group.end(), std::size_t(0));
    for (std::size_t i = 0; i < chains.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (group[i] == group[j] || !boxes[i].intersects(boxes[j]))
                continue;
            const auto across = [](const Rect &box) { return std::max(box.width(), box.height()); };
            const double size = std::min(across(boxes[i]), across(boxes[j]));
            if (sizeOf(intersection(areas[i], areas[j])) <= rounding * size * size)
                continue;
            const std::size_t gone = std::max(group[i], group[j]), stays = std::min(group[i], group[j]);
            std::ranges::replace(group, gone, stays);
        }
    std::vector<std::vector<Chain>> groups;
    for (std::size_t g = 0; g < chains.size(); ++g) {
        std::vector<Chain> together;
        for (std::size_t i = 0; i < chains.size(); ++i)
            if (group[i] == g)
                together.push_back(chains[i]);
        if (!together.empty())
            groups.push_back(std::move(together));
    }
    return groups;
}

} // namespace

std::vector<Stroke> strokesOfChains(const Stroke &stroke, std::vector<int> *sources)
{
    std::vector<Stroke> strokes;
    const Microseconds dry = stroke.driesAt();
    std::vector<Chain> laid, lifts;
    for (const Chain &chain : chainsOf(stroke))
        (stroke.segments[std::size_t(chain.first)].takesPaint() ? lifts : laid).push_back(chain);
    for (const std::vector<Chain> &together : stroke.fill ? chainsByArea(stroke, laid) : eachAlone(laid)) {
        Stroke &one = strokes.emplace_back(chainOnly(stroke, together.front()));
        std::vector<int> from;
        const auto note = [&from](const Chain &added) {
            for (int k = added.first; k <= added.last; ++k)
                from.push_back(k);
        };
        const auto add = [&](const Chain &chain) {
            appendChain(one, chainOnly(stroke, chain).segments);
            note(chain);
        };
        note(together.front());
        std::for_each(together.begin() + 1, together.end(), add);
        const Rect reach = influenceOf(one, dry);
        for (const Chain &other : lifts)
            if (influenceOf(chainOnly(stroke, other), dry).intersects(reach))
                add(other);
        if (sources)
            sources->insert(sources->end(), from.begin(), from.end());
    }
    return strokes;
}

} // namespace suffuse
