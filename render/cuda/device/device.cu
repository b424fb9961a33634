// This is the CUDA device. It does its calls in order, in one stream. The lists and tiles of a frame are one graph,
// which is made once; its kernels get the frame of each call.
#include "render/cuda/device/device.h"

#include "render/cuda/device/gl_interop.h"
#include "render/cuda/gradient/gradient_kernels.cuh"
#include "render/cuda/nodes/node_kernels.cuh"
#include "render/cuda/tiles/kernels.cuh"

namespace suffuse::cuda {

namespace {

Fault faultOf(cudaError_t error)
{
    if (error == cudaSuccess)
        return {};
    cudaGetLastError(); // Without this the next call would find the error.
    const bool memory = error == cudaErrorMemoryAllocation;
    return {memory ? Fault::OutOfMemory : Fault::Lost, cudaGetErrorString(error)};
}

/// Holds the calls of one frame, which are made once for each kind of work.
class FrameGraph {
public:
    FrameGraph() = default;
    FrameGraph(const FrameGraph &) = delete;
    FrameGraph &operator=(const FrameGraph &) = delete;
    ~FrameGraph()
    {
        if (m_runnable)
            cudaGraphExecDestroy(m_runnable);
        if (m_graph)
            cudaGraphDestroy(m_graph);
        if (m_forked)
            cudaEventDestroy(m_forked);
        if (m_side)
            cudaStreamDestroy(m_side);
    }

    cudaError_t launch(const Frame &frame, Work work, const Grid &grid, cudaStream_t stream)
    {
        const cudaError_t error = m_runnable ? update(frame, grid) : record(frame, work, grid, stream);
        return error == cudaSuccess ? cudaGraphLaunch(m_runnable, stream) : error;
    }

private:
    static constexpr int mostNodes = 8;

    cudaError_t record(const Frame &frame, Work work, const Grid &grid, cudaStream_t stream)
    {
        if (m_graph) // An attempt that failed has left it.
            cudaGraphDestroy(m_graph);
        m_graph = nullptr;
        cudaError_t error = cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal);
        if (error != cudaSuccess)
            return error;
        error = launchLists(frame, grid, stream);
        if (error == cudaSuccess)
            error = work.plain && work.general ? launchBoth(frame, grid, stream)
                                               : launchTiles(frame, work.general, grid, stream);
        const cudaError_t ended = cudaStreamEndCapture(stream, &m_graph);
        if (error == cudaSuccess)
            error = ended;
        m_kernels = mostNodes;
        if (error == cudaSuccess)
            error = cudaGraphGetNodes(m_graph, m_node, &m_kernels);
        return error == cudaSuccess ? cudaGraphInstantiate(&m_runnable, m_graph, 0) : error;
    }

    /// Launches both kernels for tiles side by side: what the last tiles of the general one leave idle, the plain one
    /// takes.
    cudaError_t launchBoth(const Frame &frame, const Grid &grid, cudaStream_t stream)
    {
        cudaError_t error = cudaSuccess;
        const auto then = [&](cudaError_t next) { error = error == cudaSuccess ? next : error; };
        if (!m_side)
            then(cudaStreamCreateWithFlags(&m_side, cudaStreamNonBlocking));
        if (!m_forked)
            then(cudaEventCreateWithFlags(&m_forked, cudaEventDisableTiming));
        if (error != cudaSuccess)
            return error;
        then(cudaEventRecord(m_forked, stream));
        then(cudaStreamWaitEvent(m_side, m_forked, 0));
        then(launchTiles(frame, true, grid, stream));
        then(launchTiles(frame, false, grid, m_side));
        then(cudaEventRecord(m_forked, m_side));
        then(cudaStreamWaitEvent(stream, m_forked, 0));
        return error;
    }

    cudaError_t update(const Frame &frame, const Grid &grid)
    {
        for (std::size_t i = 0; i < m_kernels; ++i) {
            cudaKernelNodeParams params = {};
            cudaError_t error = cudaGraphKernelNodeGetParams(m_node[i], &params);
            if (error != cudaSuccess)
                return error;
            Frame own = frame;
            void *arguments[] = {&own};
            params.kernelParams = arguments;
            params.gridDim = dim3(blocksOf(params.func, frame, grid));
            params.extra = nullptr;
            error = cudaGraphExecKernelNodeSetParams(m_runnable, m_node[i], &params);
            if (error != cudaSuccess)
                return error;
        }
        return cudaSuccess;
    }

    cudaGraph_t m_graph = nullptr;
    cudaGraphExec_t m_runnable = nullptr;
    cudaGraphNode_t m_node[mostNodes] = {};
    std::size_t m_kernels = 0;
    cudaStream_t m_side = nullptr; ///< beside the one that is recorded
    cudaEvent_t m_forked = nullptr;
};

class CudaDevice : public Device {
public:
    explicit CudaDevice(int index) : m_index(index) {}
    CudaDevice(const CudaDevice &) = delete;
    CudaDevice &operator=(const CudaDevice &) = delete;
    ~CudaDevice() override
    {
        use();
        if (m_stream)
            cudaStreamSynchronize(m_stream);
        cudaFree(m_rects);
        for (cudaEvent_t event : {m_begin, m_end})
            if (event)
                cudaEventDestroy(event);
        if (m_stream)
            cudaStreamDestroy(m_stream);
        cudaGetLastError();
    }

