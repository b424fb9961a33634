#include "render/cuda/gradient/gradient_kernels.cuh"

#include "render/cuda/gradient/gradient_place.h"
#include "render/cuda/gradient/gradient_sum.h"
#include "render/cuda/gradient/gradient_tile.h"

namespace suffuse::cuda {

namespace {

/// So many warps draw tiles at once on a multiprocessor.
constexpr int plainWarps = 16, varyingWarps = 8;

// A block is one warp, which takes one stroke.
__global__ void __launch_bounds__(warpLanes) gradientPlaceKernel(const __grid_constant__ GradientWork work)
{
    DeviceWarp warp;
    GradientPlacer<DeviceWarp>(warp, work, blockIdx.x).run();
}

// A block is one warp, which takes one tile after the other.
template <bool varies>
__global__ void __launch_bounds__(warpLanes, varies ? varyingWarps : plainWarps)
    gradientTileKernel(const __grid_constant__ GradientWork work)
{
    __shared__ GradientScratch<varies> scratch;
    DeviceWarp warp;
    const auto tiles = std::uint32_t(work.columns) * std::uint32_t(work.rows);
    for (std::uint32_t tile; (tile = warp.take(work.status + nextGradientTile)) < tiles;)
        GradientTile<DeviceWarp, varies>(warp, work, scratch, tile, blockIdx.x).run();
}

// A block is one warp, which takes one segment.
__global__ void __launch_bounds__(warpLanes) gradientSumKernel(const __grid_constant__ GradientWork work)
{
    DeviceWarp warp;
    GradientSummer<DeviceWarp>(warp, work, blockIdx.x).run();
}

} // namespace

cudaError_t fillingGradient(int device, std::uint32_t &warps)
{
    int processors = 0, together = 0;
    cudaError_t error = cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&together, gradientTileKernel<false>, warpLanes, 0);
    const int all = processors * together;
    warps = std::uint32_t(all < 1 ? 1 : all);
    return error;
}

cudaError_t launchGradient(const GradientWork &work, cudaStream_t stream)
{
    if (work.strokeCount > 0)
        gradientPlaceKernel<<<dim3(work.strokeCount), warpLanes, 0, stream>>>(work);
    if (work.varies)
        gradientTileKernel<true><<<dim3(work.warps), warpLanes, 0, stream>>>(work);
    else
        gradientTileKernel<false><<<dim3(work.warps), warpLanes, 0, stream>>>(work);
    if (work.segmentCount > 0 && (work.target || work.byRgb))
        gradientSumKernel<<<dim3(work.segmentCount), warpLanes, 0, stream>>>(work);
    return cudaGetLastError();
}

} // namespace suffuse::cuda
