// When the frames of a film are: in order, evenly, without the pauses, and the last one is the finished picture.
#include "model/timelapse.h"

#include <QTest>

using namespace suffuse;

class TestTimelapse : public QObject {
    Q_OBJECT

    /// One segment each, a second long.
    static Painting drawnAt(const std::vector<double> &seconds)
    {
        Painting painting;
        StrokeList strokes;
        for (std::size_t k = 0; k < seconds.size(); ++k) {
            Stroke stroke;
            stroke.id = k + 1;
            stroke.segments.resize(1);
            stroke.segments[0].maxAge = 1;
            stroke.segments[0].born = toMicroseconds(seconds[k]);
            strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        painting.strokes = strokes;
        return painting;
    }

private slots:
    void evenlyToTheEnd()
    {
        const Painting painting = drawnAt({0, 0.5, 1});
        const auto moments = timelapseMoments(painting, {.frames = 8, .idle = 0.5});
        QCOMPARE(moments.size(), std::size_t(8));
        for (std::size_t i = 0; i < 8; ++i)
            QCOMPARE(moments[i], Microseconds(250'000 * (i + 1)));
        QCOMPARE(moments.back(), painting.end());
    }

    void pausesAreCut()
    {
        // Drawn from 0 to 1 s and from 61 to 62 s: of the minute between, half a second is kept.
        const Painting painting = drawnAt({0, 61});
        const auto moments = timelapseMoments(painting, {.frames = 5, .idle = 0.5});
        const std::vector<Microseconds> expected = {500'000, 1'000'000, 1'500'000, 61'500'000, 62'000'000};
        QCOMPARE(moments, expected);
        const auto whole = timelapseMoments(painting, {.frames = 2, .idle = 1e6});
        QCOMPARE(whole, (std::vector<Microseconds>{31'000'000, 62'000'000}));
        const auto none = timelapseMoments(painting, {.frames = 4, .idle = 0});
        QCOMPARE(none, (std::vector<Microseconds>{500'000, 1'000'000, 61'500'000, 62'000'000}));
    }

    void ofOneFrameAndOfNothing()
    {
        const Painting painting = drawnAt({2});
        QCOMPARE(timelapseMoments(painting, {.frames = 1}), (std::vector<Microseconds>{3'000'000}));
        QCOMPARE(timelapseMoments({}, {.frames = 3}), (std::vector<Microseconds>{0, 0, 0}));
    }

    void neverBackwards()
    {
        const Painting painting = drawnAt({5, 0, 3.2, 3.1, 90, 17, 0.4});
        for (const int frames : {1, 2, 7, 100, 3000})
            for (const double idle : {0.0, 0.3, 20.0}) {
                const auto moments = timelapseMoments(painting, {.frames = frames, .idle = idle});
                QCOMPARE(moments.size(), std::size_t(frames));
                QVERIFY(std::ranges::is_sorted(moments));
                QVERIFY(moments.front() > 0);
                QCOMPARE(moments.back(), painting.end());
            }
    }
};

QTEST_GUILESS_MAIN(TestTimelapse)
#include "test_timelapse.moc"