    Fault open()
    {
        cudaDeviceProp properties;
        for (cudaError_t error : {use(), cudaGetDeviceProperties(&properties, m_index),
                                  cudaStreamCreateWithFlags(&m_stream, cudaStreamNonBlocking),
                                  cudaEventCreate(&m_begin), cudaEventCreate(&m_end), fillingGrid(m_index, m_grid),
                                  fillingMergers(m_index, m_mergers), fillingGradient(m_index, m_gradientWarps)})
            if (error != cudaSuccess)
                return faultOf(error);
        m_name = properties.name;
        return {};
    }

    std::string name() const override { return m_name; }

    std::size_t freeMemory() const override
    {
        std::size_t unused = 0, all = 0;
        use();
        return cudaMemGetInfo(&unused, &all) == cudaSuccess ? unused : 0;
    }

    Fault allocate(std::size_t bytes, void **memory) override
    {
        return call([&] { return cudaMalloc(memory, bytes); });
    }
    void release(void *memory) override
    {
        use();
        cudaFree(memory);
        cudaGetLastError();
    }
    Fault allocateHost(std::size_t bytes, void **memory) override
    {
        return call([&] { return cudaMallocHost(memory, bytes); });
    }
    void releaseHost(void *memory) override
    {
        use();
        cudaFreeHost(memory);
        cudaGetLastError();
    }

    Fault upload(void *to, const void *from, std::size_t bytes) override
    {
        return call([&] { return cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, m_stream); });
    }
    Fault download(void *to, const void *from, std::size_t bytes) override
    {
        return call([&] { return cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, m_stream); });
    }
    Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                    int count) override
    {
        if (count == 0)
            return {};
        if (count > m_rectRoom) {
            use();
            cudaStreamSynchronize(m_stream);
            cudaFree(m_rects);
            m_rects = nullptr;
            m_rectRoom = 2 * count;
            if (const Fault fault =
                    call([&] { return cudaMalloc(&m_rects, sizeof(int4) * std::size_t(m_rectRoom)); })) {
                m_rectRoom = 0;
                return fault;
            }
        }
        if (const Fault fault = upload(m_rects, rects, sizeof(int4) * std::size_t(count)))
            return fault;
        return call([&] { return launchCopy(to, from, rowPixels, m_rects, count, m_stream); });
    }
    Fault clear(void *memory, std::size_t bytes) override
    {
        return call([&] { return cudaMemsetAsync(memory, 0, bytes, m_stream); });
    }

    Fault run(const Frame &frame, Work work) override
    {
        use();
        m_timed = true;
        cudaEventRecord(m_begin, m_stream);
        Frame own = frame;
        own.ordered = frame.tileCount > m_grid.plain; // Otherwise all tiles begin at once.
        FrameGraph &graph = m_graphs[work.plain][work.general][own.ordered][own.apartRoom != 0][own.layers != nullptr];
        if (const Fault fault = call([&] { return graph.launch(own, work, m_grid, m_stream); }))
            return fault;
        return call([&] { return cudaEventRecord(m_end, m_stream); });
    }

    Fault buildNodes(const NodeWork &work) override
    {
        return call([&] { return launchNodes(work, m_mergers, m_stream); });
    }

    std::uint32_t gradientWarps() const override { return m_gradientWarps; }
    Fault findGradient(const GradientWork &work) override
    {
        use();
        m_timed = true;
        cudaEventRecord(m_begin, m_stream);
        if (const Fault fault = call([&] { return launchGradient(work, m_stream); }))
            return fault;
        return call([&] { return cudaEventRecord(m_end, m_stream); });
    }

    Fault finish(double *milliseconds) override
    {
        use();
        const Fault fault = call([&] { return cudaStreamSynchronize(m_stream); });
        float time = 0;
        if (!fault && m_timed && milliseconds && cudaEventElapsedTime(&time, m_begin, m_end) == cudaSuccess)
            *milliseconds = double(time);
        return fault;
    }

    std::unique_ptr<GlTexture> registerTexture(unsigned texture, Fault &fault) override
    {
        return registerGlTexture(m_index, texture, fault);
    }

private:
    cudaError_t use() const { return cudaSetDevice(m_index); }
    /// Makes a call with this device in use, since CUDA remembers for each thread which device that is.
    template <class Calls>
    Fault call(Calls calls)
    {
        const cudaError_t error = use();
        return faultOf(error == cudaSuccess ? calls() : error);
    }

    int m_index;
    std::string m_name;
    cudaStream_t m_stream = nullptr;
    cudaEvent_t m_begin = nullptr, m_end = nullptr;
    bool m_timed = false;
    Grid m_grid;
    unsigned m_mergers = 1;
    std::uint32_t m_gradientWarps = 1;
    FrameGraph m_graphs[2][2][2][2][2];
    int4 *m_rects = nullptr;
    int m_rectRoom = 0;
};

} // namespace

Devices findDevices()
{
    Devices found;
    const cudaError_t error = cudaGetDeviceCount(&found.count);
    if (error == cudaSuccess && found.count > 0)
        return found;
    found.count = 0;
    found.why = error == cudaErrorInsufficientDriver                 ? NoDevice::NoDriver
                : error == cudaErrorNoDevice || error == cudaSuccess ? NoDevice::NoGpu
                                                                     : NoDevice::Failed;
    found.said = faultOf(error).what;
    return found;
}

std::unique_ptr<Device> openDevice(int index, std::string &why)
{
    auto device = std::make_unique<CudaDevice>(index);
    if (const Fault fault = device->open()) {
        why = fault.what;
        return nullptr;
    }
    return device;
}

} // namespace suffuse::cuda
