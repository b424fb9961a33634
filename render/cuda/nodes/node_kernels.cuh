// Through this header device.cu launches the kernels that build nodes.
#pragma once

#include "render/cuda/nodes/node_records.h"

#include <cuda_runtime.h>

namespace suffuse::cuda {

/// Finds how many blocks merge windows at the same time on a device, at most mergeWorkers.
cudaError_t fillingMergers(int device, unsigned &blocks);
/// Launches a warp for each job, then `mergers` blocks that merge windows.
cudaError_t launchNodes(const NodeWork &work, unsigned mergers, cudaStream_t stream);

} // namespace suffuse::cuda
