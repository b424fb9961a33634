// This stands in for the CUDA device where the program was built without nvcc.
#include "render/cuda/device/device.h"

namespace suffuse::cuda {

Devices findDevices()
{
    return {};
}

std::unique_ptr<Device> openDevice(int, std::string &why)
{
    why = "built without CUDA";
    return nullptr;
}

} // namespace suffuse::cuda
