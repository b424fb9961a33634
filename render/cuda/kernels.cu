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

// Runs once per list, by one block.
__global__ void __launch_bounds__(listWarps *warpLanes, 3) listsKernel(const __grid_constant__ Frame frame)
{
    __shared__ ListScratch scratch;
    takeTurn();
    DeviceBlock block;
    for (std::uint32_t list = blockIdx.x; list < frame.macroCount * listParts; list += gridDim.x)
        ListMaker<DeviceBlock>(block, frame, list, scratch).make();
}

/// Warps a multiprocessor.
constexpr int plainWarps = 12, generalWarps = 5;

/// Where a block begins in the order. Blocks of one multiprocessor follow one another where they are made ready while
/// lists are made, and tiles of like weights go well together there; but the heaviest would make one multiprocessor
/// late, so the first quarter of them is dealt out, there and back.
template <int together>
__device__ std::uint32_t firstPlace()
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
    const std::uint32_t dealt = gridDim.x / (together * 4), to = blockIdx.x / together, round = blockIdx.x % together;
    if (to < dealt)
        return round * dealt + (round % 2 ? dealt - 1 - to : to);
#endif
    return blockIdx.x;
}

/// The first places are those of `firstPlace`; of the rest each block takes the next that nobody has.
template <StatusWord counter>
__device__ std::uint32_t nextPlace(const Frame &frame)
{
    std::uint32_t place = 0;
    if (threadIdx.x == 0)
        place = gridDim.x + atomicAdd(frame.status + counter, 1u);
    return __shfl_sync(0xffffffffu, place, 0);
}

// Runs once per tile job, by one warp.
template <bool general>
__global__ void __launch_bounds__(warpLanes, general ? generalWarps : plainWarps)
    tilesKernel(const __grid_constant__ Frame frame)
{
    __shared__ TileScratch<general> scratch;
    __shared__ OrderScratch orderScratch;
    takeTurn();
    DeviceWarp warp;
    TileOrder order(warp, frame, orderScratch);
    constexpr StatusWord counter = general ? nextGeneralTile : nextPlainTile;
    constexpr int together = general ? generalWarps : plainWarps;
    for (std::uint32_t i = firstPlace<together>(); i < frame.tileCount; i = nextPlace<counter>(frame)) {
        const std::uint32_t job = order.job(i);
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
