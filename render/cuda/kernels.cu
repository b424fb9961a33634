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

// Runs once per list, by one warp.
__global__ void __launch_bounds__(warpLanes) listsKernel(const __grid_constant__ Frame frame)
{
    takeTurn();
    DeviceWarp warp;
    for (std::uint32_t list = blockIdx.x; list < frame.macroCount * listParts; list += gridDim.x)
        makeList(warp, frame, list);
}

constexpr int cullWarps = 4; ///< a block

// Runs once per entry of the lists and half of the macro-tile, by one warp.
__global__ void __launch_bounds__(cullWarps *warpLanes, 8) cullKernel(const __grid_constant__ Frame frame)
{
    __shared__ CullScratch scratch[cullWarps];
    takeTurn();
    DeviceWarp warp;
    const int own = int(threadIdx.x) / warpLanes;
    const std::uint32_t longest = frame.status[longestList], room = longest < frame.listRoom ? longest : frame.listRoom;
    const std::uint32_t lists = frame.macroCount * listParts, jobs = room * lists * 2;
    for (std::uint32_t job = blockIdx.x * cullWarps + own; job < jobs; job += gridDim.x * cullWarps)
        cullEntry(warp, frame, job / 2 % lists, job / 2 / lists, int(job % 2), scratch[own]);
}

constexpr int orderThreads = 1024, weightClasses = 256;

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
    return frame.weights[std::size_t(tile.macro) * macroTiles * macroTiles + at];
}

// Runs once, by one block: puts heavy tiles first, so that no long one is begun last. Which of two of a class comes
// first may differ from call to call; pixels do not depend on it.
__global__ void __launch_bounds__(orderThreads) orderKernel(const __grid_constant__ Frame frame)
{
    __shared__ std::uint32_t places[weightClasses];
    takeTurn();
    for (int i = int(threadIdx.x); i < weightClasses; i += orderThreads)
        places[i] = 0;
    __syncthreads();
    SUFFUSE_UNROLL_BY_4
    for (std::uint32_t job = threadIdx.x; job < frame.tileCount; job += orderThreads)
        atomicAdd(places + classOf(weightOf(frame, job)), 1u);
    __syncthreads();
    if (threadIdx.x < warpLanes) { // counts to first places
        std::uint32_t before = 0;
        for (int from = 0; from < weightClasses; from += warpLanes) {
            const std::uint32_t own = places[from + threadIdx.x];
            std::uint32_t sum = own;
            for (int by = 1; by < warpLanes; by *= 2) {
                const std::uint32_t lower = __shfl_up_sync(0xffffffffu, sum, by);
                sum += int(threadIdx.x) >= by ? lower : 0;
            }
            places[from + threadIdx.x] = before + sum - own;
            before += __shfl_sync(0xffffffffu, sum, warpLanes - 1);
        }
    }
    __syncthreads();
    SUFFUSE_UNROLL_BY_4
    for (std::uint32_t job = threadIdx.x; job < frame.tileCount; job += orderThreads)
        frame.order[atomicAdd(places + classOf(weightOf(frame, job)), 1u)] = job;
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
    int processors = 0, lists = 0, culls = 0, plain = 0, general = 0;
    cudaError_t error = cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&lists, listsKernel, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&culls, cullKernel, cullWarps * warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&plain, tilesKernel<false>, warpLanes, 0);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&general, tilesKernel<true>, warpLanes, 0);
    cudaFuncAttributes compiled = {};
    if (error == cudaSuccess)
        error = cudaFuncGetAttributes(&compiled, listsKernel);
    grid = {unsigned(processors * lists), unsigned(processors * culls), unsigned(processors * plain),
            unsigned(processors * general), compiled.ptxVersion >= 90};
    return error;
}

unsigned blocksOf(const void *kernel, const Frame &frame, const Grid &grid)
{
    const auto least = [](unsigned a, std::size_t b) { return unsigned(b < a ? b : a); };
    if (kernel == reinterpret_cast<const void *>(listsKernel))
        return least(grid.lists, std::size_t(frame.macroCount) * listParts);
    if (kernel == reinterpret_cast<const void *>(cullKernel))
        return least(grid.culls,
                     (std::size_t(frame.macroCount) * listParts * frame.listRoom * 2 + cullWarps - 1) / cullWarps);
    if (kernel == reinterpret_cast<const void *>(orderKernel))
        return 1;
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
    cudaError_t error = launch(listsKernel, warpLanes, false, frame, grid, stream);
    if (error == cudaSuccess)
        error = launch(cullKernel, cullWarps * warpLanes, true, frame, grid, stream);
    if (error == cudaSuccess && frame.ordered)
        error = launch(orderKernel, orderThreads, true, frame, grid, stream);
    return error;
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
