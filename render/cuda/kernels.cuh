// The kernels, for device.cu.
#pragma once

#include "render/cuda/records.h"

#include <cuda_runtime.h>

namespace suffuse::cuda {

/// Blocks that fill a device, of each kernel, and how they are launched.
struct Grid {
    unsigned lists = 1, plain = 1, general = 1;
    bool early = false; ///< whether kernels wait themselves for the ones before them
};
cudaError_t fillingGrid(int device, Grid &grid);

/// How many blocks one of the kernels of a frame is launched with.
unsigned blocksOf(const void *kernel, const Frame &frame, const Grid &grid);

/// Runs once per list: its chunks and where they can be seen; puts the tile jobs in order, if `ordered`.
cudaError_t launchLists(const Frame &frame, const Grid &grid, cudaStream_t stream);
/// Runs once per tile job, of those that are plain or of the others.
cudaError_t launchTiles(const Frame &frame, bool general, const Grid &grid, cudaStream_t stream);
/// For each rectangle {x, y, width, height}: copies it from one picture to another of the same size.
cudaError_t launchCopy(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects, int count,
                       cudaStream_t stream);

} // namespace suffuse::cuda
