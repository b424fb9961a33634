// The eraser and the knife.
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/erase.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

double squaredDistanceTo(const std::vector<Point> &path, Point p)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Point a = path[i == 0 ? 0 : i - 1], along = path[i] - a;
        const double l2 = dot(along, along);
        const Point d = (p - a) - (l2 > 0 ? std::clamp(dot(p - a, along) / l2, 0.0, 1.0) : 0) * along;
        least = std::min(least, dot(d, d));
    }
    return least;
}

} // namespace

class TestErase : public QObject {
    Q_OBJECT

private slots:
    void theEraserLeavesNothingUnderIt()
    {
        AwkwardStrokes random(11);
        int cut = 0, gone = 0;
        for (int i = 0; i < 600; ++i) {
            const Stroke s = random.stroke(1 + random.below(6));
            const double radius = std::exp(random.real(-1, 5));
            std::vector<Point> path{s.origin + random.point(70)};
            for (int k = random.below(5); k > 0; --k)
                path.push_back(path.back() + random.point(40));
            std::vector<int> sources;
            const std::vector<Stroke> runs = erased(s, path, radius, &sources);
            gone += runs.empty();
            const double near = radius * radius;
            std::size_t n = 0;
            for (const Stroke &run : runs) {
                QCOMPARE(problemOf(run), QString());
                QCOMPARE(run.id, s.id);
                for (const Segment &g : run.segments) {
                    const Segment &source = s.segments[std::size_t(sources.at(n++))];
                    QVERIFY(!isPoint(g) && sameValues(g, source));
                    for (double p = 0; p <= 1; p += 1.0 / 64) // float32 rounds the ends of what was cut
                        QVERIFY(std::sqrt(squaredDistanceTo(path, run.cubicOf(g).at(p))) > radius - 1e-4);
                }
            }
            QCOMPARE(n, sources.size());
            // What the eraser did not come near is there, to the bit; what lies outside is still covered.
            for (std::size_t k = 0; k < s.segments.size(); ++k) {
                const Cubic c = s.cubicOf(s.segments[k]);
                bool far = true;
                for (double p = 0; p <= 1; p += 1.0 / 256)
                    far = far && squaredDistanceTo(path, c.at(p)) > near * 1.02 + 1;
                const auto same = [&](const Segment &g) { return g.bezier == s.segments[k].bezier; };
                const auto holds = [&](const Stroke &r) {
                    return std::any_of(r.segments.begin(), r.segments.end(), same);
                };
                QVERIFY(!far || std::any_of(runs.begin(), runs.end(), holds));
                for (double p = 0.01; p < 1; p += 0.07) {
                    if (std::sqrt(squaredDistanceTo(path, c.at(p))) < radius + 1e-3)
                        continue;
                    double nearest = 1e9;
                    for (const Stroke &run : runs) {
                        double d = 0;
                        nearestPlace(run, c.at(p), &d);
                        nearest = std::min(nearest, d);
                    }
                    QVERIFY2(nearest < 1e-4, qPrintable(QString::number(nearest)));
                }
            }
            cut += runs.size() > 1 || (runs.size() == 1 && runs[0] != s);
            if (runs.size() == 1 && runs[0].segments.size() == s.segments.size())
                QVERIFY(runs[0] == s || problemOf(runs[0]).isEmpty());
            // Once more takes nothing more.
            for (const Stroke &run : runs)
                QVERIFY(erased(run, path, radius - 1e-3).size() == 1);
        }
        QVERIFY2(cut > 100 && gone > 20, qPrintable(QStringLiteral("%1 %2").arg(cut).arg(gone)));
    }

