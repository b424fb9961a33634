#include "render/cuda/device_composition.h"

#include <algorithm>

namespace suffuse::cuda {

Fault DeviceComposition::update(const Composition &composition, const DeviceScene &scene, const float *canvas)
{
    m_isFlat = composition.isFlat();
    m_isBounded = composition.isBounded;
    if (m_isFlat)
        return {};
    m_depth = 0;
    m_layers.resize(composition.layers.size());
    m_layers.touch(m_layers.set(0, composition.layers.size(), [&](std::size_t i) {
        const Layer &layer = composition.layers[i];
        m_depth = std::max(m_depth, std::uint32_t(layer.depth));
        const bool onCanvas = canvas && layer.parent == Layer::none;
        LayerRecord record;
        record.mode = std::int32_t(layer.blend), record.opacity = layer.opacity, record.opaque = onCanvas;
        for (int c = 0; c < 3; ++c)
            record.bare[c] = onCanvas ? canvas[c] : 1;
        record.parent = layer.parent, record.depth = layer.depth;
        record.clippedTo = layer.clippedTo, record.shape = layer.shape;
        record.shapeMode = std::int32_t(layer.shapeMode);
        record.masks = layer.masks, record.isMask = layer.isMask;
        return record;
    }));
    m_of.resize(scene.slotCount());
    for (std::size_t i = 0; i < composition.of.size(); ++i)
        m_of.touch(m_of.set(scene.slotOf(i), 1, [&](std::size_t) { return std::int32_t(composition.of[i]); }));
    m_hasBases = !composition.bases.empty();
    if (m_hasBases) {
        m_shapes.resize(scene.slotCount());
        for (std::size_t i = 0; i < composition.shapes.size(); ++i)
            m_shapes.touch(
                m_shapes.set(scene.slotOf(i), 1, [&](std::size_t) { return std::int32_t(composition.shapes[i]); }));
    }
    m_everywhere.resize(composition.everywhere.size());
    m_everywhere.touch(m_everywhere.set(0, composition.everywhere.size(), [&](std::size_t i) {
        const int layer = composition.everywhere[i];
        return EverywhereRecord{layer, scene.firstChunk(composition.layers[std::size_t(layer)].first)};
    }));
    for (const Fault &fault : {m_layers.upload(), m_of.upload(), m_shapes.upload(), m_everywhere.upload()})
        if (fault)
            return fault;
    return {};
}

void DeviceComposition::fill(Frame &frame) const
{
    frame.layers = m_isFlat ? nullptr : m_layers.device();
    frame.layerOf = m_of.device();
    frame.shapeOf = m_isFlat || !m_hasBases ? nullptr : m_shapes.device();
    frame.everywhere = m_everywhere.device();
    frame.everywhereCount = m_isFlat ? 0 : std::uint32_t(m_everywhere.host().size());
    frame.layerPlanes = m_isFlat ? 0 : m_depth + 1;
}

} // namespace suffuse::cuda
