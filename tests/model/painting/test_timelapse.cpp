// When the frames of a film are: in order, evenly, without the pauses, and the last one is the finished picture.
#include "model/document/timelapse.h"

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

    void theFilmClockGoesBothWays()
    {
        const Painting painting = drawnAt({2, 2.5, 10, 20});
        QCOMPARE(activeSpans(painting),
                 (std::vector<TimeSpan>{{2'000'000, 3'500'000}, {10'000'000, 11'000'000}, {20'000'000, 21'000'000}}));
        const FilmClock clock(painting, 250'000);
        QCOMPARE(clock.length(), Microseconds(4'000'000));
        for (Microseconds film = 0; film <= clock.length(); film += 12'500) {
            const Microseconds document = clock.documentTime(film);
            QCOMPARE(clock.filmTime(document), film);
        }
        QCOMPARE(clock.documentTime(0), Microseconds(2'000'000));
        QCOMPARE(clock.documentTime(clock.length()), Microseconds(21'000'000));
        QCOMPARE(clock.filmTime(0), Microseconds(0));
        QCOMPARE(clock.filmTime(5'000'000), Microseconds(1'750'000)); // within what is cut
        QCOMPARE(clock.filmTime(99'000'000), clock.length());
        QCOMPARE(FilmClock({}, 0).documentTime(5), Microseconds(0));
        QCOMPARE(FilmClock({}, 0).filmTime(5), Microseconds(0));
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
