// Through this header device.cu launches the kernels.
#pragma once

#include "render/cuda/tiles/records.h"

#include <cuda_runtime.h>

namespace suffuse::cuda {

/// Says how many blocks of each kernel fill a device, and how kernels are launched.
struct Grid {
    unsigned lists = 1, plain = 1, general = 1;
    bool early = false; ///< whether kernels are begun early, and wait themselves for those before them
};
cudaError_t fillingGrid(int device, Grid &grid);

/// Returns how many blocks a kernel of a frame is launched with.
unsigned blocksOf(const void *kernel, const Frame &frame, const Grid &grid);

/// Launches a run for each list, which finds its chunks and where they can be seen, and puts the tile jobs in order if
/// `ordered`.
cudaError_t launchLists(const Frame &frame, const Grid &grid, cudaStream_t stream);
/// Launches a run for each tile job, either of those that are plain or of the others.
cudaError_t launchTiles(const Frame &frame, bool general, const Grid &grid, cudaStream_t stream);
/// Launches a copy of each rectangle {x, y, width, height} from one picture to another of the same size.
cudaError_t launchCopy(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects, int count,
                       cudaStream_t stream);

} // namespace suffuse::cuda
