// The CUDA renderer on a real GPU; skipped where there is none.
#include "tests/render/cuda/cuda_blending.h"
#include "tests/render/cuda/cuda_pictures.h"
#include "tests/render/cuda/gradient_checks.h"

using namespace suffuse;
using namespace suffuse::test;

class TestCudaDevice : public QObject {
    Q_OBJECT

    static std::shared_ptr<cuda::Device> open()
    {
        std::string why;
        std::shared_ptr<cuda::Device> device = cuda::openDevice(0, why);
        if (!device)
            qFatal("%s", why.c_str());
        return device;
    }

private slots:
    void initTestCase()
    {
        if (const cuda::Devices found = cuda::findDevices(); found.count == 0)
            QSKIP(qPrintable(whyNone(found)));
        qInfo("%s", open()->name().c_str());
    }

    void nodes() { checkNodes(open, 778); }
    void picturesByNodes() { checkPicturesByNodes(open); }
    void pictures() { checkPictures(open); }
    void kinds() { checkKinds(open); }
    void lifts() { checkLifts(open); }
    void fades() { checkFades(open); }
    void fills() { checkFills(open, 48); }
    void cornersOfCells() { checkCornersOfCells(open, 2000); }
    void fillEdits() { checkFillEdits(open, 80); }
    void dirtyIsFull() { checkDirtyIsFull(open, 200); }
    void growingStroke() { checkGrowingStroke(open); }
    void layers() { checkLayers(open); }
    void targetsAndCulling() { checkTargetsAndCulling(open); }
    void heavyTiles() { checkHeavyTiles(open, heavyPainting(5000), 34); } // 102 times for each way
    void heavyFills() { checkHeavyTiles(open, test::heavyFills(80), 7); }
    void blending() { checkBlending(open, 0, 60); }
    void blendingEdits() { checkBlendingEdits(open, 300); }
    void picturesAsPaint() { checkPicturesAsPaint(open, 0, 80); }
    void pictureEdits() { checkPictureEdits(open, 300); }
    void deviceFrames() { checkDeviceFrames(open); }
    void cancelling() { checkCancelling(open); }
    void gradients() { checkGradientKinds(open, 40, 203, 150); }
    void gradientExtremes() { checkGradientExtremes(open); }
    void gradientOfTheTargetLoss() { checkTargetLoss(open, 60, 250, 190); }

    void hundredTimesTheSameBits()
    {
        std::mt19937_64 random(53);
        const auto p =
            painting(randomStrokes(random, 300, 512, 384), 512, 384, {PaperKind::Procedural, 5, 20, 0.8f, {}});
        const View view = View::ofArea(p->canvas.area(), 512, 384);
        CudaRenderer cuda({open()}, 0);
        const FloatPicture first = test::render(cuda, p, view);
        for (int i = 0; i < 100; ++i)
            QVERIFY2(test::render(cuda, p, view).rgba == first.rgba, qPrintable(QString::number(i)));
    }
};

QTEST_GUILESS_MAIN(TestCudaDevice)
#include "test_cuda_device.moc"
