#include "render/gradient/differentiator.h"

namespace suffuse::gradient {

namespace {

class CpuDifferentiator : public Differentiator {
public:
    explicit CpuDifferentiator(const Threads &threads) : m_gradient(threads) {}

    void choose(const FlatScene &scene, const Precision &precision) override { m_gradient.choose(scene, precision); }
    std::span<const float> draw(const FlatScene &scene) override { return m_gradient.draw(scene); }
    const FlatGradient &backward(std::span<const float> lossByRgb) override { return m_gradient.backward(lossByRgb); }
    const FlatGradient &drawAndDifferentiate(const FlatScene &scene, const PixelLoss &loss) override
    {
        return m_gradient.drawAndDifferentiate(scene, loss.slopes);
    }
    QString deviceName() const override { return QStringLiteral("CPU"); }

private:
    SceneGradient<float> m_gradient;
};

} // namespace

std::unique_ptr<Differentiator> makeCpuDifferentiator(const Threads &threads)
{
    return std::make_unique<CpuDifferentiator>(threads);
}

} // namespace suffuse::gradient
