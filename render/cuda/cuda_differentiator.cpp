#include "render/cuda/cuda_differentiator.h"

#include "render/cuda/cuda_renderer.h"
#include "render/cuda/device/failing_device.h"

namespace suffuse {

using namespace gradient;

CudaDifferentiator::CudaDifferentiator(std::shared_ptr<cuda::Device> device, const Threads &threads)
    : m_device(std::move(device)), m_threads(threads), m_cuda(m_device, threads)
{}

QString CudaDifferentiator::deviceName() const
{
    return m_lost ? QStringLiteral("CPU") : QString::fromStdString(m_device->name());
}

bool CudaDifferentiator::isFault(const cuda::Fault &fault)
{
    if (!fault)
        return false;
    m_lost = true;
    m_notice = QString::fromStdString(fault.what);
    return true;
}

Differentiator &CudaDifferentiator::cpu()
{
    if (!m_cpu)
        m_cpu = makeCpuDifferentiator(m_threads);
    if (!m_cpuHasChosen)
        m_cpu->choose(m_chosen, m_precision);
    m_cpuHasChosen = true;
    return *m_cpu;
}

void CudaDifferentiator::choose(const FlatScene &scene, const Precision &precision)
{
    m_chosen = scene;
    m_precision = precision;
    m_cpuHasChosen = false;
    if (!isOnCpu())
        m_cuda.choose(scene, precision);
}

std::span<const float> CudaDifferentiator::draw(const FlatScene &scene)
{
    m_drawn = scene;
    if (isOnCpu() || isFault(m_cuda.draw(scene)) || isFault(m_cuda.fetchPicture(m_picture)))
        return cpu().draw(scene);
    return m_picture;
}

const FlatGradient &CudaDifferentiator::backward(std::span<const float> lossByRgb)
{
    if (!isOnCpu()) {
        if (!isFault(m_cuda.backward(lossByRgb)))
            return m_cuda.gradient();
        cpu().draw(m_drawn);
    }
    return cpu().backward(lossByRgb);
}

const FlatGradient &CudaDifferentiator::drawAndDifferentiate(const FlatScene &scene, const PixelLoss &loss)
{
    m_drawn = scene;
    if (isOnCpu())
        return cpu().drawAndDifferentiate(scene, loss);
    if (!loss.squaresTo) {
        const std::span<const float> rgb = draw(scene);
        m_slopes.resize(rgb.size());
        const auto width = std::size_t(scene.view.width);
        parallelFor(std::size_t(scene.view.height), m_threads, [&](std::size_t y) {
            loss.slopes(y * width, width, rgb.data() + 3 * y * width, m_slopes.data() + 3 * y * width);
        });
        return backward(m_slopes);
    }
    if (loss.squaresTo != m_target) {
        m_target.reset();
        if (isFault(m_cuda.setTarget(*loss.squaresTo)))
            return cpu().drawAndDifferentiate(scene, loss);
        m_target = loss.squaresTo;
    }
    if (isFault(m_cuda.drawAndDifferentiate(scene)))
        return cpu().drawAndDifferentiate(scene, loss);
    return m_cuda.gradient();
}

Result<std::unique_ptr<Differentiator>> makeCudaDifferentiator(const Threads &threads)
{
    const cuda::Devices found = cuda::findDevices();
    if (found.count == 0)
        return Error{whyNone(found)};
    std::string why;
    std::shared_ptr<cuda::Device> device = cuda::openDevice(0, why);
    if (!device)
        return Error{QString::fromStdString(why)};
    return std::unique_ptr<Differentiator>(std::make_unique<CudaDifferentiator>(std::move(device), threads));
}

} // namespace suffuse
