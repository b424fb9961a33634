// Whichever call of the device fails: the picture comes from the CPU, bit for bit, and the notice says why.
#include "render/cuda/device/failing_device.h"
#include "render/fallback_renderer.h"
#include "tests/render/cuda/cuda_checks.h"
#include "tests/render/cuda/emulated_device.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

class TestCudaFaults : public QObject {
    Q_OBJECT

    const View m_view = View::ofArea(Rect::of(0, 0, 60, 40), 60, 40);
    PaintingPtr m_painting;

    struct Session {
        std::shared_ptr<cuda::FailingDevice> device;
        std::unique_ptr<FallbackRenderer> renderer;
    };
    static Session open(cuda::PlannedFault fault, std::size_t memory = std::size_t(1) << 30,
                        std::size_t worthwhile = cuda::DeviceNodes::usuallyWorthwhile)
    {
        Session s;
        auto late = std::make_unique<EmulatedDevice>(memory, EmulatedDevice::Timing::Late);
        s.device = std::make_shared<cuda::FailingDevice>(std::move(late), fault);
        auto cuda = std::make_unique<CudaRenderer>(std::vector<std::shared_ptr<cuda::Device>>{s.device}, 1, true,
                                                   cuda::ApartLimits{}, worthwhile);
        s.renderer = std::make_unique<FallbackRenderer>(std::move(cuda), [] { return make(Backend::Cpu, 1); });
        return s;
    }

    /// A full picture, a drag and its end, into float and 8 bit.
    template <class Picture, class Check>
    void drag(Session &s, Check check) const
    {
        Picture picture;
        PaintingPtr p = m_painting;
        for (int step = 0; step < 5; ++step) {
            const RenderRequest request{p, p->end(), m_view, false, step > 0 && step < 4};
            QVERIFY(s.renderer->render(request, picture));
            check(request, picture);
            p = withDensity(p, 2, 0.95);
        }
    }

    static bool isCpu(const RenderRequest &request, const FloatPicture &picture)
    {
        return picture.rgba == test::render(*make(Backend::Cpu), request.painting, request.view).rgba;
    }

private slots:
    void initTestCase()
    {
        std::mt19937_64 random(3);
        std::vector<Stroke> strokes = randomStrokes(random, 6, 60, 40);
        strokes.push_back(randomFill(random, 100, 60, 40, 3));
        m_painting = painting(strokes, 60, 40, {PaperKind::Procedural, 5, 20, 0.8f, {}});
    }

    void withoutFaultItStaysCuda()
    {
        Session s = open({});
        drag<FloatPicture>(s, [&](const RenderRequest &request, const FloatPicture &picture) {
            compare8(picture, test::render(*make(Backend::Cpu), request.painting, request.view), "no fault");
        });
        QCOMPARE(s.renderer->backend(), Backend::Cuda);
        QVERIFY(s.renderer->notice().isEmpty());
        QVERIFY(s.device->calls() > 40);
    }

    void everyCallMayBeTheLast()
    {
        Session whole = open({});
        drag<FloatPicture>(whole, [](const RenderRequest &, const FloatPicture &) {});
        const int calls = whole.device->calls();
        for (int n = 1; n <= calls; ++n) {
            if (!isTried(n))
                continue;
            Session s = open({n, cuda::Fault::Lost});
            drag<FloatPicture>(s, [&](const RenderRequest &request, const FloatPicture &picture) {
                if (s.renderer->backend() == Backend::Cpu && !request.interactive)
                    QVERIFY2(isCpu(request, picture), qPrintable(QStringLiteral("call %1").arg(n)));
            });
            QCOMPARE(s.renderer->backend(), Backend::Cpu);
            QCOMPARE(s.renderer->notice(),
                     QStringLiteral("CUDA stopped: call %1 was made to fail. The CPU draws now.").arg(n));
        }
    }

    /// What is left of the memory suffices: with smaller buffers or without layers the picture stays the same.
    void everyCallMayFindMemoryFull()
    {
        Session whole = open({});
        std::vector<Pixels<float>> expected;
        drag<FloatPicture>(
            whole, [&](const RenderRequest &, const FloatPicture &picture) { expected.push_back(picture.rgba); });
        int survived = 0;
        for (int n = 1; n <= whole.device->calls(); ++n) {
            if (!isTried(n + 1))
                continue;
            Session s = open({n, cuda::Fault::OutOfMemory});
            std::size_t step = 0;
            drag<FloatPicture>(s, [&](const RenderRequest &request, const FloatPicture &picture) {
                const bool cpu = s.renderer->backend() == Backend::Cpu;
                if (!request.interactive)
                    QVERIFY2(cpu ? isCpu(request, picture) : picture.rgba == expected[step],
                             qPrintable(QStringLiteral("call %1").arg(n)));
                ++step;
            });
            survived += s.renderer->backend() == Backend::Cuda;
        }
        QVERIFY(survived > 0);
    }

