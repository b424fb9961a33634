#include "render/cuda/device/failing_device.h"

#include "model/environment.h"

#include <cstdlib>

namespace suffuse::cuda {

Fault FailingDevice::next()
{
    const int call = ++m_calls;
    const bool fails = m_plan.call > 0 && (m_plan.kind == Fault::Lost ? call >= m_plan.call : call == m_plan.call);
    if (!fails)
        return {};
    return {m_plan.kind, "call " + std::to_string(m_plan.call) + " was made to fail"};
}

Fault FailingDevice::allocate(std::size_t bytes, void **memory)
{
    const Fault fault = next();
    return fault ? fault : m_device->allocate(bytes, memory);
}

Fault FailingDevice::allocateHost(std::size_t bytes, void **memory)
{
    const Fault fault = next();
    return fault ? fault : m_device->allocateHost(bytes, memory);
}

Fault FailingDevice::upload(void *to, const void *from, std::size_t bytes)
{
    const Fault fault = next();
    return fault ? fault : m_device->upload(to, from, bytes);
}

Fault FailingDevice::download(void *to, const void *from, std::size_t bytes)
{
    const Fault fault = next();
    return fault ? fault : m_device->download(to, from, bytes);
}

Fault FailingDevice::copyRects(std::uint32_t *to, const std::uint32_t *from, int rowPixels, const int (*rects)[4],
                               int count)
{
    const Fault fault = next();
    return fault ? fault : m_device->copyRects(to, from, rowPixels, rects, count);
}

Fault FailingDevice::clear(void *memory, std::size_t bytes)
{
    const Fault fault = next();
    return fault ? fault : m_device->clear(memory, bytes);
}

Fault FailingDevice::run(const Frame &frame, Work work)
{
    const Fault fault = next();
    return fault ? fault : m_device->run(frame, work);
}

Fault FailingDevice::buildNodes(const NodeWork &work)
{
    const Fault fault = next();
    return fault ? fault : m_device->buildNodes(work);
}

Fault FailingDevice::findGradient(const GradientWork &work)
{
    const Fault fault = next();
    return fault ? fault : m_device->findGradient(work);
}

Fault FailingDevice::finish(double *milliseconds)
{
    const Fault fault = next();
    const Fault real = m_device->finish(milliseconds); // What was asked for uses host memory until then.
    return fault ? fault : real;
}

std::unique_ptr<GlTexture> FailingDevice::registerTexture(unsigned texture, Fault &fault)
{
    fault = next();
    return fault ? nullptr : m_device->registerTexture(texture, fault);
}

std::unique_ptr<Device> failingIfAsked(std::unique_ptr<Device> device)
{
    const std::string asked = environment::value(environment::Variable::CudaFailure);
    if (asked.empty())
        return device;
    char *end = nullptr;
    const long call = std::strtol(asked.c_str(), &end, 10);
    const bool oom = std::string(end) == ":oom";
    return std::make_unique<FailingDevice>(std::move(device),
                                           PlannedFault{int(call), oom ? Fault::OutOfMemory : Fault::Lost});
}

} // namespace suffuse::cuda
