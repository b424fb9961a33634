#include "render/cpu/layer_cache.h"

#include <algorithm>

namespace suffuse::cpu {

const TileLayers *LayerCache::find(std::size_t tile) const
{
    const auto it = m_tiles.find(tile);
    return it == m_tiles.end() ? nullptr : &it->second;
}

void LayerCache::dropOver()
{
    for (auto &[tile, layers] : m_tiles)
        layers.over.clear();
}

void LayerCache::keep(const std::vector<std::size_t> &usedNow)
{
    ++m_clock;
    for (std::size_t tile : usedNow)
        if (const auto it = m_tiles.find(tile); it != m_tiles.end())
            it->second.used = m_clock;
    const auto bytesOf = [](const TileLayers &t) {
        return t.under.size() * sizeof(Backdrop) + t.over.size() * sizeof(OverMap);
    };
    std::size_t bytes = 0;
    for (const auto &[tile, layers] : m_tiles)
        bytes += bytesOf(layers);
    if (bytes <= m_capacity)
        return;
    std::vector<std::pair<std::uint64_t, std::size_t>> byAge;
    for (const auto &[tile, layers] : m_tiles)
        byAge.emplace_back(layers.used, tile);
    std::sort(byAge.begin(), byAge.end());
    for (const auto &[used, tile] : byAge) {
        if (bytes <= m_capacity)
            break;
        bytes -= bytesOf(m_tiles[tile]);
        m_tiles.erase(tile);
    }
}

} // namespace suffuse::cpu
