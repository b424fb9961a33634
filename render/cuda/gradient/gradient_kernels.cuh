// Through this header device.cu launches the kernels that find the gradient of a picture.
#pragma once

#include "render/cuda/gradient/gradient_records.h"

#include <cuda_runtime.h>

namespace suffuse::cuda {

/// Finds how many warps draw tiles at the same time on a device.
cudaError_t fillingGradient(int device, std::uint32_t &warps);
/// Launches a warp for each stroke, GradientWork::warps of them for the tiles, and a warp for each segment.
cudaError_t launchGradient(const GradientWork &work, cudaStream_t stream);

} // namespace suffuse::cuda
