// The methods that Suffuse is compared with draw the same picture.
#include "render/backends.h"
#include "render/bench/measure.h"
#include "tests/bench/baselines.h"
#include "tests/bench/cuda/paper_scene.h"
#include "tests/bench/small_painting.h"

#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

/// Small strokes so that 0.1 W reaches their whole spread, in soft styles that a pixel's width does not matter for.
PaintingPtr softPainting()
{
    bench::PaintingOptions o = smallOptions();
    o.spreadLow = 6;
    o.spreadHigh = 8;
    Painting painting = bench::makePainting(o);
    int index = 0;
    for (StrokePtr &place : painting.strokes) {
        Stroke stroke = *place;
        stroke.style = index++ % 2 == 0 ? Style{StyleKind::Uniform, {0.5f, 0.1f, 0}}
                                        : Style{StyleKind::Feathering, {1.1f, 1.5f, 0}};
        place = std::make_shared<const Stroke>(std::move(stroke));
    }
    return std::make_shared<const Painting>(std::move(painting));
}

RenderRequest requestFor(const PaintingPtr &painting)
{
    const bench::Job job = bench::jobOf(painting, int(painting->canvas.width), {}, makeRenderer);
    RenderRequest request;
    request.painting = job.painting;
    request.time = job.time;
    request.view = job.view;
    return request;
}

FloatPicture drawn(const RenderRequest &request)
{
    RendererOptions options;
    options.backend = Backend::Cpu;
    const auto renderer = makeRenderer(options);
    FloatPicture picture;
    if (!renderer || !(*renderer)->render(request, picture))
        return {};
    return picture;
}

struct Difference {
    double mean = 0;
    double largest = 0;
    double covered = 0; ///< share of the pixels that are not white
};

Difference difference(const std::vector<float> &a, const FloatPicture &b)
{
    Difference out;
    for (std::size_t i = 0; i < b.rgba.size(); i += 4) {
        double d = 0;
        for (std::size_t c = 0; c < 3; ++c)
            d = std::max(d, std::abs(double(a[i + c]) - double(b.rgba[i + c])));
        out.mean += d;
        out.largest = std::max(out.largest, d);
        out.covered += b.rgba[i] + b.rgba[i + 1] + b.rgba[i + 2] < 2.9;
    }
    const double pixels = double(b.width) * b.height;
    out.mean /= pixels;
    out.covered /= pixels;
    return out;
}

} // namespace

class TestBaselines : public QObject {
    Q_OBJECT

private slots:
    void paperMethodDrawsThePicture();
    void paperSceneHoldsTheSegments();
    void paperWorkCountsPixels();
    void paperOnDeviceDrawsThePicture();
    void finiteDifferencesDrawThePicture();
    void finiteDifferencesConverge();
};

void TestBaselines::paperMethodDrawsThePicture()
{
    const RenderRequest request = requestFor(softPainting());
    const FloatPicture picture = drawn(request);
    QCOMPARE(picture.width, 256);
    for (int nodes : {5, 8})
        for (int threads : {1, 2}) {
            const Difference d = difference(baseline::paperMethod(request, nodes, threads), picture);
            QVERIFY2(d.covered > 0.1, qPrintable(QString::number(d.covered)));
            // 0.1 W = 25.6 px is 3.2 to 4.3 s.
            QVERIFY2(d.mean < 0.002 && d.largest < 0.05,
                     qPrintable(QString("mean %1, largest %2").arg(d.mean).arg(d.largest)));
        }
    QVERIFY(baseline::paperMethod(request, 8, 1) == baseline::paperMethod(request, 8, 2));
}

void TestBaselines::paperSceneHoldsTheSegments()
{
    const RenderRequest request = requestFor(softPainting());
    for (int points : {5, 8}) {
        const baseline::PaperScene scene = baseline::paperScene(request, points);
        QCOMPARE(scene.curves.size(), request.painting->segmentCount());
        QCOMPARE(scene.quadratures.size(), scene.curves.size());
        QCOMPARE(scene.strokes.size(), request.painting->strokes.size());
        std::size_t next = 0;
        for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
            QCOMPARE(std::size_t(scene.strokes[i].firstSegment), next);
            for (std::size_t k = next; k < next + scene.strokes[i].segments; ++k)
                QCOMPARE(std::size_t(scene.quadratures[k].stroke), i);
            next += scene.strokes[i].segments;
        }
        QCOMPARE(next, scene.curves.size());
        for (std::size_t k = 0; k < scene.curves.size(); ++k)
            for (int i = 0; i < points; ++i) {
                const float *x = scene.curves[k].x, *y = scene.curves[k].y, p = scene.ruleX[i];
                const float onX = x[0] + p * (x[1] + p * (x[2] + p * x[3]));
                const float onY = y[0] + p * (y[1] + p * (y[2] + p * y[3]));
                QVERIFY(std::hypot(onX - scene.quadratures[k].x[i], onY - scene.quadratures[k].y[i]) < 1e-3f);
            }
    }
}

