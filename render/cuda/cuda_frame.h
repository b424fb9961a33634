// The picture that a CUDA device keeps for the canvas.
#pragma once

#include "render/cuda/device.h"
#include "render/device_frame.h"

#include <cstdint>
#include <memory>
#include <string>

namespace suffuse {

/// Holds its device. `link` and `copyTo` may be called while another thread renders; all else is for the thread that
/// uses the device.
class CudaFrame : public DeviceFrame {
public:
    /// Where to render: device memory, 0xAARRGGBB, `width` pixels a row.
    virtual std::uint32_t *picture() = 0;
};

/// Two cleared pictures in the device's memory; null, and why, where it has no room for them.
std::shared_ptr<CudaFrame> makeCudaFrame(std::shared_ptr<cuda::Device> device, int width, int height, std::string &why);

} // namespace suffuse
