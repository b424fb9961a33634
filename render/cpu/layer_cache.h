// What lies below and above the strokes that are being edited, per tile, so that a frame costs those strokes only.
#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/prefix_sums.h"

#include <cstddef>
#include <list>
#include <unordered_map>
#include <vector>

namespace suffuse::cpu {

/// Layers of one tile, by block.
struct TileLayers {
    std::vector<Backdrop> under; ///< the picture before the first edited stroke: a prefix of the order, exact
    std::size_t below = 0;       ///< so many of the scene's strokes are in it
    std::vector<OverMap> over;   ///< all strokes above it as one affine map: exact in arithmetic, not in its last bits
    std::list<StrokePrefix> prefixes; ///< of strokes that grow: what of them has dried, exact
    std::uint64_t used = 0;

    /// The stroke's prefix, empty if it is new.
    StrokePrefix &prefixOf(std::uint32_t stroke);
};

/// Layers by tile, bounded in memory: what was not used for longest goes first. Prepared by one thread; then several
/// threads may fill different tiles.
class LayerCache {
public:
    explicit LayerCache(std::size_t bytes) : m_capacity(bytes) {}

    /// The tile's layers, empty if they are new.
    TileLayers &at(std::size_t tile) { return m_tiles[tile]; }
    void clear() { m_tiles.clear(); }
    void dropOver();
    void dropPrefixes();
    /// Drops sums of the scene's first `below` strokes.
    void dropPrefixes(std::size_t below);
    /// Drops sums over more nodes than stay. `changed`: the strokes that differ from the frame before, ascending.
    void dropPrefixes(const std::vector<SteadyStroke> &changed);
    /// Marks tiles as used now and drops the rest, oldest first, down to the capacity.
    void keep(const std::vector<std::size_t> &usedNow);

private:
    std::size_t m_capacity;
    std::uint64_t m_clock = 0;
    std::unordered_map<std::size_t, TileLayers> m_tiles;
};

} // namespace suffuse::cpu
