#include "render/cuda/kernels.cuh"

#include "render/cuda/tile_lists.h"
#include "render/cuda/tile_program.h"

namespace suffuse::cuda {

namespace {

/// What a kernel of a frame begins with: the next one may be made ready meanwhile, and the one before has to be done.
/// Older chips run kernels one after another anyway.
__device__ void takeTurn()
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
    cudaTriggerProgrammaticLaunchCompletion();
    cudaGridDependencySynchronize();
#endif
}

constexpr int weightClasses = 256;

/// Eight classes an octave, heavy ones first.
__device__ int classOf(std::uint32_t weight)
{
    const int log8 = int(__log2f(float(weight + 1)) * 8);
    return weightClasses - 1 - (log8 < weightClasses ? log8 : weightClasses - 1);
}

__device__ std::uint32_t weightOf(const Frame &frame, std::uint32_t job)
{
    const TileJob &tile = frame.tiles[job];
    const int at = tile.row % macroTiles * macroTiles + tile.column % macroTiles;
    return __ldcg(frame.weights + std::size_t(tile.macro) * macroTiles * macroTiles + at);
}

/// By one warp: from how many there are of each class to the place of the first of them.
__device__ void countsToPlaces(std::uint32_t (&places)[weightClasses])
{
    constexpr int classes = weightClasses / warpLanes; // a lane
    std::uint32_t count[classes], own = 0;
    SUFFUSE_UNROLL
    for (int i = 0; i < classes; ++i)
        own += count[i] = places[threadIdx.x * classes + i];
    std::uint32_t sum = own;
    SUFFUSE_UNROLL
    for (int by = 1; by < warpLanes; by *= 2) {
        const std::uint32_t lower = __shfl_up_sync(0xffffffffu, sum, by);
        sum += int(threadIdx.x) >= by ? lower : 0;
    }
    std::uint32_t before = sum - own;
    SUFFUSE_UNROLL
    for (int i = 0; i < classes; ++i) {
        places[threadIdx.x * classes + i] = before;
        before += count[i];
    }
}

/// By one block: puts heavy tiles first, so that no long one is begun last. Which of two of a class comes first may
/// differ from call to call; pixels do not depend on it.
__device__ void orderTiles(const Frame &frame, std::uint32_t (&places)[weightClasses])
{
    constexpr std::uint32_t threads = listWarps * warpLanes, most = 16, page = most * threads;
    std::uint32_t own[most], rank[most]; // several loads and atomics at a time
    const auto jobOf = [&](std::uint32_t from, std::uint32_t k) { return from + k * threads + threadIdx.x; };
    const auto count = [&](std::uint32_t from) {
        SUFFUSE_UNROLL
        for (std::uint32_t k = 0; k < most; ++k)
            own[k] = jobOf(from, k) < frame.tileCount ? weightOf(frame, jobOf(from, k)) : 0;
        SUFFUSE_UNROLL
        for (std::uint32_t k = 0; k < most; ++k) {
            own[k] = classOf(own[k]);
            rank[k] = jobOf(from, k) < frame.tileCount ? atomicAdd(places + own[k], 1u) : 0;
        }
    };
    for (std::uint32_t i = threadIdx.x; i < weightClasses; i += threads)
        places[i] = 0;
    __syncthreads();
    const std::uint32_t last = (frame.tileCount - 1) / page * page;
    for (std::uint32_t from = 0; from <= last; from += page) {
        count(from);
        __syncthreads();
    }
    if (threadIdx.x < warpLanes)
        countsToPlaces(places);
    __syncthreads();
    SUFFUSE_UNROLL
    for (std::uint32_t k = 0; k < most; ++k) // what was counted last comes last in its class
        if (jobOf(last, k) < frame.tileCount)
            frame.order[places[own[k]] + rank[k]] = jobOf(last, k);
    __syncthreads();
    SUFFUSE_ROLLED
    for (std::uint32_t from = 0; from < last; from += page) {
        count(from);
        SUFFUSE_UNROLL
        for (std::uint32_t k = 0; k < most; ++k)
            frame.order[rank[k]] = jobOf(from, k);
    }
}

// Runs once per list, by one block; the last block that is done puts the tiles in order.
__global__ void __launch_bounds__(listWarps *warpLanes, 3) listsKernel(const __grid_constant__ Frame frame)
{
    __shared__ union {
        ListScratch lists;
        std::uint32_t places[weightClasses];
    } scratch;
    __shared__ bool last;
    takeTurn();
    DeviceBlock block;
    for (std::uint32_t list = blockIdx.x; list < frame.macroCount * listParts; list += gridDim.x)
        ListMaker<DeviceBlock>(block, frame, list, scratch.lists).make();
    if (!frame.ordered)
        return;
    if (threadIdx.x == 0) {
        __threadfence();
        last = atomicAdd(frame.status + blocksDone, 1u) == gridDim.x - 1;
    }
    __syncthreads();
    if (last)
        orderTiles(frame, scratch.places);
}

/// The first job of a block is its own; of the rest each takes the next that nobody has.
template <StatusWord counter>
__device__ std::uint32_t nextJob(const Frame &frame)
{
    std::uint32_t job = 0;
    if (threadIdx.x == 0)
        job = gridDim.x + atomicAdd(frame.status + counter, 1u);
    return __shfl_sync(0xffffffffu, job, 0);
}

// Runs once per tile job, by one warp.
template <bool general>
__global__ void __launch_bounds__(warpLanes, general ? 5 : 12) tilesKernel(const __grid_constant__ Frame frame)
{
    __shared__ TileScratch<general> scratch;
    takeTurn();
    DeviceWarp warp;
    constexpr StatusWord counter = general ? nextGeneralTile : nextPlainTile;
    for (std::uint32_t i = blockIdx.x; i < frame.tileCount; i = nextJob<counter>(frame)) {
        const std::uint32_t job = frame.ordered ? frame.order[i] : i;
        if (((frame.tiles[job].flags & plainTile) == 0) == general)
            paintTile<general>(warp, frame, job, scratch);
    }
}

constexpr int copyThreads = 256, copySlices = 128;

// Runs once per rectangle, by as many blocks as it has slices of rows.
__global__ void __launch_bounds__(copyThreads)
    copyKernel(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects)
{
    const int4 r = rects[blockIdx.x];
    for (int y = int(blockIdx.y); y < r.w; y += int(gridDim.y))
        for (int x = int(threadIdx.x); x < r.z; x += copyThreads) {
            const std::size_t at = std::size_t(r.y + y) * std::size_t(rowPixels) + std::size_t(r.x + x);
            to[at] = from[at];
        }
}

} // namespace

