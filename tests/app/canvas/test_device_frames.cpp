// Pictures that stay on a device: shown right, given up in order, replaced by the CPU's where the device fails.
#include "render/backends.h"
#include "tests/app/fake_device.h"
#include "tests/app/session.h"
#include "tests/app/worker_frames.h"

#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

enum Place { Nowhere, InMemory, OnDevice };

/// Where the shown frame is, if it has exactly these pixels.
Place placeOf(FrameThread &worker, const Pixels<std::uint32_t> &pixels)
{
    Place place = Nowhere;
    worker.withFrame([&](ShownFrame &frame) {
        if (frame.device && static_cast<FakeDeviceFrame &>(*frame.device).shown().argb == pixels)
            place = frame.picture.argb.empty() ? OnDevice : Nowhere;
        else if (!frame.device && frame.picture.argb == pixels)
            place = InMemory;
    });
    return place;
}

} // namespace

class TestDeviceFrames : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void framesAreWhereTheyAreWanted()
    {
        FakeDevice device;
        FrameThread worker({}, makerOn(device));
        const RenderRequest first = request(30), second = request(60);
        const auto firstPixels = pixelsOf(first), secondPixels = pixelsOf(second);
        QVERIFY(!firstPixels.empty() && firstPixels != secondPixels);

        QCOMPARE(draw(worker, first).error, QString());
        QCOMPARE(placeOf(worker, firstPixels), InMemory);
        worker.setDeviceFramesWanted(true);
        const FrameInfo info = draw(worker, second);
        QCOMPARE(placeOf(worker, secondPixels), OnDevice);
        QVERIFY(!info.stats.frame); // nobody but the worker may hold it
        QVERIFY(!info.stats.dirty.empty());
        QCOMPARE(info.backendText, QString("CUDA · Fake 1"));
        QCOMPARE(info.notice, QString());
        draw(worker, first);
        QCOMPARE(placeOf(worker, firstPixels), OnDevice);
        worker.setDeviceFramesWanted(false);
        draw(worker, first);
        QCOMPARE(placeOf(worker, firstPixels), InMemory);
        worker.setDeviceFramesWanted(true);
        draw(worker, first);
        QCOMPARE(placeOf(worker, firstPixels), OnDevice);
    }

    void anotherSizeIsAnotherFrame()
    {
        FakeDevice device;
        FrameThread worker({}, makerOn(device));
        worker.setDeviceFramesWanted(true);
        for (const int w : {width, width + 37, width - 50}) {
            const RenderRequest r = request(30, w);
            draw(worker, r);
            QCOMPARE(placeOf(worker, pixelsOf(r)), OnDevice);
            worker.withFrame([w](ShownFrame &frame) {
                QCOMPARE(frame.width(), w);
                QCOMPARE(frame.dirty, std::vector<PixelRect>({PixelRect{0, 0, w, height}}));
            });
            QCOMPARE(device.frames.load(), 1);
        }
    }

    void aPictureThatCannotBePublishedComesToMemory()
    {
        FakeDevice device;
        device.publishesUntilFailure = 1;
        FrameThread worker({}, makerOn(device));
        worker.setDeviceFramesWanted(true);
        const RenderRequest first = request(30), second = request(60);
        draw(worker, first);
        QCOMPARE(placeOf(worker, pixelsOf(first)), OnDevice);
        const FrameInfo info = draw(worker, second);
        QCOMPARE(info.error, QString());
        QCOMPARE(info.notice, QString("the device lost its picture"));
        QCOMPARE(placeOf(worker, pixelsOf(second)), InMemory);
        draw(worker, first); // and so do all after it
        QCOMPARE(placeOf(worker, pixelsOf(first)), InMemory);
        QCOMPARE(device.deviceFrames.load(), 2);
    }

    void theDeviceIsLeftByTheThreadThatUsedIt()
    {
        FakeDevice device;
        {
            FrameThread worker({}, makerOn(device));
            worker.setDeviceFramesWanted(true);
            draw(worker, request(30));
            draw(worker, request(30, width + 16));
            QCOMPARE(device.frames.load(), 1);
        }
        QCOMPARE(device.frames.load(), 0);
        QCOMPARE(device.strayEnds.load(), 0);
    }

    void aBackendThatCannotStartIsReplaced()
    {
        const RenderRequest r = request(30);
        FrameThread worker({.backend = Backend::Cuda, .threads = 1}, [](const RendererOptions &options) {
            return options.backend == Backend::Cpu
                       ? makeRenderer(options)
                       : Result<std::unique_ptr<Renderer>>(Error{QStringLiteral("there is no driver")});
        });
        worker.setDeviceFramesWanted(true);
        const FrameInfo info = draw(worker, r);
        QCOMPARE(info.error, QString());
        QCOMPARE(info.notice, QString("there is no driver"));
        QVERIFY2(info.backendText.startsWith("CPU · 1 thread"), qPrintable(info.backendText));
        QCOMPARE(placeOf(worker, pixelsOf(r)), InMemory);
    }

    void theStatusBarSaysWhatDrawsAndWhy()
    {
        FakeDevice device;
        Session s(makerOn(device));
        auto *backend = s.window.findChild<QLabel *>("backend");
        QVERIFY(backend);
        QTRY_COMPARE_WITH_TIMEOUT(backend->text(), QString("CUDA"), waitMs);
        QCOMPARE(s.window.statusBar()->currentMessage(), QString());
        QVERIFY2(backend->toolTip().endsWith("\nCUDA · Fake 1"), qPrintable(backend->toolTip()));

        const Painting before = s.painting();
        device.lost = true;
        s.canvas().setZoom(2);
        QTRY_COMPARE_WITH_TIMEOUT(backend->text(), QString("CPU"), waitMs);
        QVERIFY2(backend->toolTip().contains("\nCPU · "), qPrintable(backend->toolTip()));
        QVERIFY2(backend->toolTip().endsWith("\nCUDA stopped: it is lost"), qPrintable(backend->toolTip()));
        QVERIFY(s.window.statusBar()->currentMessage().contains("CUDA stopped: it is lost"));
        QCOMPARE(s.painting(), before);
        QVERIFY(!s.editor().isModified());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestDeviceFrames)
#include "test_device_frames.moc"
