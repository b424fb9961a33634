#include "render/cuda/tiles/kernels.cuh"

#include "render/cuda/tiles/tile_lists.h"
#include "render/cuda/tiles/tile_program.h"

namespace suffuse::cuda {

namespace {

/// Begins a kernel of a frame: lets the next one be made ready, and waits until the one before is done. Older chips run
/// kernels one after another anyway.
__device__ void takeTurn()
{
#if defined(__CUDA_ARCH__) && __CUDA_ARCH__ >= 900
    cudaTriggerProgrammaticLaunchCompletion();
    cudaGridDependencySynchronize();
#endif
}

// A block makes one list after the other. With `fills`, strokes may have fills.
template <bool fills>
__global__ void __launch_bounds__(listWarps *warpLanes, 3) listsKernel(const __grid_constant__ Frame frame)
{
    __shared__ ListScratch<fills> scratch;
    takeTurn();
    DeviceBlock block;
    for (std::uint32_t list = blockIdx.x; list < frame.macroCount * listParts; list += gridDim.x)
        ListMaker<DeviceBlock, fills>(block, frame, list, scratch).make();
}

/// So many warps run at once on a multiprocessor, which is to a GPU what a core is to a processor.
constexpr int plainWarps = 12, generalWarps = 8;

/// Returns a block's first place in the order. Where blocks are made ready while lists are made, those of one
/// multiprocessor get numbers in a row, and tiles of like weights go well together there. But one multiprocessor with
/// all of the heaviest tiles would be late, so the first quarter of the multiprocessors get theirs as cards are dealt,
/// there and back.
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

/// Returns the next place that no block has. The first places, one for each block, are those of `firstPlace`.
template <StatusWord counter>
__device__ std::uint32_t nextPlace(const Frame &frame)
{
    std::uint32_t place = 0;
    if (threadIdx.x == 0)
        place = gridDim.x + atomicAdd(frame.status + counter, 1u);
    return __shfl_sync(0xffffffffu, place, 0);
}

// A block is one warp, which paints one tile job after the other.
// With `fills`, plain strokes may have fills.
// With `layered`, strokes may lie in layers of the painting.
// With `apart`, it first evaluates strokes apart from their tiles.
template <bool general, bool apart, bool fills, bool layered = false>
__global__ void __launch_bounds__(warpLanes, general ? generalWarps : plainWarps)
    tilesKernel(const __grid_constant__ Frame frame)
{
    __shared__ TileScratch<general> scratch;
    __shared__ OrderScratch orderScratch;
    takeTurn();
    DeviceWarp warp;
    if constexpr (apart)
        paintApart<general, fills>(warp, frame, scratch);
    TileOrder order(warp, frame, orderScratch);
    constexpr StatusWord counter = general ? nextGeneralTile : nextPlainTile;
    constexpr int together = general ? generalWarps : plainWarps;
    for (std::uint32_t i = firstPlace<together>(); i < frame.tileCount; i = nextPlace<counter>(frame)) {
        const std::uint32_t job = order.job(i);
        if (((frame.tiles[job].flags & plainTile) == 0) == general)
            paintTile<general, apart, fills, layered>(warp, frame, job, scratch);
    }
}

constexpr int copyThreads = 256, copySlices = 128;

// A rectangle is copied by copySlices blocks, each of which takes every copySlices-th row.
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
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&lists, listsKernel<true>, listWarps * warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&plain, tilesKernel<false, true, false>, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&general, tilesKernel<true, true, true>, warpLanes, 0);
    cudaFuncAttributes compiled = {};
    if (error == cudaSuccess)
        error = cudaFuncGetAttributes(&compiled, listsKernel<false>);
    grid = {unsigned(processors * lists), unsigned(processors * plain), unsigned(processors * general),
            compiled.ptxVersion >= 90};
    return error;
}

unsigned blocksOf(const void *kernel, const Frame &frame, const Grid &grid)
{
    const auto least = [](unsigned a, std::size_t b) { return unsigned(b < a ? b : a); };
    if (kernel == reinterpret_cast<const void *>(listsKernel<false>) ||
        kernel == reinterpret_cast<const void *>(listsKernel<true>))
        return least(grid.lists, std::size_t(frame.macroCount) * listParts);
    const bool general = kernel == reinterpret_cast<const void *>(tilesKernel<true, true, false>) ||
                         kernel == reinterpret_cast<const void *>(tilesKernel<true, true, true>) ||
                         kernel == reinterpret_cast<const void *>(tilesKernel<true, true, true, true>);
    const unsigned blocks = general ? grid.general : grid.plain;
    return frame.apartRoom ? blocks : least(blocks, frame.tileCount);
}

namespace {

/// Launches one of the kernels of a frame. `follows` says that it may be made ready while the one before runs.
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
    return launch(frame.fills ? listsKernel<true> : listsKernel<false>, listWarps * warpLanes, false, frame, grid,
                  stream);
}

cudaError_t launchTiles(const Frame &frame, bool general, const Grid &grid, cudaStream_t stream)
{
    const bool apart = frame.apartRoom != 0, fills = frame.fills != nullptr;
    if (frame.layers)
        return launch(general ? tilesKernel<true, true, true, true> : tilesKernel<false, true, true, true>, warpLanes,
                      true, frame, grid, stream);
    return launch(general && fills ? tilesKernel<true, true, true>
                  : general        ? tilesKernel<true, true, false>
                  : fills && apart ? tilesKernel<false, true, true>
                  : fills          ? tilesKernel<false, false, true>
                  : apart          ? tilesKernel<false, true, false>
                                   : tilesKernel<false, false, false>,
                  warpLanes, true, frame, grid, stream);
}

cudaError_t launchCopy(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int4 *rects, int count,
                       cudaStream_t stream)
{
    copyKernel<<<dim3(unsigned(count), copySlices), copyThreads, 0, stream>>>(to, from, rowPixels, rects);
    return cudaGetLastError();
}

} // namespace suffuse::cuda
