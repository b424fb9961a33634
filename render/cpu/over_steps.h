// What lies above the edited strokes of a block, in steps that cost no strokes.
#pragma once

#include "render/composition/composition.h"
#include "render/cpu/kernels.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace suffuse::cpu {

/// Strokes that follow each other in one layer are a map. Layers that begin above the edited strokes are kept as
/// pictures, so that they can be put with another opacity or in another mode; those around the edited strokes end in
/// between. What their bounds let through is kept with them, since it does not depend on what is edited.
struct OverSteps {
    enum class Kind : std::uint8_t {
        Map,     ///< strokes, as one map of the backdrop: exact in arithmetic, but not in its last bits
        Picture, ///< a layer, which is put on the backdrop: rounded to 16 bits
        End      ///< the innermost layer that is open ends, and is put on what lies below it
    };
    struct Step {
        Kind kind = Kind::Map;
        int layer = Layer::none; ///< the one that is put
        std::size_t place = 0;   ///< among the maps, the pictures or the shares
        bool isBounded = false;  ///< whether the end of a layer has a share
    };
    /// What the bounds of a layer let through.
    struct Share {
        alignas(64) float values[blockSize];
    };
    std::vector<Step> steps;
    std::vector<OverMap> maps;
    std::vector<LayerPicture> pictures;
    std::vector<Share> shares;

    void clear() { steps.clear(), maps.clear(), pictures.clear(), shares.clear(); }
    /// The map of the strokes that come next.
    OverMap &map()
    {
        if (steps.empty() || steps.back().kind != Kind::Map) {
            steps.push_back({Kind::Map, Layer::none, maps.size()});
            maps.emplace_back().clear();
        }
        return maps.back();
    }
    /// The layer, which shows this. `share`: what its bounds let through of it; null: all. With `always` it is kept
    /// even if that is nothing.
    void addPicture(const Kernels &kernels, int layer, const Backdrop &shown, const float *share, bool always)
    {
        if (!kernels.keep(shown, pictures.emplace_back()) && !always)
            return pictures.pop_back();
        steps.push_back({Kind::Picture, layer, pictures.size() - 1});
        for (int at = 0; share && at < blockSize; ++at) {
            std::uint16_t &coverage = *pictures.back().at(3, at);
            coverage = std::uint16_t(float(coverage) * share[at] + 0.5f);
        }
    }
    void addEnd(int layer, const float *share)
    {
        steps.push_back({Kind::End, layer, shares.size(), share != nullptr});
        if (share)
            std::copy_n(share, blockSize, shares.emplace_back().values);
    }
    /// Whether a layer is put by one of the steps.
    bool put(int layer) const { return std::ranges::find(steps, layer, &Step::layer) != steps.end(); }
    std::size_t bytes() const
    {
        return maps.size() * sizeof(OverMap) + pictures.size() * sizeof(LayerPicture) + shares.size() * sizeof(Share);
    }
};

} // namespace suffuse::cpu
