// This keeps the layers of a painting in a device's memory.
#pragma once

#include "render/composition/composition.h"
#include "render/cuda/device_scene.h"

namespace suffuse::cuda {

class DeviceComposition {
public:
    explicit DeviceComposition(Device &device) : m_layers(device), m_of(device), m_shapes(device), m_everywhere(device)
    {}

    /// Brings the device up to date with the layers of a scene's strokes, which the device has. `canvas`: RGB of the
    /// canvas; null where the picture is transparent.
    Fault update(const Composition &composition, const DeviceScene &scene, const float *canvas);
    void fill(Frame &frame) const;
    /// Whether a layer is clipped, or is a mask.
    bool isBounded() const { return m_isBounded; }

private:
    Mirror<LayerRecord> m_layers;
    Mirror<std::int32_t> m_of;     ///< by the slots of strokes
    Mirror<std::int32_t> m_shapes; ///< so are these
    Mirror<EverywhereRecord> m_everywhere;
    std::uint32_t m_depth = 0; ///< of the deepest layer
    bool m_isFlat = true;
    bool m_hasBases = false, m_isBounded = false;
};

} // namespace suffuse::cuda
