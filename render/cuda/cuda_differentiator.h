// Gradients for fits, on a CUDA device for as long as it works.
#pragma once

#include "render/cuda/cuda_gradient.h"
#include "render/gradient/differentiator.h"
#include "model/result.h"

namespace suffuse {

/// Finds gradients on a device. What the device refuses (fills), and all that follows a fault, is done by the CPU, from the
/// scene and the nodes that were chosen last: a fit goes on without losing a step.
class CudaDifferentiator : public gradient::Differentiator {
public:
    CudaDifferentiator(std::shared_ptr<cuda::Device> device, const Threads &threads);

    void choose(const gradient::FlatScene &scene, const gradient::Precision &precision) override;
    std::span<const float> draw(const gradient::FlatScene &scene) override;
    const gradient::FlatGradient &backward(std::span<const float> lossByRgb) override;
    const gradient::FlatGradient &drawAndDifferentiate(const gradient::FlatScene &scene,
                                                       const gradient::PixelLoss &loss) override;
    QString deviceName() const override;
    QString notice() const override { return m_notice; }

private:
    /// Whether the CPU must do it. `fault` is what the device answered.
    bool isFault(const cuda::Fault &fault);
    bool isOnCpu() const { return m_lost || !CudaGradient::canDraw(m_chosen); }
    /// The CPU's, with the nodes that were chosen last.
    gradient::Differentiator &cpu();

    std::shared_ptr<cuda::Device> m_device;
    Threads m_threads;
    CudaGradient m_cuda;
    std::unique_ptr<gradient::Differentiator> m_cpu;
    gradient::FlatScene m_chosen, m_drawn; ///< what nodes were chosen for, and what was drawn last
    gradient::Precision m_precision;
    bool m_cpuHasChosen = false;
    bool m_lost = false;
    std::shared_ptr<const std::vector<float>> m_target; ///< that is on the device
    std::vector<float> m_picture, m_slopes;
    QString m_notice;
};

/// Makes one on the first CUDA device. The error says why there is none.
Result<std::unique_ptr<gradient::Differentiator>> makeCudaDifferentiator(const Threads &threads);

} // namespace suffuse
