#include "render/cpu/prefix_sums.h"

#include <algorithm>

namespace suffuse::cpu {

std::size_t bytesOf(const StrokePrefix &prefix)
{
    std::size_t bytes = sizeof prefix;
    for (const BlockPrefix &block : prefix.blocks)
        bytes += sizeof block + block.sums.size() * sizeof(float);
    return bytes;
}

std::size_t steadyNodes(const SceneStroke &before, const SceneStroke &now)
{
    if (before.channels != now.channels)
        return 0;
    std::size_t rows = std::min(before.source->settledRows, now.source->settledRows);
    if (now.channels > 0) {
        const auto differ = std::ranges::mismatch(before.values, now.values).in2;
        rows = std::min(rows, std::size_t(differ - now.values.begin()) / std::size_t(now.channels));
    }
    const auto separable = [](const SceneStroke &s) { return s.nodes.begin() + s.separable; };
    const auto differ =
        std::mismatch(before.nodes.begin(), separable(before), now.nodes.begin(), separable(now)).second;
    // Rows rise among the nodes that lay paint, and once more among those that take it away.
    const auto end = std::find_if(now.nodes.begin(), differ, [rows](const ViewNode &n) { return n.row >= rows; });
    return std::size_t(end - now.nodes.begin());
}

} // namespace suffuse::cpu
