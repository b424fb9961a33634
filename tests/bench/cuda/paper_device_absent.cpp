// In builds without a CUDA compiler.
#include "tests/bench/cuda/paper_device.h"

namespace suffuse::baseline {

std::unique_ptr<PaperOnDevice> paperOnDevice(const PaperScene &, std::string &why)
{
    why = "built without a CUDA compiler";
    return nullptr;
}

} // namespace suffuse::baseline
