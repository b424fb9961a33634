// Smoothing, straightening and offsetting curves.
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/fairing.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/bending.h"
#include "model/shaping/nodes/reshape.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

#include <numbers>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// A stroke through f(0) … f(1) in `count` segments, with handles along f's own derivative.
template <typename Function>
Stroke along(Function f, int count)
{
    Stroke stroke;
    stroke.id = 1;
    const auto slope = [&](double t) { return 1e5 * (f(t + 5e-6) - f(t - 5e-6)); };
    for (int k = 0; k < count; ++k) {
        const double a = double(k) / count, b = double(k + 1) / count, third = 1.0 / (3 * count);
        Segment s;
        s.bezier = toOffsets({{f(a), f(a) + third * slope(a), f(b) - third * slope(b), f(b)}});
        s.born = k * 1000;
        s.density = float(5 + k);
        if (k > 0)
            s.bezier[0] = stroke.segments.back().bezier[3];
        stroke.segments.push_back(s);
    }
    return stroke;
}

Point circle(double t)
{
    return {100 * std::cos(4 * t), 100 * std::sin(4 * t)};
}

/// A long bow with wiggles on it, each 20 units across and about 27 along the curve.
Point wiggles(double t)
{
    return {400 * t, 60 * std::sin(std::numbers::pi * t) + 4 * std::sin(2 * std::numbers::pi * 20 * t)};
}

bool valuesStay(const Stroke &before, const Stroke &after)
{
    Stroke same = after;
    for (std::size_t k = 0; k < before.segments.size() && k < same.segments.size(); ++k) {
        same.segments[k].bezier = before.segments[k].bezier;
        same.segments[k].node = before.segments[k].node;
    }
    return same == before;
}

} // namespace

class TestBending : public QObject {
    Q_OBJECT

private slots:
    void wigglesGoAndTheBowStays()
    {
        const Stroke before = along(wiggles, 160);
        const Stroke after = smoothed(before, 0.38 * 27);
        QVERIFY(valuesStay(before, after));
        double wiggle = 0, bow = 0;
        for (const Segment &s : after.segments) {
            const Point p = after.cubicOf(s).at(0.5);
            if (p.x < 30 || p.x > 370)
                continue;
            wiggle = std::max(wiggle, std::abs(p.y - 60 * std::sin(std::numbers::pi * p.x / 400)));
            bow = std::max(bow, p.y);
        }
        QVERIFY2(wiggle < 1, qPrintable(QString::number(wiggle))); // of 4
        QVERIFY2(bow > 58.5, qPrintable(QString::number(bow)));
        QVERIFY(after.segments.front().bezier[0] == before.segments.front().bezier[0]);
        QVERIFY(after.segments.back().bezier[3] == before.segments.back().bezier[3]);
        QVERIFY(cornersOf(after).empty());
    }

    void arcsHardlyShrink()
    {
        const Stroke after = smoothed(along(circle, 24), 20); // a fifth of the radius
        for (std::size_t k = 6; k < 18; ++k)
            QVERIFY(std::abs(length(after.cubicOf(after.segments[k]).at(0.3)) - 100) < 0.2);
        const Stroke same = smoothed(along(circle, 24), 1e-3);
        for (std::size_t k = 0; k < 24; ++k)
            for (std::size_t i = 0; i < 4; ++i)
                QVERIFY(length((Point() + same.segments[k].bezier[i]) -
                               (Point() + along(circle, 24).segments[k].bezier[i])) < 1e-2);
    }

    void runsAndCornersHold()
    {
        const Stroke before = along(wiggles, 160);
        std::vector<bool> chosen(160);
        for (std::size_t k = 40; k < 120; ++k)
            chosen[k] = true;
        const Stroke after = smoothed(before, 8, chosen);
        for (std::size_t k = 0; k < 160; ++k)
            QCOMPARE(after.segments[k] == before.segments[k], !chosen[k]);
        QVERIFY(cornersOf(after).empty());
        // A right angle stays one, at its place.
        const auto angle = [](double t) { return t < 0.5 ? Point{200 * t, 0} : Point{100, 200 * t - 100}; };
        Stroke corner = along(angle, 8);
        corner.segments[3].bezier[2] = {90, 0}; // the derivative there is that of neither side
        corner.segments[4].bezier[1] = {100, 10};
        const Stroke still = smoothed(corner, 30);
        QVERIFY(still.segments[4].bezier[0] == corner.segments[4].bezier[0]);
        QCOMPARE(cornersOf(still), std::vector<int>{4});
    }

    void halfStraightAndStraight()
    {
        const Stroke before = along(wiggles, 60);
        QVERIFY(straightened(before, 0) == before);
        const Stroke straight = straightened(before, 1);
        QVERIFY(valuesStay(before, straight));
        for (const Segment &s : straight.segments)
            for (const Offset &o : s.bezier)
                QVERIFY(std::abs(double(o.y)) < 1e-4);
        const Stroke half = straightened(before, 0.5);
        QVERIFY(std::abs(double(half.segments[30].bezier[0].y) - 0.5 * double(before.segments[30].bezier[0].y)) < 1e-3);
        QVERIFY(cornersOf(half).empty());
        std::vector<bool> chosen(60);
        for (std::size_t k = 10; k < 20; ++k)
            chosen[k] = true;
        const Stroke part = straightened(before, 1, chosen);
        QVERIFY(part.segments[9] == before.segments[9] && part.segments[20].bezier == before.segments[20].bezier);
        QCOMPARE(part.segments[10].node, NodeKind::Corner);
    }

