// In place of the CUDA device where the program was built without nvcc.
#include "render/cuda/device.h"

namespace suffuse::cuda {

int deviceCount(std::string &why)
{
    why = "this program was built without CUDA";
    return 0;
}

std::unique_ptr<Device> openDevice(int, std::string &why)
{
    deviceCount(why);
    return nullptr;
}

} // namespace suffuse::cuda
