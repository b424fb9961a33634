// The picture of a flat scene and the exact derivatives of a loss by its numbers, on a CUDA device (docs/cuda.md,
// "The gradient"). It does what SceneGradient<float> does on the CPU.
#pragma once

#include "render/cuda/device/device_memory.h"
#include "render/gradient/node_rule.h"
#include "render/threads/parallel.h"

#include <span>

namespace suffuse {

/// Results are a pure function of the scene, the nodes chosen and the loss: the same bits each time on the same device.
/// After a fault results are not valid; the next call may try again unless the device is lost. Scenes with fills, and
/// those whose ground is a picture, are refused (`canDraw`).
class CudaGradient {
public:
    explicit CudaGradient(std::shared_ptr<cuda::Device> device, Threads threads = {});

    /// False for scenes of which only the CPU finds the gradient.
    static bool canDraw(const gradient::FlatScene &scene);

    /// Chooses how many nodes each segment has, as SceneGradient::choose does.
    void choose(const gradient::FlatScene &scene, const gradient::Precision &precision = {});
    /// Uploads the picture that drawAndDifferentiate compares with: sRGB-encoded R, G, B of each pixel, row by row.
    cuda::Fault setTarget(std::span<const float> rgb);

    /// Draws the scene. `choose` must have seen a scene with as many segments and strokes.
    cuda::Fault draw(const gradient::FlatScene &scene);
    /// Finds the derivatives of a loss by the numbers of the scene drawn last, from ∂L/∂(R, G, B) of each pixel.
    cuda::Fault backward(std::span<const float> lossByRgb);
    /// Draws the scene, and finds the loss Σ(picture − target)² over pixels and channels, and its derivatives. Only
    /// numbers of the scene go to the device, and only derivatives come back. A target that has not the size of
    /// the scene's view is refused. With `picture` the picture stays on the device, too.
    cuda::Fault drawAndDifferentiate(const gradient::FlatScene &scene, bool picture = false);

    /// Derivatives found last.
    const gradient::FlatGradient &gradient() const { return m_gradient; }
    double loss() const { return m_loss; }
    /// The time of the last call's programs on the device's clock.
    double milliseconds() const { return m_milliseconds; }
    /// Fetches the picture drawn last: R, G, B of each pixel, row by row.
    cuda::Fault fetchPicture(std::vector<float> &out);

private:
    enum class Loss { None, Target, Given };

    cuda::Fault prepare(const gradient::FlatScene &scene);
    cuda::Fault uploadRules();
    cuda::Fault uploadPaper(const gradient::FlatScene &scene);
    void describe(const gradient::FlatScene &scene);
    cuda::Fault reserve(Loss loss);
    cuda::Fault reserveSlots();
    cuda::Fault run(Loss loss, bool picture);
    /// Runs the programs once. `enough`: whether no tile showed more strokes than a slot has room for.
    cuda::Fault attempt(Loss loss, bool &enough);
    void takeResults(Loss loss);

    std::shared_ptr<cuda::Device> m_device;
    Threads m_threads;
    gradient::NodeRules m_rules;
    bool m_rulesThere = false;   ///< on the device
    gradient::FlatScene m_scene; ///< drawn last
    gradient::FlatGradient m_gradient;
    double m_loss = 0, m_milliseconds = 0;

    cuda::GradientWork m_work;
    std::uint32_t m_entryCount = 0, m_slotStrokes = 32;
    std::shared_ptr<const std::vector<float>> m_paper; ///< what is on the device of it
    std::size_t m_targetSize = 0;

    cuda::PinnedArray<cuda::GradientSegment> m_segments;
    cuda::PinnedArray<cuda::GradientStroke> m_strokes;
    cuda::PinnedArray<cuda::GradientSums> m_sums;
    cuda::PinnedArray<float> m_losses;
    cuda::PinnedArray<std::uint32_t> m_status;
    cuda::DeviceArray<cuda::GradientSegment> m_deviceSegments;
    cuda::DeviceArray<cuda::GradientStroke> m_deviceStrokes;
    cuda::DeviceArray<cuda::GradientRule> m_deviceRules;
    cuda::DeviceArray<cuda::GradientNode> m_nodes;
    cuda::DeviceArray<cuda::GradientBox> m_boxes;
    cuda::DeviceArray<cuda::GradientEntry> m_entries;
    cuda::DeviceArray<cuda::GradientSums> m_deviceSums;
    cuda::DeviceArray<float> m_levels, m_devicePaper, m_target, m_byRgb, m_picture, m_deviceLosses, m_kept;
    cuda::DeviceArray<std::uint32_t> m_shown, m_deviceStatus;
};

} // namespace suffuse