    void cornersStayWhereTheyAreWhenSidesGetStraight()
    {
        // A hill with a flat foot, whose nodes are all stored as smooth ones, as files of others have them.
        const auto hill = [](double t) {
            if (t < 0.5)
                return Point{400 * t, -50 * std::sin(2 * std::numbers::pi * t)};
            const Point foot[] = {{200, 0}, {200, 80}, {0, 80}, {0, 0}};
            const double along = 6 * (t - 0.5);
            const int k = std::min(2, int(along));
            return foot[k] + (along - k) * (foot[k + 1] - foot[k]);
        };
        Stroke before = along(hill, 12);
        for (const int k : {5, 7, 9, 11}) { // the derivative there is that of neither side
            const Cubic c = offsetsOf(before.segments[std::size_t(k)]);
            before.segments[std::size_t(k)].bezier[2] = toOffset(c.p[3] - (1.0 / 3) * (c.p[3] - c.p[0]), {});
        }
        for (const int k : {6, 8, 10}) {
            const Cubic c = offsetsOf(before.segments[std::size_t(k)]);
            before.segments[std::size_t(k)].bezier[1] = toOffset(c.p[0] + (1.0 / 3) * (c.p[3] - c.p[0]), {});
        }
        QCOMPARE(cornersOf(before), (std::vector<int>{6, 8, 10}));
        for (const Stroke &after : {straightened(before, 1), straightened(before, 0.5), smoothed(before, 30)})
            for (const int k : {6, 8, 10})
                QCOMPARE(nodePosition(after, k), nodePosition(before, k));
        QVERIFY(std::abs(nodePosition(straightened(before, 1), 3).y) < 1e-3);
        QCOMPARE(nodeKind(before, 8), NodeKind::Corner);
        QCOMPARE(nodeKind(before, 7), NodeKind::Smooth);
    }

    void offsetsKeepTheirDistance()
    {
        const Stroke before = along(circle, 6); // clockwise on the screen: its right is inwards
        for (const double d : {25.0, -40.0}) {
            std::vector<int> sources;
            const Stroke after = offsetAside(before, d, {}, &sources);
            QCOMPARE(problemOf(after), QString());
            QCOMPARE(sources.size(), after.segments.size());
            QVERIFY(cornersOf(after).empty());
            for (const Segment &s : after.segments)
                for (double p = 0; p <= 1; p += 0.125) {
                    const double radius = length(after.cubicOf(s).at(p));
                    QVERIFY2(std::abs(radius - (100 - d)) < 0.4, qPrintable(QString::number(radius)));
                }
        }
        QVERIFY(offsetAside(before, 0) == before);
        // Of a part: its ends stay, the middle is aside, and it goes on smoothly.
        const Stroke line = along([](double t) { return Point{400 * t, 0}; }, 40);
        std::vector<bool> chosen(40);
        for (std::size_t k = 10; k < 30; ++k)
            chosen[k] = true;
        const Stroke part = offsetAside(line, 12, chosen);
        QCOMPARE(part.segments.size(), std::size_t(40));
        QVERIFY(part.segments[9] == line.segments[9] && part.segments[30] == line.segments[30]);
        QVERIFY(std::abs(double(part.segments[20].bezier[0].y) - 12) < 1e-4);
        QVERIFY(cornersOf(part).empty());
    }

    void cornersAreMitred()
    {
        const auto angle = [](double t) { return t < 0.5 ? Point{200 * t, 0} : Point{100, 200 * t - 100}; };
        Stroke corner = along(angle, 2);
        corner.segments[0].bezier = {Offset{0, 0}, {30, 0}, {70, 0}, {100, 0}};
        corner.segments[1].bezier = {Offset{100, 0}, {100, 30}, {100, 70}, {100, 100}};
        const Stroke after = offsetAside(corner, -10);
        QVERIFY(length((Point() + after.segments[1].bezier[0]) - Point{110, -10}) < 1e-4);
        QVERIFY(length((Point() + after.segments[0].bezier[0]) - Point{0, -10}) < 1e-4);
        QVERIFY(length((Point() + after.segments[1].bezier[3]) - Point{110, 100}) < 1e-4);
    }

    void awkwardStrokesStayWhole()
    {
        AwkwardStrokes random(9);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(1 + random.below(7));
            std::vector<bool> chosen;
            if (random.below(2) == 0)
                for (std::size_t k = 0; k < s.segments.size(); ++k)
                    chosen.push_back(random.below(2) == 0);
            QCOMPARE(problemOf(smoothed(s, random.real(0, 50), chosen)), QString());
            QCOMPARE(problemOf(straightened(s, random.real(0, 1), chosen)), QString());
            std::vector<int> sources;
            const Stroke aside = offsetAside(s, random.real(-50, 50), chosen, &sources);
            QCOMPARE(problemOf(aside), QString());
            QCOMPARE(sources.size(), aside.segments.size());
        }
    }
};

QTEST_MAIN(TestBending)
#include "test_bending.moc"
