// What the gradient on a device must do, be it a GPU or emulated: what the CPU's does.
#pragma once

#include "render/cuda/cuda_gradient.h"
#include "render/gradient/scene_gradient.h"
#include "tests/render/flat_scenes.h"

#include <QTest>

#include <cstring>
#include <functional>

namespace suffuse::test {

using OpenDevice = std::function<std::shared_ptr<cuda::Device>()>;

/// |a − b| / |a| of the gradients as vectors, each number in steps that show.
inline double relativeDistance(FlatScene &scene, const FlatGradient &a, const FlatGradient &b)
{
    std::vector<double> values;
    double all = 0, differences = 0;
    forEachNumber(scene, a, [&](double, double d, double scale) {
        values.push_back(d * scale);
        all += d * scale * d * scale;
    });
    std::size_t i = 0;
    forEachNumber(scene, b, [&](double, double d, double scale) {
        differences += (values[i] - d * scale) * (values[i] - d * scale);
        ++i;
    });
    return all > 0 ? std::sqrt(differences / all) : differences > 0 ? 1e300 : 0;
}

inline double greatestDifference(std::span<const float> a, std::span<const float> b)
{
    double worst = a.size() == b.size() ? 0 : 1e300;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        worst = std::max(worst, std::abs(double(a[i]) - double(b[i])));
    return worst;
}

inline bool sameBits(const FlatGradient &a, const FlatGradient &b)
{
    const auto areSame = [](const auto &x, const auto &y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0);
    };
    return areSame(a.segments, b.segments) && areSame(a.strokes, b.strokes);
}

/// Styles, mixings, colours, paper and lifts, each with each; and fades.
inline std::vector<SceneKind> gradientKinds()
{
    std::vector<SceneKind> kinds;
    for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
        for (int i = 0; i < 16; ++i) {
            SceneKind kind;
            kind.style = style, kind.pigment = i & 1, kind.oneColour = !(i & 2), kind.paper = i & 4;
            kind.lifts = (i & 8) && style != StyleKind::Edge;
            kind.turnedView = kind.pigment;
            kinds.push_back(kind);
        }
    for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
        for (int i = 0; i < 4; ++i) {
            SceneKind kind;
            kind.style = style, kind.fades = true, kind.oneColour = !(i & 1), kind.paper = i & 2, kind.pigment = i == 1;
            kind.lifts = i == 3 && style != StyleKind::Edge;
            kinds.push_back(kind);
        }
    return kinds;
}

/// Draws a scene and goes back from a random loss, on the device and on the CPU.
inline void checkScene(CudaGradient &onDevice, FlatScene &scene, std::uint64_t seed)
{
    const int width = scene.view.width, height = scene.view.height;
    const auto loss = randomLoss<float>(seed, width, height);
    SceneGradient<float> onCpu;
    onCpu.choose(scene);
    const std::span<const float> expected = onCpu.draw(scene);
    onDevice.choose(scene);
    std::vector<float> picture;
    QVERIFY(!onDevice.draw(scene));
    QVERIFY(!onDevice.fetchPicture(picture));
    const double apart = greatestDifference(expected, picture);
    QVERIFY2(apart < 2e-4, qPrintable(QString::number(apart)));
    const FlatGradient &by = onCpu.backward(loss);
    QVERIFY(!onDevice.backward(loss));
    const double distance = relativeDistance(scene, by, onDevice.gradient());
    QVERIFY2(distance < 1e-3, qPrintable(QString::number(distance)));
    const FlatGradient first = onDevice.gradient();
    QVERIFY(!onDevice.backward(loss));
    QVERIFY(sameBits(first, onDevice.gradient()));
}

inline void checkGradientKinds(const OpenDevice &open, int strokes, int width, int height)
{
    CudaGradient onDevice(open());
    std::uint64_t seed = 0;
    for (const SceneKind &kind : gradientKinds()) {
        FlatScene scene = randomScene(++seed, strokes, width, height, kind);
        scene.byXi = seed % 5 != 0;
        checkScene(onDevice, scene, seed);
        if (QTest::currentTestFailed()) {
            qWarning("style %d, mixing %d, varying %d, paper %d, lifts %d, fades %d", int(kind.style), kind.pigment,
                     !kind.oneColour, kind.paper, kind.lifts, kind.fades);
            return;
        }
    }
}

/// Strokes of which many lie over each other, very wide ones, and long ones.
inline void checkGradientExtremes(const OpenDevice &open)
{
    CudaGradient onDevice(open());
    SceneKind deep, wide, many;
    deep.least = 3;
    wide.least = 40, wide.greatest = 60, wide.length = 30;
    many.segments = 25, many.least = 1.2, many.greatest = 2;
    FlatScene scenes[] = {randomScene(1, 150, 16, 16, deep), randomScene(2, 3, 150, 130, wide),
                          randomScene(3, 4, 48, 48, many), randomScene(4, 0, 20, 20, {})};
    for (FlatScene &scene : scenes) {
        checkScene(onDevice, scene, 5);
        if (QTest::currentTestFailed())
            return;
    }
}

/// The loss against a target that stays on the device.
inline void checkTargetLoss(const OpenDevice &open, int strokes, int width, int height)
{
    FlatScene scene = randomScene(7, strokes, width, height, {}), other = randomScene(8, strokes, width, height, {});
    SceneGradient<float> onCpu;
    onCpu.choose(other);
    const std::span<const float> drawn = onCpu.draw(other);
    const std::vector<float> target(drawn.begin(), drawn.end());
    CudaGradient onDevice(open());
    QVERIFY(!onDevice.setTarget(target));
    onDevice.choose(scene), onCpu.choose(scene);
    const FlatGradient &by =
        onCpu.drawAndDifferentiate(scene, [&](std::size_t first, std::size_t count, const float *rgb, float *out) {
            for (std::size_t i = 0; i < 3 * count; ++i)
                out[i] = 2 * (rgb[i] - target[3 * first + i]);
        });
    double loss = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
        loss += std::pow(double(onCpu.picture()[i]) - double(target[i]), 2);
    QVERIFY(!onDevice.drawAndDifferentiate(scene));
    QVERIFY(relativeDistance(scene, by, onDevice.gradient()) < 1e-3);
    QVERIFY(std::abs(onDevice.loss() - loss) < 1e-4 * loss);
    const FlatGradient first = onDevice.gradient();
    const double firstLoss = onDevice.loss();
    // Other work in between changes nothing.
    onDevice.choose(other);
    QVERIFY(!onDevice.drawAndDifferentiate(other, true));
    QVERIFY(onDevice.loss() < 1e-3 * loss);
    onDevice.choose(scene);
    QVERIFY(!onDevice.drawAndDifferentiate(scene, true));
    QVERIFY(sameBits(first, onDevice.gradient()));
    QCOMPARE(onDevice.loss(), firstLoss);
    std::vector<float> picture;
    QVERIFY(!onDevice.fetchPicture(picture));
    QVERIFY(greatestDifference(onCpu.picture(), picture) < 2e-4);
}

} // namespace suffuse::test
