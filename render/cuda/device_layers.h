// While a stroke is edited, the layers of tiles that are drawn are kept in a device's memory (docs/solver.md,
// "Layers").
#pragma once

#include "render/cuda/device/device_memory.h"

#include <cstdint>
#include <vector>

namespace suffuse::cuda {

/// Says where the layers of a tile lie, and which of them are valid.
struct TileLayer {
    static constexpr std::uint32_t none = UINT32_MAX;

    std::uint32_t slot = none;
    bool under = false;
    bool over = false;
    std::uint32_t used = 0; ///< the frame that last used them
};

class DeviceLayers {
public:
    explicit DeviceLayers(Device &device) : m_device(device), m_under(device), m_over(device) {}

    /// Begins a frame of a picture of so many tiles. Makes room for their layers: at most 512 MiB, or a quarter of what
    /// the device has free. If there is no room, there are no layers.
    Fault beginFrame(std::size_t tiles);
    /// Makes all layers invalid.
    void clear();
    void dropOver();
    /// Gives the memory back. There are no layers until `allow`.
    void refuse();
    void allow() { m_refused = false; }
    bool hasMemory() const { return m_room > 0; }

    /// Returns the layers of a tile, which are made if it has none, or null if there is no room. `tile` is below the
    /// number that the frame began with.
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
    /// Finds a slot for a layer. Returns false if there is no room.
    bool place(TileLayer &layer);
    /// Takes back slots that neither this frame nor the last one has used.
    void dropUnused();

    Device &m_device;
    DeviceArray<BackdropPixel> m_under;
    DeviceArray<float> m_over;
    std::vector<TileLayer> m_tiles; ///< for all tiles of the picture, with layers or without
    std::vector<std::uint32_t> m_free;
    std::size_t m_room = 0;    ///< slots in the device's memory
    std::size_t m_wanted = 0;  ///< the number of tiles for which the room was made
    std::uint32_t m_slots = 0; ///< the number of slots handed out so far
    std::uint32_t m_frame = 0, m_swept = 0;
    bool m_refused = false;
};

} // namespace suffuse::cuda
