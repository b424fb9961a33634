// What draws while a device starts, and what a program that draws once chooses.
#include "render/backends.h"
#include "render/starting_renderer.h"
#include "tests/render/paintings.h"

#include <future>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Stands for a device: the CPU's renderer under another name.
class Device : public Renderer {
public:
    Backend backend() const override { return Backend::Cuda; }
    QString deviceName() const override { return QStringLiteral("a device"); }
    Result<RenderStats> render(const RenderRequest &request, Target &target, const std::atomic<bool> *cancel) override
    {
        return m_cpu->render(request, target, cancel);
    }
    void invalidate() override { m_cpu->invalidate(); }

private:
    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);
};

using Made = Result<std::unique_ptr<Renderer>>;

} // namespace

class TestStarting : public QObject {
    Q_OBJECT

    const PaintingPtr m_painting =
        painting({stroke(1, Shape::Curved, {20, 40}, 60, 6, styleOf(StyleKind::Edge))}, 120, 90);

    RenderRequest request() const
    {
        return {m_painting, m_painting->end(), View::ofArea(m_painting->canvas.area(), 120, 90)};
    }

private slots:
    void theCpuDrawsUntilTheDeviceIsThere()
    {
        std::promise<void> mayStart;
        std::promise<void> started;
        StartingRenderer renderer(make(Backend::Cpu), [&]() -> Made {
            mayStart.get_future().wait();
            started.set_value_at_thread_exit();
            return std::unique_ptr<Renderer>(std::make_unique<Device>());
        });
        FloatPicture picture;
        const auto first = renderer.render(request(), picture);
        QVERIFY(first);
        QCOMPARE(renderer.backend(), Backend::Cpu);
        QCOMPARE(picture.rgba, test::render(*make(Backend::Cpu), m_painting, request().view).rgba);
        QCOMPARE(renderer.render(request(), picture)->tilesEvaluated, 0);

        mayStart.set_value();
        started.get_future().wait();
        const auto isDevice = [&] {
            const auto stats = renderer.render(request(), picture);
            return stats && renderer.backend() == Backend::Cuda;
        };
        QTRY_VERIFY(isDevice());
        QCOMPARE(renderer.deviceName(), QStringLiteral("a device"));
        QCOMPARE(renderer.notice(), QString());
    }

    /// The device draws its first picture whole, so that no picture is of both.
    void aPictureIsOfOneBackend()
    {
        std::promise<void> started;
        StartingRenderer renderer(make(Backend::Cpu), [&]() -> Made {
            started.set_value_at_thread_exit();
            return std::unique_ptr<Renderer>(std::make_unique<Device>());
        });
        started.get_future().wait();
        FloatPicture picture;
        int whole = 0;
        const auto isDevice = [&] {
            const auto stats = renderer.render(request(), picture);
            whole += stats && renderer.backend() == Backend::Cuda && stats->tilesEvaluated == stats->tiles;
            return renderer.backend() == Backend::Cuda;
        };
        QTRY_VERIFY(isDevice());
        QCOMPARE(whole, 1);
    }

    void withoutADeviceTheCpuGoesOnAndSaysWhy()
    {
        std::promise<void> failed;
        StartingRenderer renderer(make(Backend::Cpu), [&]() -> Made {
            failed.set_value_at_thread_exit();
            return Error{QStringLiteral("CUDA: there is no GPU")};
        });
        failed.get_future().wait();
        FloatPicture picture;
        const auto isSaid = [&] {
            return renderer.render(request(), picture).operator bool() && !renderer.notice().isEmpty();
        };
        QTRY_VERIFY(isSaid());
        QCOMPARE(renderer.notice(), QStringLiteral("CUDA: there is no GPU"));
        QCOMPARE(renderer.backend(), Backend::Cpu);
    }

    /// Whoever ends while a device starts waits for it, and for nothing else.
    void endsWhileItStarts()
    {
        std::atomic<bool> made = false;
        {
            StartingRenderer renderer(make(Backend::Cpu), [&]() -> Made {
                made = true;
                return std::unique_ptr<Renderer>(std::make_unique<Device>());
            });
        }
        QVERIFY(made);
    }

    void aSmallPictureIsNotWorthStartingADevice()
    {
        std::mt19937_64 random(7);
        const auto p = painting(randomStrokes(random, 200, 1024, 768), 1024, 768);
        const auto at = [&](int width) {
            return RenderRequest{p, p->end(), View::ofArea(p->canvas.area(), width, width * 3 / 4)};
        };
        const RendererOptions two{.threads = 2};
        QCOMPARE(quickestBackend(at(512), 1, two), Backend::Cpu);
        QCOMPARE(quickestBackend(at(16384), 1, two), Backend::Auto);
        QCOMPARE(quickestBackend(at(1024), 10'000, two), Backend::Auto);
        // A part of the canvas without paint costs no more than its pixels.
        const RenderRequest beside{p, p->end(), View{{1e5, 1e5}, 1, 0, false, 1024, 768}};
        QCOMPARE(quickestBackend(beside, 1, two), Backend::Cpu);
    }
};

QTEST_GUILESS_MAIN(TestStarting)
#include "test_starting.moc"