    /// The same where the device builds nodes. What it cannot build the host does, with the same bits.
    void nodesThatTheDeviceDoesNotBuild()
    {
        constexpr std::size_t always = 0, memory = std::size_t(1) << 30;
        Session whole = open({}, memory, always), byHost = open({}, memory, SIZE_MAX);
        std::vector<Pixels<float>> expected;
        const auto keep = [&](const RenderRequest &, const FloatPicture &picture) { expected.push_back(picture.rgba); };
        drag<FloatPicture>(byHost, keep);
        for (int n = 0; n <= whole.device->calls(); ++n) {
            if (n > 0 && !isTried(n))
                continue;
            Session s = open({n, n % 2 ? cuda::Fault::Lost : cuda::Fault::OutOfMemory}, memory, always);
            std::size_t step = 0;
            drag<FloatPicture>(n == 0 ? whole : s, [&](const RenderRequest &request, const FloatPicture &picture) {
                const bool cpu = s.renderer->backend() == Backend::Cpu;
                if (!request.interactive)
                    QVERIFY2(cpu ? isCpu(request, picture) : picture.rgba == expected[step],
                             qPrintable(QStringLiteral("call %1").arg(n)));
                ++step;
            });
            QVERIFY(n == 0 || n % 2 == 0 || s.renderer->backend() == Backend::Cpu);
        }
    }

    /// Ever less memory: first it goes without layers, then tile by tile, at last the CPU draws.
    void littleMemory()
    {
        const auto p = painting({stroke(1, Shape::Curved, {200, 150}, 180, 6, styleOf(StyleKind::Uniform))}, 400, 300);
        const View view = View::ofArea(p->canvas.area(), 400, 300);
        Session roomy = open({});
        const FloatPicture expected = test::render(*roomy.renderer, p, view);
        const int once = roomy.device->calls();
        int halved = 0;
        for (std::size_t memory = std::size_t(1) << 22; memory > 1000; memory /= 2) {
            Session s = open({}, memory);
            const FloatPicture picture = test::render(*s.renderer, p, view);
            if (s.renderer->backend() == Backend::Cuda) {
                QVERIFY(picture.rgba == expected.rgba);
                halved += s.device->calls() > once;
            } else {
                QVERIFY(picture.rgba == test::render(*make(Backend::Cpu), p, view).rgba);
                QCOMPARE(s.renderer->notice(), QStringLiteral("CUDA stopped: out of memory. The CPU draws now."));
            }
        }
        QVERIFY(halved > 0);
    }

    /// What another renderer could not draw either is an error, not a reason to leave the device.
    void badInputIsNoFault()
    {
        Session s = open({});
        auto p = std::make_shared<Painting>(*m_painting);
        p->canvas.paper = {PaperKind::Image, 1, 4, 1, std::make_shared<const QByteArray>("no image")};
        FloatPicture picture;
        QVERIFY(!s.renderer->render({p, p->end(), m_view}, picture));
        QCOMPARE(s.renderer->backend(), Backend::Cuda);
        QVERIFY(s.renderer->render({m_painting, m_painting->end(), m_view}, picture));
    }

    void plansFromTheEnvironment()
    {
        const auto callsUntil = [](const char *plan) {
            qputenv("SUFFUSE_CUDA_FAIL", plan);
            const auto device = cuda::failingIfAsked(std::make_unique<EmulatedDevice>());
            qunsetenv("SUFFUSE_CUDA_FAIL");
            std::vector<int> kinds;
            for (int i = 0; i < 4; ++i)
                kinds.push_back(device->finish(nullptr).kind);
            return kinds;
        };
        using cuda::Fault;
        QCOMPARE(callsUntil("2"), (std::vector<int>{Fault::None, Fault::Lost, Fault::Lost, Fault::Lost}));
        QCOMPARE(callsUntil("3:oom"), (std::vector<int>{Fault::None, Fault::None, Fault::OutOfMemory, Fault::None}));
    }
};

QTEST_GUILESS_MAIN(TestCudaFaults)
#include "test_cuda_faults.moc"
