// Tests of what happens when a call fails use a device whose n-th call does.
#pragma once

#include "render/cuda/device/device.h"

#include <atomic>

namespace suffuse::cuda {

/// Says which call of a device fails, counted from 1 (0: none), and how.
struct PlannedFault {
    int call = 0;
    Fault::Kind kind = Fault::Lost; ///< Lost: all calls after it fail, too. OutOfMemory: only this one fails.
};

/// This device passes everything on to another one, except the call that is to fail.
class FailingDevice : public Device {
public:
    FailingDevice(std::unique_ptr<Device> device, PlannedFault plan) : m_device(std::move(device)), m_plan(plan) {}

    /// Returns the number of calls so far that could have failed.
    int calls() const { return m_calls; }

    std::string name() const override { return m_device->name(); }
    std::size_t freeMemory() const override { return m_device->freeMemory(); }
    Fault allocate(std::size_t bytes, void **memory) override;
    void release(void *memory) override { m_device->release(memory); }
    Fault allocateHost(std::size_t bytes, void **memory) override;
    void releaseHost(void *memory) override { m_device->releaseHost(memory); }
    Fault upload(void *to, const void *from, std::size_t bytes) override;
    Fault download(void *to, const void *from, std::size_t bytes) override;
    Fault copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                    int count) override;
    Fault clear(void *memory, std::size_t bytes) override;
    Fault run(const Frame &frame, Work work) override;
    Fault buildNodes(const NodeWork &work) override;
    std::uint32_t gradientWarps() const override { return m_device->gradientWarps(); }
    Fault findGradient(const GradientWork &work) override;
    Fault finish(double *milliseconds) override;
    std::unique_ptr<GlTexture> registerTexture(unsigned texture, Fault &fault) override;

private:
    Fault next();

    std::unique_ptr<Device> m_device;
    PlannedFault m_plan;
    std::atomic<int> m_calls = 0; ///< Textures are registered by another thread.
};

/// Returns the device itself or, if the environment variable SUFFUSE_CUDA_FAIL is "n" or "n:oom", one whose n-th call
/// fails.
std::unique_ptr<Device> failingIfAsked(std::unique_ptr<Device> device);

} // namespace suffuse::cuda
