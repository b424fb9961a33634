#include "render/cuda/nodes/node_kernels.cuh"

#include "render/cuda/nodes/node_merge.h"
#include "render/cuda/nodes/node_place.h"

namespace suffuse::cuda {

namespace {

// A block is one warp, which takes one job.
__global__ void __launch_bounds__(warpLanes) placeKernel(const __grid_constant__ NodeWork work)
{
    __shared__ PlaceScratch scratch;
    DeviceWarp warp;
    NodePlacer<DeviceWarp>(warp, work, blockIdx.x, scratch).run();
}

/// So many windows are merged at the same time on a multiprocessor.
constexpr int mergeBlocks = 4;

// A block merges one window after the other.
__global__ void __launch_bounds__(fieldWarps *warpLanes, mergeBlocks) mergeKernel(const __grid_constant__ NodeWork work)
{
    __shared__ MergeScratch scratch;
    DeviceFieldCrew crew(scratch.field,
                         reinterpret_cast<Four *>(work.planes) + std::size_t(blockIdx.x) * (planeSize / 4));
    if (!crew.leads())
        return crew.help();
    const std::uint32_t leaves = work.status[leavesTaken];
    SpanMerger<DeviceFieldCrew> merger(crew, work, scratch);
    for (std::uint32_t leaf; (leaf = crew.warp().take(work.status + nextLeaf)) < leaves;)
        merger.merge(leaf);
    crew.share(FieldTask::End);
}

} // namespace

cudaError_t fillingMergers(int device, unsigned &blocks)
{
    int processors = 0, together = 0;
    cudaError_t error = cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device);
    if (error == cudaSuccess)
        error = cudaOccupancyMaxActiveBlocksPerMultiprocessor(&together, mergeKernel, fieldWarps * warpLanes, 0);
    const int all = processors * together;
    blocks = unsigned(all < 1 ? 1 : all > mergeWorkers ? mergeWorkers : all);
    return error;
}

cudaError_t launchNodes(const NodeWork &work, unsigned mergers, cudaStream_t stream)
{
    placeKernel<<<dim3(work.jobCount), warpLanes, 0, stream>>>(work);
    if (const cudaError_t error = cudaGetLastError(); error != cudaSuccess)
        return error;
    mergeKernel<<<dim3(mergers), fieldWarps * warpLanes, 0, stream>>>(work);
    return cudaGetLastError();
}

} // namespace suffuse::cuda
