// The CUDA renderer on an emulated device: the kernels' programs and all of the host side, without a GPU.
#include "tests/render/cuda_checks.h"
#include "tests/render/emulated_device.h"

using namespace suffuse;
using namespace suffuse::test;

class TestCudaEmulated : public QObject {
    Q_OBJECT

    static std::shared_ptr<cuda::Device> open() { return std::make_shared<EmulatedDevice>(); }

private slots:
    void pictures() { checkPictures(open); }
    void kinds() { checkKinds(open); }
    void dirtyIsFull() { checkDirtyIsFull(open, 60); }
    void growingStroke() { checkGrowingStroke(open); }
    void layers() { checkLayers(open); }
    void targetsAndCulling() { checkTargetsAndCulling(open); }
    void deviceFrames() { checkDeviceFrames(open); }
    void cancelling() { checkCancelling(open); }

    /// What is uploaded for an edit does not grow with the painting.
    void onlyWhatChangedIsUploaded()
    {
        const auto device = std::make_shared<EmulatedDevice>();
        CudaRenderer renderer({device}, 1);
        std::mt19937_64 random(41);
        std::size_t edits[2];
        for (const int count : {40, 400}) {
            auto p = painting(randomStrokes(random, count, 64, 48), 64, 48);
            const View view = View::ofArea(p->canvas.area(), 64, 48);
            FloatPicture picture;
            QVERIFY(renderer.render({p, p->end(), view}, picture));
            p = withDensity(p, 20, 1.02);
            device->counts = {};
            QVERIFY(renderer.render({p, p->end(), view, false, true}, picture));
            edits[count > 40] = device->counts.uploaded;
            QVERIFY(device->counts.tiles > 0);
        }
        QVERIFY2(edits[1] < 2 * edits[0] + 2000, qPrintable(QStringLiteral("%1, %2").arg(edits[0]).arg(edits[1])));
    }

    /// Tiles of plain strokes take the plain kernel; while a value is dragged layers spare the other strokes.
    void layersAndPlainTilesAreUsed()
    {
        const auto device = std::make_shared<EmulatedDevice>();
        CudaRenderer renderer({device}, 1);
        std::vector<Stroke> strokes;
        for (int i = 0; i < 5; ++i)
            strokes.push_back(
                stroke(StrokeId(i + 1), Shape::Straight, {40, 20.0 + 4 * i}, 30, 4, styleOf(StyleKind(i % 3))));
        auto p = painting(strokes, 80, 60);
        const View view = View::ofArea(p->canvas.area(), 80, 60);
        FloatPicture picture;
        for (int step = 0; step < 3; ++step) {
            device->counts = {};
            const auto stats = renderer.render({p, p->end(), view, false, true}, picture);
            QVERIFY(stats);
            QCOMPARE(device->counts.plainTiles, step == 1 ? 0u : device->counts.tiles); // then it stores a map
            QCOMPARE(device->counts.haveUnder, step < 2 ? 0u : device->counts.tiles);
            QCOMPARE(device->counts.applyOver, step < 2 ? 0u : device->counts.tiles);
            p = withDensity(p, 2, 0.99);
        }
    }

    /// Lists that are too short are made again, longer.
    void manyStrokesInOnePlace()
    {
        const auto device = std::make_shared<EmulatedDevice>();
        CudaRenderer renderer({device}, 1);
        std::mt19937_64 random(43);
        const auto p = painting(randomStrokes(random, 700, 32, 32), 32, 32);
        const View view = View::ofArea(p->canvas.area(), 32, 32);
        const FloatPicture picture = test::render(renderer, p, view);
        QVERIFY(device->counts.longestList > 256);
        QVERIFY(device->counts.runs > 1);
        compare8(picture, test::render(*make(Backend::Cpu), p, view), "many strokes");
    }

    void severalDevicesGiveTheSameBits()
    {
        std::mt19937_64 random(47);
        auto p = painting(randomStrokes(random, 12, 100, 300), 100, 300);
        const View view = View::ofArea(p->canvas.area(), 100, 300);
        CudaRenderer one({open()}, 1), three({open(), open(), open()}, 2);
        FloatPicture a, b;
        for (int step = 0; step < 4; ++step) {
            QVERIFY(one.render({p, p->end(), view}, a));
            QVERIFY(three.render({p, p->end(), view}, b));
            QVERIFY2(a.rgba == b.rgba, qPrintable(QStringLiteral("step %1").arg(step)));
            p = withDensity(p, std::size_t(step) * 2, 0.9);
        }
    }
};

QTEST_GUILESS_MAIN(TestCudaEmulated)
#include "test_cuda_emulated.moc"
