// Draws the layers of a layered file, such that plain programs that put them on each other get the picture.
#pragma once

#include "render/layered/layer_plan.h"
#include "render/renderer.h"

#include <functional>

namespace suffuse {

/// Pixels in whole levels of 8 or 16 bits, in rows without gaps. They belong to whoever made them.
struct LevelPixels {
    PixelRect rect;             ///< where they lie in the picture; empty if there are none
    int bits = 8;               ///< of a channel: 8 or 16
    int channels = 4;           ///< 4: straight RGBA; 3: RGB
    const void *row0 = nullptr; ///< the first row: std::uint8_t or std::uint16_t
    std::size_t stride = 0;     ///< values from one row to the next

    /// A value between 0 and 1.
    float at(int x, int y, int channel) const
    {
        const std::size_t i = std::size_t(y) * stride + std::size_t(x) * std::size_t(channels) + std::size_t(channel);
        return bits == 8 ? float(static_cast<const std::uint8_t *>(row0)[i]) / 255
                         : float(static_cast<const std::uint16_t *>(row0)[i]) / 65535;
    }
};

/// Takes the layers from bottom to top, and then the picture.
class LayerSink {
public:
    virtual ~LayerSink() = default;
    virtual Result<void> beginFolder(const PlannedLayer &folder) = 0;
    virtual Result<void> endFolder() = 0;
    /// `layer` says how it is put; its mode may be Normal where the plan has another one.
    virtual Result<void> layer(const PlannedLayer &layer, const LevelPixels &pixels) = 0;
    virtual Result<void> picture(const LevelPixels &pixels) = 0;
};

struct LayeredRequest {
    PaintingPtr painting;
    Microseconds time = 0;
    View view;
    int bits = 8; ///< of a channel: 8 or 16
    /// Whether opacities of layers become whole 255ths. What that changes of the picture is mended in the pixels.
    bool wholeOpacities = false;
    const std::atomic<bool> *cancel = nullptr;
    std::function<void(std::size_t done, std::size_t layers)> progress; ///< called after each layer
};

struct LayeredStats {
    std::size_t layers = 0;
    std::size_t baked = 0; ///< groups that are no layers of their own mode, since others would show them otherwise
    /// How far the layers, put on each other in whole levels, are from the picture: the greatest difference of a
    /// channel, as a share of 1.
    double greatestDifference = 0;
};

/// Draws all layers. `renderer` draws each stroke but once, since each picture has the one before in it, and `groups`
/// draws those that are layers of their own. The layer of strokes between a picture B0 and a picture B1 has, at each
/// pixel, the least opacity a at which C = (B1 − (1 − a)·B0)/a is a colour; so source-over makes B1 of B0 whatever the
/// strokes do. B0 is what the layers below make in whole levels: their errors do not add up.
Result<LayeredStats> drawLayers(const LayeredRequest &request, Renderer &renderer, Renderer &groups, LayerSink &sink);

} // namespace suffuse