cudaError_t fillingGrid(int device, Grid &grid)
{
    int processors = 0, lists = 0, plain = 0, general = 0;
    cudaError_t error = cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&lists, listsKernel, listWarps * warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&plain, tilesKernel<false>, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&general, tilesKernel<true>, warpLanes, 0);
    cudaFuncAttributes compiled = {};
    if (error == cudaSuccess)
        error = cudaFuncGetAttributes(&compiled, listsKernel);
    grid = {unsigned(processors * lists), unsigned(processors * plain), unsigned(processors * general),
            compiled.ptxVersion >= 90};
    return error;
}

unsigned blocksOf(const void *kernel, const Frame &frame, const Grid &grid)
{
    const auto least = [](unsigned a, std::size_t b) { return unsigned(b < a ? b : a); };
    if (kernel == reinterpret_cast<const void *>(listsKernel))
        return least(grid.lists, std::size_t(frame.macroCount) * listParts);
    const bool general = kernel == reinterpret_cast<const void *>(tilesKernel<true>);
    return least(general ? grid.general : grid.plain, frame.tileCount);
}

namespace {

/// Launches one of the kernels of a frame. `follows`: may be made ready while the one before runs.
cudaError_t launch(void (*kernel)(Frame), int threads, bool follows, const Frame &frame, const Grid &grid,
                   cudaStream_t stream)
{
    cudaLaunchAttribute early = {};
    early.id = cudaLaunchAttributeProgrammaticStreamSerialization;
    early.val.programmaticStreamSerializationAllowed = 1;
    cudaLaunchConfig_t config = {};
    config.gridDim = dim3(blocksOf(reinterpret_cast<const void *>(kernel), frame, grid));
    config.blockDim = dim3(unsigned(threads));
    config.stream = stream;
    config.attrs = &early;
    config.numAttrs = follows && grid.early ? 1 : 0;
    return cudaLaunchKernelEx(&config, kernel, frame);
}

} // namespace

cudaError_t launchLists(const Frame &frame, const Grid &grid, cudaStream_t stream)
{
    return launch(listsKernel, listWarps * warpLanes, false, frame, grid, stream);
}

cudaError_t launchTiles(const Frame &frame, bool general, const Grid &grid, cudaStream_t stream)
{
    return launch(general ? tilesKernel<true> : tilesKernel<false>, warpLanes, true, frame, grid, stream);
}

cudaError_t launchCopy(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects, int count,
                       cudaStream_t stream)
{
    copyKernel<<<dim3(unsigned(count), copySlices), copyThreads, 0, stream>>>(to, from, rowPixels, rects);
    return cudaGetLastError();
}

} // namespace suffuse::cuda
