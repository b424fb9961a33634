// What lies above the edited strokes of a block, in steps that cost no strokes.
#pragma once

#include "render/composition/composition.h"
#include "render/cpu/kernels.h"

#include <cstdint>
#include <vector>

namespace suffuse::cpu {

/// Strokes that follow each other in one layer are a map. Layers that begin above the edited strokes are kept as
/// pictures, so that they can be put with another opacity or in another mode; those around the edited strokes end in
/// between.
struct OverSteps {
    enum class Kind : std::uint8_t {
        Map,     ///< strokes, as one map of the backdrop: exact in arithmetic, but not in its last bits
        Picture, ///< a layer, which is put on the backdrop: rounded to 16 bits
        End      ///< the innermost layer that is open ends, and is put on what lies below it
    };
    struct Step {
        Kind kind = Kind::Map;
        int layer = Layer::none; ///< the one that is put
        std::size_t place = 0;   ///< among the maps or the pictures
    };
    std::vector<Step> steps;
    std::vector<OverMap> maps;
    std::vector<LayerPicture> pictures;

    void clear() { steps.clear(), maps.clear(), pictures.clear(); }
    /// The map of the strokes that come next.
    OverMap &map()
    {
        if (steps.empty() || steps.back().kind != Kind::Map) {
            steps.push_back({Kind::Map, Layer::none, maps.size()});
            maps.emplace_back().clear();
        }
        return maps.back();
    }
    /// The layer, which shows this. With `always` it is kept even if that is nothing.
    void addPicture(const Kernels &kernels, int layer, const Backdrop &shown, bool always)
    {
        if (!kernels.keep(shown, pictures.emplace_back()) && !always)
            return pictures.pop_back();
        steps.push_back({Kind::Picture, layer, pictures.size() - 1});
    }
    void addEnd(int layer) { steps.push_back({Kind::End, layer, 0}); }
    std::size_t bytes() const { return maps.size() * sizeof(OverMap) + pictures.size() * sizeof(LayerPicture); }
};

} // namespace suffuse::cpu
