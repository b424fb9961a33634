// The pictures that strokes are painted with, in a device's memory.
#pragma once

#include "render/cuda/device/device_memory.h"
#include "render/scene/live_scene.h"

#include <list>

namespace suffuse::cuda {

class DevicePictures {
public:
    explicit DevicePictures(Device &device) : m_device(device) {}

    /// Uploads the pictures of these strokes that are not there yet, and lets go of all others.
    Fault keep(const std::vector<SceneStrokePtr> &strokes);
    /// Returns how a picture, which is there, lies in the view, for the device.
    PictureView viewOf(const ScenePicture &picture) const;
    bool isEmpty() const { return m_kept.empty(); }

private:
    struct Kept {
        Kept(PictureLevelsPtr levels, Device &device) : levels(std::move(levels)), values(device) {}

        PictureLevelsPtr levels;
        DeviceArray<std::uint16_t> values;
        bool isUsed = true;
    };

    Device &m_device;
    std::list<Kept> m_kept;
};

} // namespace suffuse::cuda
