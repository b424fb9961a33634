#include "render/cpu/layer_cache.h"

#include <algorithm>

namespace suffuse::cpu {

StrokePrefix &TileLayers::prefixOf(std::uint32_t stroke)
{
    const auto known = std::ranges::find(prefixes, stroke, &StrokePrefix::stroke);
    return known != prefixes.end() ? *known : prefixes.emplace_back(StrokePrefix{stroke, 0, {}, {}});
}

void LayerCache::dropOver()
{
    for (auto &[tile, layers] : m_tiles)
        layers.over.clear();
}

void LayerCache::dropPrefixes()
{
    for (auto &[tile, layers] : m_tiles)
        layers.prefixes.clear();
}

void LayerCache::dropPrefixes(std::size_t below)
{
    for (auto &[tile, layers] : m_tiles)
        std::erase_if(layers.prefixes, [below](const StrokePrefix &prefix) { return prefix.stroke < below; });
}

void LayerCache::dropPrefixes(const std::vector<SteadyStroke> &changed)
{
    for (auto &[tile, layers] : m_tiles)
        std::erase_if(layers.prefixes, [&](const StrokePrefix &prefix) {
            const auto steady = std::ranges::lower_bound(changed, prefix.stroke, {}, &SteadyStroke::stroke);
            return steady != changed.end() && steady->stroke == prefix.stroke && prefix.nodes > steady->nodes;
        });
}

void LayerCache::keep(const std::vector<std::size_t> &usedNow)
{
    ++m_clock;
    for (std::size_t tile : usedNow)
        if (const auto it = m_tiles.find(tile); it != m_tiles.end())
            it->second.used = m_clock;
    const auto layerBytes = [](const TileLayers &t) {
        std::size_t sums = 0;
        for (const StrokePrefix &prefix : t.prefixes)
            sums += bytesOf(prefix);
        std::size_t open = 0, bounds = 0, over = 0;
        for (const OverSteps &steps : t.over)
            over += steps.bytes();
        for (const OpenLayers &layers : t.open)
            open += layers.below.size(), bounds += layers.bounds.size();
        return (t.under.size() + open) * sizeof(Backdrop) + bounds * sizeof(LayerBounds) + over + sums;
    };
    std::size_t bytes = 0;
    for (const auto &[tile, layers] : m_tiles)
        bytes += layerBytes(layers);
    if (bytes <= m_capacity)
        return;
    std::vector<std::pair<std::uint64_t, std::size_t>> byAge;
    for (const auto &[tile, layers] : m_tiles)
        byAge.emplace_back(layers.used, tile);
    std::sort(byAge.begin(), byAge.end());
    for (const auto &[used, tile] : byAge) {
        if (bytes <= m_capacity)
            break;
        bytes -= layerBytes(m_tiles[tile]);
        m_tiles.erase(tile);
    }
}

} // namespace suffuse::cpu
