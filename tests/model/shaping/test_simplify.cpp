// Fewer segments for nearly the same picture.
#include "model/brush/stroke_builder.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/simplify.h"
#include "model/shaping/curves/split.h"
#include "tests/model/awkward_strokes.h"

#include <QElapsedTimer>
#include <QTest>

#include <numeric>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// A trunk as a hand paints it: upwards in 1.6 seconds, swaying, pressed harder in the middle.
Stroke trunk(const QString &brush = "brush-pen", double scale = 1)
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= 200; ++i) {
        const double u = i / 200.0;
        const Point at{300 + 30 * std::sin(5 * u) + 9 * std::sin(17 * u), 620 - 520 * u};
        samples.push_back({scale * at, Microseconds(i) * 8000, float(0.25 + 0.6 * std::sin(3 * u))});
    }
    const Brush *preset = findBrush(brush);
    return *buildStroke(preset ? *preset : builtinBrushes().front(), 1, samples);
}

double paintOf(const Stroke &stroke)
{
    double sum = 0;
    for (const Segment &s : stroke.segments)
        sum += double(s.density) * arcLength(offsetsOf(s));
    return sum;
}

/// The greatest distance of a stroke's curve to another one's.
double distanceBetween(const Stroke &a, const Stroke &b)
{
    double most = 0;
    for (const Segment &s : a.segments)
        for (double p : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            double distance = 0;
            nearestPlace(b, a.cubicOf(s).at(p), &distance);
            most = std::max(most, distance);
        }
    return most;
}

} // namespace

class TestSimplify : public QObject {
    Q_OBJECT

private slots:
    void aTrunkNeedsFewSegments()
    {
        const Stroke before = trunk();
        QVERIFY2(before.segments.size() > 150, qPrintable(QString::number(before.segments.size())));
        std::vector<int> sources;
        const Stroke after = simplified(before, {}, {}, &sources);
        QCOMPARE(problemOf(after), QString());
        QVERIFY2(after.segments.size() <= 40, qPrintable(QString::number(after.segments.size())));
        QCOMPARE(sources.size(), after.segments.size());
        QVERIFY(distanceBetween(before, after) < 0.51);
        QVERIFY(distanceBetween(after, before) < 0.51);
        QVERIFY(std::abs(paintOf(after) / paintOf(before) - 1) < 1e-5);
        QCOMPARE(after.born(), before.born());
        QVERIFY(after.segments.front().bezier[0] == before.segments.front().bezier[0]);
        QVERIFY(after.segments.back().bezier[3] == before.segments.back().bezier[3]);
        for (std::size_t k = 1; k < after.segments.size(); ++k) { // it goes on smoothly
            const Point in = endDirection(offsetsOf(after.segments[k - 1]));
            QVERIFY(dot(in, startDirection(offsetsOf(after.segments[k]))) > 0.9998);
            QVERIFY(after.segments[k].born > after.segments[k - 1].born);
        }
    }

    void valuesStayWithinTheirTolerance()
    {
        const Stroke before = trunk();
        for (const double values : {0.02, 0.1, 0.5}) {
            std::vector<int> sources;
            const Stroke after = simplified(before, {2, values}, {}, &sources);
            for (std::size_t k = 0; k < after.segments.size(); ++k) {
                const auto end = k + 1 < sources.size() ? std::size_t(sources[k + 1]) : before.segments.size();
                const Segment &one = after.segments[k];
                for (auto i = std::size_t(sources[k]); i < end; ++i) {
                    const Segment &s = before.segments[i];
                    const double spread =
                        std::sqrt(double(one.diffusion * one.maxAge) / double(s.diffusion * s.maxAge));
                    QVERIFY(std::abs(std::log(spread)) <= values + 1e-4);
                    QVERIFY(std::abs(double(one.granulation - s.granulation)) <= values + 1e-4);
                    QVERIFY(toSeconds(s.born - one.born) <= values * std::max(double(s.maxAge), 1.6 / 6) + 1e-6);
                    QVERIFY(s.born >= one.born);
                }
            }
        }
    }

    void cornersChainsAndLiftsStay()
    {
        // A zigzag of short straight segments, then another chain, of which the last ones lift.
        Stroke stroke;
        stroke.id = 1;
        Point at;
        for (int leg = 0; leg < 4; ++leg)
            for (int i = 0; i < 10; ++i) {
                const Point step = leg % 2 ? Point{3, -4} : Point{3, 4};
                Segment s;
                const auto offset = [&](double share) { return toOffset(at + share * step, {}); };
                s.bezier = {offset(0), offset(1.0 / 3), offset(2.0 / 3), offset(1)};
                s.start = leg == 2 && i == 0;
                s.lift = leg == 3 && i >= 5;
                at = at + step;
                stroke.segments.push_back(s);
            }
        const Stroke after = simplified(stroke, {100, 1});
        QCOMPARE(problemOf(after), QString());
        QCOMPARE(after.segments.size(), std::size_t(5));
        QVERIFY(after.segments[2].start && !after.segments[3].start);
        QVERIFY(after.segments[4].lift && !after.segments[3].lift);
        QCOMPARE(cornersOf(after).size(), std::size_t(2));
    }

    void onlyWhatIsChosen()
    {
        const Stroke before = trunk();
        std::vector<bool> chosen(before.segments.size());
        for (std::size_t k = 50; k < 100; ++k)
            chosen[k] = true;
        std::vector<int> sources;
        const Stroke after = simplified(before, {}, chosen, &sources);
        QVERIFY(after.segments.size() < before.segments.size() - 30);
        for (std::size_t k = 0; k < 50; ++k)
            QVERIFY(after.segments[k] == before.segments[k]);
        for (std::size_t k = 1; k <= before.segments.size() - 100; ++k)
            QVERIFY(after.segments[after.segments.size() - k] == before.segments[before.segments.size() - k]);
        const std::vector<bool> none(before.segments.size());
        QVERIFY(simplified(before, {}, none) == before);
    }

    void awkwardStrokesStayWhole()
    {
        AwkwardStrokes random(5);
        for (int i = 0; i < 300; ++i) {
            const Stroke before = random.stroke(1 + random.below(8));
            const Stroke after = simplified(before, {random.real(0, 30), random.real(0, 4)});
            QCOMPARE(problemOf(after), QString());
            QVERIFY(after.segments.size() <= before.segments.size());
            QVERIFY(std::abs(paintOf(after) / paintOf(before) - 1) < 1e-3);
        }
    }

    void manySegmentsInATenthOfASecond()
    {
        Stroke long_ = trunk();
        const std::vector<Segment> once = long_.segments;
        while (long_.segments.size() < 10'000) {
            std::vector<Segment> more = once;
            more.front().start = true;
            long_.segments.insert(long_.segments.end(), more.begin(), more.end());
        }
        QElapsedTimer timer;
        timer.start();
        const Stroke after = simplified(long_, {});
        qInfo() << long_.segments.size() << "segments to" << after.segments.size() << "in" << timer.elapsed() << "ms";
        QVERIFY(after.segments.size() < long_.segments.size() / 4);
    }
};

QTEST_MAIN(TestSimplify)
#include "test_simplify.moc"
