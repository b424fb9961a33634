// The CUDA renderer on an emulated device: the kernels' programs and all of the host side, without a GPU.
#include "model/formats/files.h"
#include "render/image_io/image_io.h"
#include "tests/render/cuda/cuda_blending.h"
#include "tests/render/cuda/cuda_pictures.h"
#include "tests/render/cuda/emulated_device.h"
#include "tests/trials.h"

#include <QFile>
#include <QTemporaryDir>

using namespace suffuse;
using namespace suffuse::test;

class TestCudaEmulated : public QObject {
    Q_OBJECT

    static constexpr std::size_t size = std::size_t(1) << 30; ///< bytes of a device's memory

    static std::shared_ptr<cuda::Device> open() { return std::make_shared<EmulatedDevice>(); }

private slots:
    void nodes() { checkNodes(open, 60); }
    void picturesByNodes() { checkPicturesByNodes(open); }
    void nodesOfSamples()
    {
        for (const char *name : {"flat", "ink-landscape", "moonrise", "still-life", "sheet"}) {
            const auto p = loadPainting(
                QStringLiteral(SUFFUSE_SOURCE_DIR "/packaging/samples/%1.suffuse").arg(QLatin1String(name)));
            QVERIFY2(p, p ? "" : qPrintable(p.error()));
            const auto device = std::make_shared<EmulatedDevice>();
            cuda::DeviceNodes nodes(device);
            const BuiltByDevice built = checkNodesOf(nodes, *p, p->end(), 0);
            qInfo("%s: %d of %d strokes, %zu segments left, %zu jobs", name, built.strokes, built.ofAll,
                  built.segmentsLeft, device->counts.nodeJobs);
            QCOMPARE(built.segmentsLeft, std::size_t(0));
        }
    }
    void pictures() { checkPictures(open); }
    void kinds() { checkKinds(open); }
    void lifts() { checkLifts(open); }
    void fades() { checkFades(open); }
    void fills() { checkFills(open, trials(5, 12)); }
    void cornersOfCells() { checkCornersOfCells(open, 120); }
    void fillEdits() { checkFillEdits(open, 14); }
    void dirtyIsFull() { checkDirtyIsFull(open, 60); }
    void growingStroke() { checkGrowingStroke(open); }
    void layers() { checkLayers(open); }
    void targetsAndCulling() { checkTargetsAndCulling(open); }
    void heavyTiles() { checkHeavyTiles(open, heavyPainting(5000), 1); }
    void heavyFills() { checkHeavyTiles(open, test::heavyFills(trials(8, 15)), 1); }
    void blending() { checkBlending(open, 41, 45); }
    void blendingEdits() { checkBlendingEdits(open, 30); }
    void picturesAsPaint() { checkPicturesAsPaint(open, 0, 6); }
    void pictureEdits() { checkPictureEdits(open, 30); }
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
        QVERIFY(device->counts.longestList > 128);
        QVERIFY(device->counts.runs > 1);
        compare8(picture, test::render(*make(Backend::Cpu), p, view), "many strokes");
    }

    /// Strokes of many nodes are evaluated apart from their tiles, and next time as well; where none costs much, none
    /// is.
    void costlyStrokesAreEvaluatedApart()
    {
        const auto device = std::make_shared<EmulatedDevice>();
        CudaRenderer renderer({device}, 1);
        const auto p = heavyPainting(20);
        const View view = View::ofArea(p->canvas.area(), 48, 36);
        const FloatPicture first = test::render(renderer, p, view);
        const std::size_t apart = device->counts.apart;
        QVERIFY(apart > 0);
        renderer.invalidate();
        QVERIFY(test::render(renderer, p, view).rgba == first.rgba);
        QCOMPARE(device->counts.apart, 2 * apart);
        const auto light = painting({stroke(1, Shape::Straight, {24, 18}, 15, 4, styleOf(StyleKind::Uniform))}, 48, 36);
        test::render(renderer, light, view);
        QCOMPARE(device->counts.apart, 2 * apart);
    }

    /// Where memory is short, strokes are evaluated with their tiles.
    void withoutRoomForStrokesApart()
    {
        const auto p = heavyPainting(20);
        const View view = View::ofArea(p->canvas.area(), 48, 36);
        CudaRenderer plenty({open()}, 1);
        const auto device = std::make_shared<EmulatedDevice>(std::size_t(900) << 10);
        CudaRenderer little({device}, 1);
        QVERIFY(test::render(little, p, view).rgba == test::render(plenty, p, view).rgba);
        QCOMPARE(device->counts.apart, 0u);
        QVERIFY(!little.isLost());
    }

    /// The paper's image as the CPU sees it, upright and turned.
    void imagePaper()
    {
        FloatPicture image;
        image.resize(5, 4);
        std::mt19937_64 random(59);
        for (float &v : image.rgba)
            v = float(random() % 256) / 255;
        const QTemporaryDir folder;
        const Result<void> written = writeImage(folder.filePath("paper.png"), image, {});
        QVERIFY2(written, qPrintable(written.error()));
        QFile file(folder.filePath("paper.png"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        CudaRenderer cuda({open()}, 0);
        const Paper paper{PaperKind::Image, 1, 6, 0.9f, std::make_shared<const QByteArray>(file.readAll())};
        const auto p = painting(randomStrokes(random, 8, 64, 48), 64, 48, paper);
        compareWithOthers(cuda, p, View::ofArea(p->canvas.area(), 64, 48), "image paper");
        compareWithOthers(cuda, p, {{30, 20}, 3, 0.7, true, 40, 30}, "image paper, turned");
        auto bare = std::make_shared<Painting>(*p);
        bare->canvas.paper = {};
        const View view = View::ofArea(p->canvas.area(), 64, 48);
        QVERIFY(test::render(cuda, p, view).rgba != test::render(cuda, bare, view).rgba);
    }

    /// Bands of tiles are stored while the next one is computed: nothing depends on when the device does its work.
    void bandsOverlap()
    {
        const auto late = [] { return std::make_shared<EmulatedDevice>(size, EmulatedDevice::Timing::Late); };
        std::vector<Stroke> strokes;
        for (int i = 0; i < 12; ++i)
            strokes.push_back(stroke(StrokeId(i + 1), allShapes[i % 4], {120.0 * i + 60, 130.0 * i + 60}, 20, 2,
                                     styleOf(StyleKind(i % 3))));
        auto p = painting(strokes, 1500, 1600);
        const View view = View::ofArea(p->canvas.area(), 1500, 1600);
        const auto device = late();
        CudaRenderer one({open()}, 1), overlapping({device}, 2), three({late(), late(), late()}, 2);
        FloatPicture a, b, c;
        for (int step = 0; step < 2; ++step) {
            for (auto &[renderer, picture] : {std::pair(&one, &a), std::pair(&overlapping, &b), std::pair(&three, &c)})
                QVERIFY(renderer->render({p, p->end(), view}, *picture));
            QVERIFY(a.rgba == b.rgba && a.rgba == c.rgba);
            QCOMPARE(device->counts.runs, step == 0 ? 2u : 3u);
            p = withDensity(p, 5, 0.8);
        }
    }

    void reasonsForNoDevice()
    {
        using cuda::NoDevice;
        QCOMPARE(whyNone({0, NoDevice::NoDriver, "version 1 < 2"}),
                 QStringLiteral("no NVIDIA driver, or one that is too old for this program (version 1 < 2)"));
        QCOMPARE(whyNone({}), QStringLiteral("this program was built without the CUDA renderer"));
        QVERIFY(whyNone({0, NoDevice::NoGpu, {}}) != whyNone({0, NoDevice::Failed, {}}));
    }

    void severalDevicesGiveTheSameBits()
    {
        std::mt19937_64 random(47);
        auto p = painting(randomStrokes(random, 12, 200, 300), 200, 300);
        const View view = View::ofArea(p->canvas.area(), 200, 300);
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
