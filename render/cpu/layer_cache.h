// Keeps for each tile what lies below and above the strokes that are being edited, so that a frame costs only those
// strokes.
#pragma once

#include "render/composition/composition.h"
#include "render/cpu/kernels.h"
#include "render/cpu/layer_bounds.h"
#include "render/cpu/over_steps.h"
#include "render/cpu/prefix_sums.h"

#include <cstddef>
#include <list>
#include <unordered_map>
#include <vector>

namespace suffuse::cpu {

/// The layers that have begun in a block and not ended.
struct OpenLayers {
    LayerPlace place;
    std::vector<Backdrop> below;     ///< what lies below each of them, from the outermost on
    std::vector<LayerBounds> bounds; ///< of the canvas and of each of them; none if nothing is clipped or masked
};

/// The layers of one tile, by block.
struct TileLayers {
    std::vector<Backdrop> under;      ///< the picture before the first edited stroke: a prefix of the order, exact
    std::vector<OpenLayers> open;     ///< those around that stroke; empty if the painting has none
    std::size_t below = 0;            ///< how many of the scene's strokes are in it
    std::vector<OverSteps> over;      ///< all that lies above what is edited
    std::vector<std::uint8_t> met;    ///< whether the edited stroke is in what each block shows; empty if not known
    std::list<StrokePrefix> prefixes; ///< for strokes that grow: what of them has dried, exact
    std::uint64_t used = 0;

    /// The prefix of a stroke, which is empty if it is new.
    StrokePrefix &prefixOf(std::uint32_t stroke);
};

/// The layers of tiles, bounded in memory: what was not used for the longest time is dropped first. One thread prepares
/// them; then several threads may fill different tiles.
class LayerCache {
public:
    explicit LayerCache(std::size_t bytes) : m_capacity(bytes) {}

    /// The layers of a tile, which are empty if they are new.
    TileLayers &at(std::size_t tile) { return m_tiles[tile]; }
    void clear() { m_tiles.clear(); }
    void dropOver();
    void dropPrefixes();
    /// Drops the sums of the scene's first `below` strokes.
    void dropPrefixes(std::size_t below);
    /// Drops sums over more nodes than stay. `changed` are the strokes that differ from the frame before, in ascending
    /// order.
    void dropPrefixes(const std::vector<SteadyStroke> &changed);
    /// Marks tiles as used now, and drops the others, the oldest first, down to the capacity.
    void keep(const std::vector<std::size_t> &usedNow);

private:
    std::size_t m_capacity;
    std::uint64_t m_clock = 0;
    std::unordered_map<std::size_t, TileLayers> m_tiles;
};

} // namespace suffuse::cpu
