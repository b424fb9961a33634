#include "render/cuda/device_layers.h"

namespace suffuse::cuda {

namespace {

constexpr std::size_t overFloats = overPlanes * tileSize;
constexpr std::size_t slotBytes = tileSize * sizeof(BackdropPixel) + overFloats * sizeof(float);
constexpr std::size_t mostBytes = std::size_t(512) << 20;

} // namespace

void DeviceLayers::clear()
{
    m_tiles.clear();
    m_free.clear();
    m_slots = 0;
}

void DeviceLayers::dropOver()
{
    for (auto &[tile, layer] : m_tiles)
        layer.over = false;
}

void DeviceLayers::refuse()
{
    clear();
    m_under.release();
    m_over.release();
    m_room = m_wanted = 0;
    m_refused = true;
}

Fault DeviceLayers::beginFrame(std::size_t tiles)
{
    ++m_frame;
    if (m_refused || tiles <= m_wanted)
        return {};
    clear();
    m_under.release();
    m_over.release();
    m_room = 0;
    m_wanted = tiles;
    const std::size_t slots = std::min(tiles, std::min(mostBytes, m_device.freeMemory() / 4) / slotBytes);
    Fault fault = m_under.reserve(slots * tileSize);
    if (!fault)
        fault = m_over.reserve(slots * overFloats);
    if (fault)
        refuse();
    else
        m_room = slots;
    return fault.kind == Fault::Lost ? fault : Fault{};
}

void DeviceLayers::dropUnused()
{
    if (m_swept == m_frame)
        return;
    m_swept = m_frame;
    for (auto it = m_tiles.begin(); it != m_tiles.end();) {
        const bool unused = it->second.used + 1 < m_frame;
        if (unused)
            m_free.push_back(it->second.slot);
        it = unused ? m_tiles.erase(it) : std::next(it);
    }
}

TileLayer *DeviceLayers::at(std::size_t tile)
{
    auto it = m_tiles.find(tile);
    if (it == m_tiles.end()) {
        if (m_free.empty() && m_slots >= m_room)
            dropUnused();
        if (m_free.empty() && m_slots >= m_room)
            return nullptr;
        it = m_tiles.emplace(tile, TileLayer{}).first;
        if (m_free.empty()) {
            it->second.slot = m_slots++;
        } else {
            it->second.slot = m_free.back();
            m_free.pop_back();
        }
    }
    it->second.used = m_frame;
    return &it->second;
}

} // namespace suffuse::cuda
