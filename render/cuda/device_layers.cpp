#include "render/cuda/device_layers.h"

namespace suffuse::cuda {

namespace {

constexpr std::size_t overFloats = overPlanes * tileSize;
constexpr std::size_t slotBytes = tileSize * sizeof(BackdropPixel) + overFloats * sizeof(float);
constexpr std::size_t mostBytes = std::size_t(512) << 20;

} // namespace

void DeviceLayers::clear()
{
    std::fill(m_tiles.begin(), m_tiles.end(), TileLayer{});
    m_free.clear();
    m_slots = 0;
}

void DeviceLayers::dropOver()
{
    for (TileLayer &layer : m_tiles)
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
    if (m_tiles.size() < tiles)
        m_tiles.resize(tiles);
    if (m_refused || tiles <= m_wanted)
        return {};
    clear();
    m_under.release();
    m_over.release();
    m_room = 0;
    m_wanted = tiles;
    const std::size_t places = std::min(tiles, std::min(mostBytes, m_device.freeMemory() / 4) / slotBytes);
    Fault fault = m_under.reserve(places * tileSize);
    if (!fault)
        fault = m_over.reserve(places * overFloats);
    if (fault)
        refuse();
    else
        m_room = places;
    return fault.kind == Fault::Lost ? fault : Fault{};
}

void DeviceLayers::dropUnused()
{
    if (m_swept == m_frame)
        return;
    m_swept = m_frame;
    for (TileLayer &layer : m_tiles)
        if (layer.slot != TileLayer::none && layer.used + 1 < m_frame) {
            m_free.push_back(layer.slot);
            layer = {};
        }
}

bool DeviceLayers::place(TileLayer &layer)
{
    if (m_free.empty() && m_slots >= m_room)
        dropUnused();
    if (m_free.empty() && m_slots >= m_room)
        return false;
    if (m_free.empty()) {
        layer.slot = m_slots++;
    } else {
        layer.slot = m_free.back();
        m_free.pop_back();
    }
    return true;
}

} // namespace suffuse::cuda