    void theEraserAtTheEdgeTakesNothing()
    {
        const Stroke s = line({{0, 0}, {100, 0}});
        QCOMPARE(erased(s, {{50, 10}}, 10), std::vector<Stroke>{s});           // touches
        QCOMPARE(erased(s, {{0, 10}, {100, 10}}, 10), std::vector<Stroke>{s}); // along
        QCOMPARE(erased(s, {{50, 50}}, 10), std::vector<Stroke>{s});
        QCOMPARE(erased(s, {}, 10), std::vector<Stroke>{s});
        QCOMPARE(erased(s, {{50, 0}}, 0), std::vector<Stroke>{s});
        QVERIFY(erased(s, {{50, 0}}, 60).empty());
        const std::vector<Stroke> two = erased(s, {{50, 0}}, 10);
        QCOMPARE(two.size(), std::size_t(2));
        QCOMPARE(nodePosition(two[0], 1), (Point{40, 0}));
        QCOMPARE(nodePosition(two[1], 0), (Point{60, 0}));
        // Capsules that overlap make no nodes where one's edge lies in another.
        const std::vector<Stroke> long1 = erased(s, {{30, 3}, {40, -2}, {50, 3}, {52, 3}}, 10);
        QCOMPARE(long1.size(), std::size_t(2));
        QCOMPARE(long1[0].segments.size() + long1[1].segments.size(), std::size_t(2));
    }

    void whatIsPaintedLaterStays()
    {
        Stroke s = line({{0, 0}, {100, 0}, {200, 0}});
        s.segments[0].born = 1'000'000;
        s.segments[1].born = 2'000'000;
        QCOMPARE(erased(s, {{150, 0}}, 10, nullptr, 1'500'000), std::vector<Stroke>{s});
        QCOMPARE(erased(s, {{150, 0}}, 10, nullptr, 2'000'000).size(), std::size_t(2));
        const std::vector<Stroke> left = erased(s, {{0, 0}, {200, 0}}, 10, nullptr, 1'500'000);
        QCOMPARE(left.size(), std::size_t(1));
        QCOMPARE(left[0].segments, std::vector<Segment>{s.segments[1]});
        const std::vector<Stroke> cut = erased(s, {{100, 0}}, 10, nullptr, 1'500'000); // up to the node between them
        QCOMPARE(cut.size(), std::size_t(2));
        QCOMPARE(nodePosition(cut[0], 1), (Point{90, 0}));
        QCOMPARE(cut[1].segments, std::vector<Segment>{s.segments[1]});
    }

    void theKnifeFindsEveryCrossing()
    {
        const Stroke s = line({{0, 0}, {12, 0}, {12, 12}, {0, 12}});
        QCOMPARE(crossings(s, {6, -1}, {6, 13}), (std::vector<CurvePlace>{{0, 0.5}, {2, 0.5}}));
        QCOMPARE(crossings(s, {6, -1}, {6, 11}), (std::vector<CurvePlace>{{0, 0.5}}));
        QCOMPARE(crossings(s, {11, -1}, {13, 1}), (std::vector<CurvePlace>{{1, 0}})); // through a node
        QCOMPARE(crossings(s, {-1, -1}, {1, 1}).size(), std::size_t(0));              // through the start
        QCOMPARE(crossings(s, {5, 5}, {5, 5}).size(), std::size_t(0));
        AwkwardStrokes random(12);
        for (int i = 0; i < 300; ++i) {
            const Stroke t = random.stroke(3);
            const Point a = t.origin + random.point(60), b = t.origin + random.point(60);
            for (const CurvePlace &place : crossings(t, a, b)) {
                const Point x = t.cubicOf(t.segments[std::size_t(place.segment)]).at(place.p);
                const bool isNode = place.p == 0;
                QVERIFY(std::abs(cross(unit(b - a), x - a)) < (isNode ? 1e-4 : 1e-11));
            }
            const auto parts = cutAt(t, crossings(t, a, b));
            QCOMPARE(parts.size(), crossings(t, a, b).size() + 1);
            for (const Stroke &part : parts)
                QCOMPARE(problemOf(part), QString());
        }
        QCOMPARE(cutAt(s, {{1, 0}, {1, 1e-12}, {0, 0.5}}).size(), std::size_t(3));
    }
};

QTEST_APPLESS_MAIN(TestErase)
#include "test_erase.moc"
