// Pictures of a film: those of single renders, whoever draws which; errors and cancelling end the work.
#include "render/backends.h"
#include "render/sequence.h"
#include "tests/render/paintings.h"

#include <mutex>
#include <set>

using namespace suffuse;
using namespace suffuse::test;

class TestSequence : public QObject {
    Q_OBJECT

    RenderRequest m_request;
    std::vector<Microseconds> m_moments;

    static std::vector<std::unique_ptr<Renderer>> renderers(int count)
    {
        std::vector<std::unique_ptr<Renderer>> out;
        for (int i = 0; i < count; ++i)
            out.push_back(make(Backend::Cpu));
        return out;
    }

private slots:
    void initTestCase()
    {
        std::mt19937_64 random(41);
        m_request.painting = painting(randomStrokes(random, 12, 120, 90), 120, 90);
        m_request.view = View::ofArea(Rect::of(0, 0, 120, 90), 120, 90);
        for (int i = 1; i <= 11; ++i)
            m_moments.push_back(m_request.painting->end() * i / 11);
    }

    void likeSinglePictures()
    {
        for (const int count : {1, 2, 3, 20})
            for (const int threads : {1, 4}) {
                std::mutex mutex;
                std::map<std::size_t, Pixels<float>> frames;
                const auto stats = renderSequence(renderers(count), m_request, m_moments, threads,
                                                  [&](std::size_t i, const FloatPicture &picture) {
                                                      const std::lock_guard lock(mutex);
                                                      frames[i] = picture.rgba;
                                                      return Result<void>();
                                                  });
                QVERIFY(stats);
                QVERIFY(stats->tilesEvaluated > 0 && stats->tilesEvaluated <= stats->tiles);
                QCOMPARE(frames.size(), m_moments.size());
                for (std::size_t i = 0; i < m_moments.size(); ++i)
                    QVERIFY(frames[i] ==
                            test::render(*make(Backend::Cpu), m_request.painting, m_request.view, m_moments[i]).rgba);
            }
    }

    /// Only what changed since a thread's last picture is copied for it, whichever thread waited how long.
    void likeSinglePicturesHoweverSlowlyTheyAreUsed()
    {
        std::vector<Microseconds> moments;
        for (int i = 1; i <= 40; ++i)
            moments.push_back(m_request.painting->end() * i / 40);
        std::mutex mutex;
        std::map<std::size_t, Pixels<float>> frames;
        const auto stats =
            renderSequence(renderers(1), m_request, moments, 5, [&](std::size_t i, const FloatPicture &picture) {
                if (i % 7 == 0)
                    QThread::msleep(20);
                const std::lock_guard lock(mutex);
                frames[i] = picture.rgba;
                return Result<void>();
            });
        QVERIFY(stats);
        QCOMPARE(frames.size(), moments.size());
        for (std::size_t i = 0; i < moments.size(); ++i)
            QVERIFY(frames[i] ==
                    test::render(*make(Backend::Cpu), m_request.painting, m_request.view, moments[i]).rgba);
    }

    void theFirstErrorEndsIt()
    {
        std::atomic<int> used = 0;
        const auto stats = renderSequence(renderers(2), m_request, m_moments, 1,
                                          [&](std::size_t, const FloatPicture &) -> Result<void> {
                                              if (++used >= 3)
                                                  return Error{QStringLiteral("the disk is full")};
                                              return {};
                                          });
        QVERIFY(!stats);
        QCOMPARE(stats.error(), QStringLiteral("the disk is full"));
        QVERIFY(used < int(m_moments.size()));
    }

    void cancelling()
    {
        std::atomic<bool> cancel = false;
        std::atomic<int> used = 0;
        const auto stats = renderSequence(
            renderers(1), m_request, m_moments, 1,
            [&](std::size_t, const FloatPicture &) {
                cancel = ++used == 4;
                return Result<void>();
            },
            &cancel);
        QVERIFY(!stats);
        QVERIFY(stats.error().isEmpty());
        QCOMPARE(used, 4);
    }

    void oneRendererForTheCpu()
    {
        const auto made = makeRenderers({.backend = Backend::Cpu, .devices = allDevices});
        QVERIFY(made);
        QCOMPARE(made->size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(TestSequence)
#include "test_sequence.moc"
