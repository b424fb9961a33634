// A CUDA device keeps a picture for the canvas.
#pragma once

#include "render/cuda/device/device.h"
#include "render/device_frame.h"

#include <cstdint>
#include <memory>
#include <string>

namespace suffuse {

/// A frame keeps its device alive. `link` and `copyTo` may be called while another thread renders; all else belongs to
/// the thread that uses the device.
class CudaFrame : public DeviceFrame {
public:
    /// Returns where to render: device memory of 0xAARRGGBB, with `width` pixels in a row.
    virtual std::uint32_t *picture() = 0;
};

/// Makes two cleared pictures in the device's memory. Returns null, and says why, if it has no room for them.
std::shared_ptr<CudaFrame> makeCudaFrame(std::shared_ptr<cuda::Device> device, int width, int height, std::string &why);

} // namespace suffuse
