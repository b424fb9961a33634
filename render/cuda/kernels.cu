#include "render/cuda/kernels.cuh"

#include "render/cuda/tile_lists.h"
#include "render/cuda/tile_program.h"

namespace suffuse::cuda {

namespace {

/// The next of the jobs that all blocks share.
__device__ std::uint32_t next(const Frame &frame, StatusWord counter)
{
    std::uint32_t job = 0;
    if (threadIdx.x == 0)
        job = atomicAdd(frame.status + counter, 1u);
    return __shfl_sync(0xffffffffu, job, 0);
}

// Runs once per macro job, by one warp.
__global__ void __launch_bounds__(warpLanes) listsKernel(const __grid_constant__ Frame frame)
{
    DeviceWarp warp;
    for (std::uint32_t job = next(frame, nextMacro); job < frame.macroCount; job = next(frame, nextMacro))
        makeList(warp, frame, job);
}

// Runs once per entry of the macro jobs' lists, by one warp.
__global__ void __launch_bounds__(warpLanes) cullKernel(const __grid_constant__ Frame frame)
{
    __shared__ Fetched fetched;
    DeviceWarp warp;
    const std::uint32_t longest = frame.status[longestList], room = longest < frame.listRoom ? longest : frame.listRoom;
    const std::uint32_t jobs = room * frame.macroCount;
    for (std::uint32_t job = next(frame, nextEntry); job < jobs; job = next(frame, nextEntry))
        cullEntry(warp, frame, job % frame.macroCount, job / frame.macroCount, fetched);
}

// Runs once per tile job, by one warp.
template <bool general>
__global__ void __launch_bounds__(warpLanes, general ? 5 : 14) tilesKernel(const __grid_constant__ Frame frame)
{
    __shared__ TileScratch<general> scratch;
    DeviceWarp warp;
    constexpr StatusWord counter = general ? nextGeneralTile : nextPlainTile;
    for (std::uint32_t job = next(frame, counter); job < frame.tileCount; job = next(frame, counter))
        if (((frame.tiles[job].flags & plainTile) == 0) == general)
            paintTile<general>(warp, frame, job, scratch);
}

// Runs once per rectangle, by one block.
__global__ void copyKernel(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects)
{
    const int4 r = rects[blockIdx.x];
    for (int i = int(threadIdx.x); i < r.z * r.w; i += int(blockDim.x)) {
        const std::size_t at = std::size_t(r.y + i / r.z) * std::size_t(rowPixels) + std::size_t(r.x + i % r.z);
        to[at] = from[at];
    }
}

} // namespace

cudaError_t fillingGrid(int device, Grid &grid)
{
    int processors = 0, lists = 0, culls = 0, plain = 0, general = 0;
    cudaError_t error = cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&lists, listsKernel, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&culls, cullKernel, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&plain, tilesKernel<false>, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&general, tilesKernel<true>, warpLanes, 0);
    grid = {unsigned(processors * lists), unsigned(processors * culls), unsigned(processors * plain),
            unsigned(processors * general)};
    return error;
}

cudaError_t launchLists(const Frame &frame, const Grid &grid, cudaStream_t stream)
{
    listsKernel<<<grid.lists, warpLanes, 0, stream>>>(frame);
    cullKernel<<<grid.culls, warpLanes, 0, stream>>>(frame);
    return cudaGetLastError();
}

cudaError_t launchTiles(const Frame &frame, bool general, const Grid &grid, cudaStream_t stream)
{
    if (general)
        tilesKernel<true><<<grid.general, warpLanes, 0, stream>>>(frame);
    else
        tilesKernel<false><<<grid.plain, warpLanes, 0, stream>>>(frame);
    return cudaGetLastError();
}

cudaError_t launchCopy(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects, int count,
                       cudaStream_t stream)
{
    constexpr int threads = 256;
    copyKernel<<<unsigned(count), threads, 0, stream>>>(to, from, rowPixels, rects);
    return cudaGetLastError();
}

} // namespace suffuse::cuda
