// The CUDA renderer behind the canvas, on a device in memory: pictures stay there or come back as they are wanted, and
// whichever call fails, the picture that was asked for is shown.
#include "render/cpu/cpu_renderer.h"
#include "render/cuda/cuda_renderer.h"
#include "render/cuda/device/failing_device.h"
#include "render/fallback_renderer.h"
#include "tests/app/worker_frames.h"
#include "tests/render/cuda/emulated_device.h"

#include <algorithm>

using namespace suffuse;

namespace {

/// A renderer on a device with this fault, which `made` then points to.
MakeRenderer makerWith(cuda::PlannedFault fault, std::weak_ptr<cuda::FailingDevice> *made = nullptr)
{
    return [=](const RendererOptions &options) -> Result<std::unique_ptr<Renderer>> {
        const auto device = std::make_shared<cuda::FailingDevice>(std::make_unique<test::EmulatedDevice>(), fault);
        if (made)
            *made = device;
        auto renderer = std::make_unique<CudaRenderer>(std::vector<std::shared_ptr<cuda::Device>>{device}, 1);
        return std::unique_ptr<Renderer>(std::make_unique<FallbackRenderer>(std::move(renderer), [options] {
            return std::make_unique<CpuRenderer>(options.threads, options.tileSize);
        }));
    };
}

enum Place { Nowhere, InMemory, OnDevice };

/// Where the shown frame is, if it is the picture but for a level a channel.
Place placeOf(FrameThread &worker, const Pixels<std::uint32_t> &pixels)
{
    Place place = Nowhere;
    worker.withFrame([&](ShownFrame &frame) {
        const auto near = [](std::uint32_t a, std::uint32_t b) {
            for (int shift = 0; shift < 32; shift += 8)
                if (std::abs(int(a >> shift & 255) - int(b >> shift & 255)) > 1)
                    return false;
            return true;
        };
        if (frame.width() * frame.height() != int(pixels.size()))
            return;
        // The emulated device's memory is the host's, and what is shown was just rendered.
        const std::uint32_t *shown =
            frame.device ? static_cast<CudaFrame &>(*frame.device).picture() : frame.picture.argb.data();
        if (std::equal(pixels.begin(), pixels.end(), shown, near))
            place = frame.device ? OnDevice : InMemory;
    });
    return place;
}

} // namespace

class TestCudaCanvas : public QObject {
    Q_OBJECT

private slots:
    void picturesAreWhereTheyAreWanted()
    {
        FrameThread worker({.threads = 1}, makerWith({}));
        float density = 20;
        for (const bool onDevice : {false, true, true, false, false, true}) {
            worker.setDeviceFramesWanted(onDevice);
            const RenderRequest r = request(density += 5);
            const FrameInfo info = draw(worker, r);
            QCOMPARE(info.error, QString());
            QCOMPARE(info.notice, QString());
            QCOMPARE(info.backendText, QString("CUDA · emulated"));
            QCOMPARE(placeOf(worker, pixelsOf(r)), onDevice ? OnDevice : InMemory);
        }
    }

    void whicheverCallFails_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("lost") << int(cuda::Fault::Lost);
        QTest::newRow("out of memory") << int(cuda::Fault::OutOfMemory);
    }

    void whicheverCallFails()
    {
        QFETCH(int, kind);
        const RenderRequest requests[] = {request(30), request(50), request(50, width + 40)};
        std::vector<Pixels<std::uint32_t>> pictures;
        for (const RenderRequest &r : requests)
            pictures.push_back(pixelsOf(r));
        int call = 1;
        for (bool failed = true; failed; ++call) {
            std::weak_ptr<cuda::FailingDevice> device;
            FrameThread worker({.threads = 1}, makerWith({call, cuda::Fault::Kind(kind)}, &device));
            worker.setDeviceFramesWanted(true);
            FrameInfo info;
            failed = false;
            for (std::size_t i = 0; i < std::size(requests); ++i) {
                info = draw(worker, requests[i]);
                QVERIFY2(info.error.isEmpty(), qPrintable(QStringLiteral("call %1: %2").arg(call).arg(info.error)));
                QVERIFY2(placeOf(worker, pictures[i]) != Nowhere, qPrintable(QStringLiteral("call %1").arg(call)));
                const auto alive = device.lock();
                failed |= !alive || alive->calls() >= call;
            }
            if (failed && kind == cuda::Fault::Lost) { // whoever fails, the CPU draws and says so
                QVERIFY2(info.backendText.startsWith("CPU · "), qPrintable(QStringLiteral("call %1").arg(call)));
                QVERIFY(!info.notice.isEmpty());
            }
        }
        QVERIFY(call > 10);
    }
};

QTEST_MAIN(TestCudaCanvas)
#include "test_cuda_canvas.moc"
