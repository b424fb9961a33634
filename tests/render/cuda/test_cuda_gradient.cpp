// The gradient of the picture as a GPU finds it, without a GPU: its programs on the host (docs/cuda.md).
#include "render/cuda/cuda_differentiator.h"
#include "render/cuda/device/failing_device.h"
#include "render/fitting/picture_metrics.h"
#include "tests/render/cuda/emulated_device.h"
#include "tests/render/cuda/gradient_checks.h"
#include "tests/render/fitting/fitted_pictures.h"

using namespace suffuse;
using namespace suffuse::test;

class TestCudaGradient : public QObject {
    Q_OBJECT

    static std::shared_ptr<cuda::Device> open() { return std::make_shared<EmulatedDevice>(); }
    static std::shared_ptr<cuda::Device> openLate()
    {
        return std::make_shared<EmulatedDevice>(std::size_t(1) << 30, EmulatedDevice::Timing::Late);
    }

    /// A short fit whose gradients a device finds; null: the CPU does. Returns how near it comes, in dB.
    static double fitOn(std::shared_ptr<cuda::Device> device, bool weighted, QString *notice = nullptr,
                        fitting::FittedStrokes *strokes = nullptr)
    {
        fitting::FitTarget target = landscape(32, 24);
        if (weighted) {
            target.weight = fitting::FitPicture(32, 24, 1);
            std::fill(target.weight.values.begin(), target.weight.values.end(), 0.5f);
        }
        fitting::FitOptions options;
        options.strokes = 6, options.steps = 40;
        std::shared_ptr<gradient::Differentiator> differentiator;
        if (device)
            differentiator = std::make_shared<CudaDifferentiator>(std::move(device), Threads(1));
        fitting::Fitting fit(target, options, differentiator);
        while (fit.step()) {}
        if (notice)
            *notice = fit.differentiator().notice();
        if (strokes)
            *strokes = fit.strokes();
        return fitting::peakRatio(fit.meanSquareError());
    }

private slots:
    void fitsOnADevice()
    {
        for (const bool weighted : {false, true}) {
            fitting::FittedStrokes first, second;
            QString notice;
            const double onCpu = fitOn(nullptr, weighted), onDevice = fitOn(open(), weighted, &notice, &first);
            QVERIFY2(onDevice > 20 && std::abs(onDevice - onCpu) < 1,
                     qPrintable(QStringLiteral("%1 and %2 dB").arg(onDevice).arg(onCpu)));
            QVERIFY(notice.isEmpty());
            (void)fitOn(open(), weighted, nullptr, &second);
            QCOMPARE(first.strokes, second.strokes);
            QCOMPARE(first.births, second.births);
        }
    }

    void fitsGoOnWithoutTheDevice()
    {
        const double onCpu = fitOn(nullptr, false);
        for (const int call : {1, 20, 100, 500}) {
            QString notice;
            const double ratio = fitOn(std::make_shared<cuda::FailingDevice>(std::make_unique<EmulatedDevice>(),
                                                                             cuda::PlannedFault{call, cuda::Fault::Lost}),
                                       false, &notice);
            QVERIFY2(std::abs(ratio - onCpu) < 1, qPrintable(QStringLiteral("call %1: %2 dB").arg(call).arg(ratio)));
            QVERIFY2(!notice.isEmpty(), qPrintable(QString::number(call)));
        }
    }

    void kindsAgreeWithTheCpu() { checkGradientKinds(open, 6, 43, 30); }
    void extremesAgreeWithTheCpu() { checkGradientExtremes(open); }
    void targetLoss() { checkTargetLoss(open, 8, 50, 40); }
    void targetLossOnAStream() { checkTargetLoss(openLate, 8, 50, 40); }

    void targetOfAnotherSizeIsRefused()
    {
        const FlatScene scene = randomScene(1, 2, 20, 20, {});
        CudaGradient onDevice(open());
        onDevice.choose(scene);
        QVERIFY(!onDevice.setTarget(std::vector<float>(19 * 20 * 3)));
        QCOMPARE(onDevice.drawAndDifferentiate(scene).kind, cuda::Fault::Refused);
        QVERIFY(!onDevice.setTarget(std::vector<float>(20 * 20 * 3)));
        QVERIFY(!onDevice.drawAndDifferentiate(scene));
    }

    void fillsAreRefused()
    {
        FlatScene scene = randomScene(1, 2, 20, 20, {});
        scene.strokes[1].filled = true;
        QVERIFY(!CudaGradient::canDraw(scene));
        CudaGradient onDevice(open());
        onDevice.choose(scene);
        QCOMPARE(onDevice.draw(scene).kind, cuda::Fault::Refused);
    }

    void anyCallMayFail_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("lost") << int(cuda::Fault::Lost);
        QTest::newRow("out of memory") << int(cuda::Fault::OutOfMemory);
    }
    void anyCallMayFail()
    {
        QFETCH(int, kind);
        SceneKind paper;
        paper.paper = true;
        const FlatScene scene = randomScene(3, 2, 20, 20, paper);
        const std::vector<float> target(20 * 20 * 3, 0.5f);
        const auto work = [&](CudaGradient &gradient) {
            gradient.choose(scene);
            cuda::Fault fault = gradient.setTarget(target);
            if (!fault)
                fault = gradient.drawAndDifferentiate(scene);
            return fault;
        };
        CudaGradient sound(open());
        QVERIFY(!work(sound));
        const auto counting =
            std::make_shared<cuda::FailingDevice>(std::make_unique<EmulatedDevice>(), cuda::PlannedFault{});
        CudaGradient counted(counting);
        QVERIFY(!work(counted));
        const int calls = counting->calls();
        QVERIFY(calls > 20);
        for (int n = 1; n <= calls; ++n) {
            CudaGradient failing(std::make_shared<cuda::FailingDevice>(std::make_unique<EmulatedDevice>(),
                                                                       cuda::PlannedFault{n, cuda::Fault::Kind(kind)}));
            const bool fails = bool(work(failing));
            // Where memory runs out fewer warps draw.
            QVERIFY2(fails || kind == cuda::Fault::OutOfMemory, qPrintable(QString::number(n)));
            if (kind != cuda::Fault::OutOfMemory)
                continue;
            QVERIFY2(!work(failing), qPrintable(QString::number(n)));
            QVERIFY2(sameBits(failing.gradient(), sound.gradient()), qPrintable(QString::number(n)));
        }
    }
};

QTEST_GUILESS_MAIN(TestCudaGradient)
#include "test_cuda_gradient.moc"
