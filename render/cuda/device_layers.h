// Layers of tiles in a device's memory (docs/solver.md, "Layers"): for tiles that are drawn while a stroke is edited.
#pragma once

#include "render/cuda/device_memory.h"

#include <cstdint>
#include <vector>

namespace suffuse::cuda {

/// Where a tile's layers lie, and which of them hold.
struct TileLayer {
    static constexpr std::uint32_t none = UINT32_MAX;

    std::uint32_t slot = none;
    bool under = false;
    bool over = false;
    std::uint32_t used = 0; ///< frame that last drew with them
};

class DeviceLayers {
public:
    explicit DeviceLayers(Device &device) : m_device(device), m_under(device), m_over(device) {}

    /// A frame of a picture of so many tiles begins: makes room for their layers, at most 512 MiB or a quarter of what
    /// the device has free. Where that cannot be had there are no layers.
    Fault beginFrame(std::size_t tiles);
    /// Nothing holds any more.
    void clear();
    void dropOver();
    /// Gives the memory back; there are no layers until `allow`.
    void refuse();
    void allow() { m_refused = false; }
    bool hasMemory() const { return m_room > 0; }

    /// A tile's layers, made where it has none; null where there is no room. `tile`: below what the frame began with.
    TileLayer *at(std::size_t tile)
    {
        TileLayer &layer = m_tiles[tile];
        if (layer.slot == TileLayer::none && !place(layer))
            return nullptr;
        layer.used = m_frame;
        return &layer;
    }
    BackdropPixel *under() const { return m_under.data(); }
    float *over() const { return m_over.data(); }

private:
    /// Finds a slot for it; false: there is no room.
    bool place(TileLayer &layer);
    /// Takes slots back that neither this frame nor the last one used.
    void dropUnused();

    Device &m_device;
    DeviceArray<BackdropPixel> m_under;
    DeviceArray<float> m_over;
    std::vector<TileLayer> m_tiles; ///< of the picture, whether they have layers or not
    std::vector<std::uint32_t> m_free;
    std::size_t m_room = 0;    ///< slots in the device's memory
    std::size_t m_wanted = 0;  ///< tiles that it was made for
    std::uint32_t m_slots = 0; ///< of them handed out so far
    std::uint32_t m_frame = 0, m_swept = 0;
    bool m_refused = false;
};

} // namespace suffuse::cuda
