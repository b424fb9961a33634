// CUDA writes to OpenGL textures here. This links no libGL, since the driver knows the context that is current.
#include "render/cuda/device/gl_interop.h"

#include <cuda_gl_interop.h>
#include <cuda_runtime.h>

#include <algorithm>
#include <string>

namespace suffuse::cuda {

namespace {

/// Says nothing if the call went well, else what the driver says. The error is taken from CUDA, so that the next call
/// does not find it.
Fault faultOf(cudaError_t error)
{
    if (error == cudaSuccess)
        return {};
    cudaGetLastError();
    return {error == cudaErrorMemoryAllocation ? Fault::OutOfMemory : Fault::Lost, cudaGetErrorString(error)};
}

class RegisteredTexture : public GlTexture {
public:
    explicit RegisteredTexture(int device) : m_device(device) {}
    RegisteredTexture(const RegisteredTexture &) = delete;
    RegisteredTexture &operator=(const RegisteredTexture &) = delete;

    ~RegisteredTexture() override
    {
        cudaSetDevice(m_device);
        if (m_resource)
            cudaGraphicsUnregisterResource(m_resource);
        if (m_stream)
            cudaStreamDestroy(m_stream);
        cudaGetLastError();
    }

    cudaError_t open(unsigned texture)
    {
        // Rendering goes on in the device's own stream meanwhile, so this needs another one.
        if (const cudaError_t error = cudaStreamCreateWithFlags(&m_stream, cudaStreamNonBlocking))
            return error;
        // What is not written must stay, so the flags do not say that it may be discarded.
        return cudaGraphicsGLRegisterImage(&m_resource, texture, GL_TEXTURE_2D, cudaGraphicsRegisterFlagsNone);
    }

    Fault copyFrom(const std::uint32_t *picture, int rowPixels, const int (*rects)[4], int count) override
    {
        if (const cudaError_t error = cudaSetDevice(m_device))
            return faultOf(error);
        if (const cudaError_t error = cudaGraphicsMapResources(1, &m_resource, m_stream))
            return faultOf(error);
        const cudaError_t copied = copyMapped(picture, rowPixels, rects, count);
        const cudaError_t unmapped = cudaGraphicsUnmapResources(1, &m_resource, m_stream);
        // The picture may be written to again as soon as this returns.
        const cudaError_t finished = cudaStreamSynchronize(m_stream);
        for (const cudaError_t error : {copied, unmapped, finished})
            if (error != cudaSuccess)
                return faultOf(error);
        return {};
    }

private:
    cudaError_t copyMapped(const std::uint32_t *picture, int rowPixels, const int (*rects)[4], int count)
    {
        cudaArray_t array = nullptr;
        if (const cudaError_t error = cudaGraphicsSubResourceGetMappedArray(&array, m_resource, 0, 0))
            return error;
        constexpr std::size_t pixel = sizeof(std::uint32_t);
        for (int i = 0; i < count; ++i) {
            const auto [x, y, width, height] = rects[i];
            const std::uint32_t *from = picture + std::size_t(y) * rowPixels + x;
            if (const cudaError_t error =
                    cudaMemcpy2DToArrayAsync(array, x * pixel, std::size_t(y), from, rowPixels * pixel, width * pixel,
                                             std::size_t(height), cudaMemcpyDeviceToDevice, m_stream))
                return error;
        }
        return cudaSuccess;
    }

    int m_device;
    cudaStream_t m_stream = nullptr;
    cudaGraphicsResource_t m_resource = nullptr;
};

/// Says why `device` does not draw the current context. The text is empty if it does.
std::string whyNotDrawnBy(int device)
{
    constexpr unsigned most = 16;
    unsigned count = 0;
    int devices[most] = {};
    const cudaError_t error = cudaGLGetDevices(&count, devices, most, cudaGLDeviceListAll);
    if (error != cudaSuccess) {
        cudaGetLastError();
        return std::string("no CUDA device draws this OpenGL context (") + cudaGetErrorString(error) + ")";
    }
    if (std::find(devices, devices + std::min(count, most), device) == devices + std::min(count, most))
        return "another device draws this OpenGL context";
    return {};
}

} // namespace

std::unique_ptr<GlTexture> registerGlTexture(int device, unsigned texture, Fault &fault)
{
    fault = faultOf(cudaSetDevice(device));
    if (fault)
        return nullptr;
    fault.what = whyNotDrawnBy(device);
    if (!fault.what.empty())
        return nullptr;
    auto registered = std::make_unique<RegisteredTexture>(device);
    fault.what = faultOf(registered->open(texture)).what;
    if (!fault.what.empty())
        return nullptr;
    return registered;
}

} // namespace suffuse::cuda