void TestBaselines::paperWorkCountsPixels()
{
    const RenderRequest request = requestFor(softPainting());
    const baseline::PaperWork eight = baseline::paperWork(request, 8), five = baseline::paperWork(request, 5);
    double pairs = 0;
    for (const baseline::QuadratureRecord &s : baseline::paperScene(request, 8).quadratures)
        for (int y = 0; y < request.view.height; ++y)
            for (int x = 0; x < request.view.width; ++x)
                pairs += std::hypot(x + 0.5 - double(s.middleX), y + 0.5 - double(s.middleY)) < double(s.reach);
    QVERIFY2(std::abs(eight.pairs - pairs) < 1e-4 * pairs, qPrintable(QString("%1 %2").arg(eight.pairs).arg(pairs)));
    QVERIFY(eight.port - five.port > 15 * pairs && eight.asWritten - five.asWritten > 90 * pairs);
}

void TestBaselines::paperOnDeviceDrawsThePicture()
{
    using baseline::PaperKernel;
    const RenderRequest request = requestFor(softPainting());
    std::string why;
    for (int points : {5, 8}) {
        const auto paper = baseline::paperOnDevice(baseline::paperScene(request, points), why);
        if (!paper)
            QSKIP(qPrintable(QString("no CUDA device: %1").arg(QString::fromStdString(why))));
        FloatPicture onCpu;
        onCpu.resize(request.view.width, request.view.height);
        const std::vector<float> drawn = baseline::paperMethod(request, points, 0);
        onCpu.rgba.assign(drawn.begin(), drawn.end());
        for (const auto &[kernel, polynomials] : {std::pair(PaperKernel::AsWritten, 0),
                                                  {PaperKernel::Port, 0},
                                                  {PaperKernel::Port, 1},
                                                  {PaperKernel::Port, 2}}) {
            QVERIFY2(paper->draw(kernel, polynomials, why) > 0, why.c_str());
            const std::vector<float> picture = paper->picture(why);
            QVERIFY2(picture.size() == onCpu.rgba.size(), why.c_str());
            const Difference d = difference(picture, onCpu);
            QVERIFY2(d.covered > 0.1 && d.mean < 1e-5 && d.largest < 1e-3,
                     qPrintable(QString("mean %1, largest %2").arg(d.mean).arg(d.largest)));
            QVERIFY(paper->draw(kernel, polynomials, why) > 0 && paper->picture(why) == picture);
        }
    }
}

void TestBaselines::finiteDifferencesDrawThePicture()
{
    const RenderRequest request = requestFor(softPainting());
    const FloatPicture picture = drawn(request);
    const Difference d = difference(baseline::finiteDifferences(request, 10, 2), picture);
    QVERIFY2(d.mean < 0.02 && d.largest < 0.3, qPrintable(QString("mean %1, largest %2").arg(d.mean).arg(d.largest)));
    QVERIFY(baseline::finiteDifferences(request, 10, 1) == baseline::finiteDifferences(request, 10, 2));
}

void TestBaselines::finiteDifferencesConverge()
{
    const RenderRequest request = requestFor(softPainting());
    const FloatPicture picture = drawn(request);
    double before = difference(baseline::finiteDifferences(request, 5, 2), picture).mean;
    for (int steps : {20, 80}) {
        const double mean = difference(baseline::finiteDifferences(request, steps, 2), picture).mean;
        QVERIFY2(mean < 0.5 * before, qPrintable(QString("%1 steps: %2 after %3").arg(steps).arg(mean).arg(before)));
        before = mean;
    }
}

QTEST_GUILESS_MAIN(TestBaselines)
#include "test_baselines.moc"
