// What areas have in common and what one has alone, against winding numbers counted at points.
#include "model/area/area_sets.h"
#include "model/area/offset_curve.h"
#include "tests/model/area/windings.h"
#include "tests/model/awkward_strokes.h"
#include "tests/trials.h"

#include <QTest>

#include <numbers>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Loops = std::vector<std::vector<Cubic>>;

std::vector<Cubic> polygon(const std::vector<Point> &corners)
{
    std::vector<Cubic> loop;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (corners[k] != corners[(k + 1) % corners.size()])
            loop.push_back(straightCubic(corners[k], corners[(k + 1) % corners.size()]));
    return loop;
}

std::vector<Cubic> rectangle(double x, double y, double width, double height)
{
    return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

std::vector<Cubic> circle(Point centre, double radius)
{
    return arcAround(centre, centre + Point{radius, 0}, 2 * std::numbers::pi);
}

/// ∫ x dy around the loops.
double extentOf(const Area &area)
{
    double size = 0;
    for (const std::vector<Cubic> &loop : area.loops)
        for (const Cubic &curve : loop)
            for (int i = 0; i < 400; ++i)
                size -= curve.at((i + 0.5) / 400).x * curve.derivative((i + 0.5) / 400).y / 400;
    return size;
}

bool isInside(const Loops &loops, FillRule rule, Point at)
{
    const int winding = windingAt(loops, at);
    return rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
}

bool isClosed(const Area &area)
{
    for (const std::vector<Cubic> &loop : area.loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (loop[k].p[3] != loop[(k + 1) % loop.size()].p[0])
                return false;
    return true;
}

/// Compares the sets of two areas with what lies inside their outlines, at points that are not near an outline.
QString problemOf(const Loops &a, FillRule ruleA, const Loops &b, FillRule ruleB, std::mt19937 &random, double size,
                  double near)
{
    const Area first = areaOf(a, ruleA), second = areaOf(b, ruleB);
    const Area both = intersection(first, second), rest = difference(first, second), all = united(first, second);
    for (const Area *area : {&first, &second, &both, &rest, &all})
        if (!isClosed(*area))
            return "a loop is open";
    std::uniform_real_distribution<double> u(-0.05 * size, 1.05 * size);
    for (int i = 0; i < 40; ++i) {
        const Point x{u(random), u(random)};
        if (distanceTo(a, x) <= near || distanceTo(b, x) <= near)
            continue;
        const bool inA = isInside(a, ruleA, x), inB = isInside(b, ruleB, x);
        const std::pair<const Area *, bool> wanted[] = {
            {&first, inA}, {&second, inB}, {&both, inA && inB}, {&rest, inA && !inB}, {&all, inA || inB}};
        for (const auto &[area, inside] : wanted)
            if (const int winding = windingAt(area->loops, x); winding != int(inside))
                return QStringLiteral("set %1: %2 around (%3, %4)")
                    .arg(area == &first    ? 0
                         : area == &second ? 1
                         : area == &both   ? 2
                         : area == &rest   ? 3
                                           : 4)
                    .arg(winding)
                    .arg(x.x)
                    .arg(x.y);
    }
    return {};
}

} // namespace

class TestAreaSets : public QObject {
    Q_OBJECT

private slots:
    void rectangles()
    {
        const Area a = areaOf({rectangle(0, 0, 10, 10)}, FillRule::NonZero);
        const Area b = areaOf({rectangle(6, 5, 10, 10)}, FillRule::NonZero);
        QVERIFY(std::abs(extentOf(a) - 100) < 1e-6);
        QVERIFY(std::abs(extentOf(intersection(a, b)) - 20) < 1e-6);
        QVERIFY(std::abs(extentOf(difference(a, b)) - 80) < 1e-6);
        QVERIFY(std::abs(extentOf(united(a, b)) - 180) < 1e-6);
        QCOMPARE(intersection(a, b).loops.size(), std::size_t(1));
        QCOMPARE(intersection(a, b).curves(), std::size_t(4));
        QCOMPARE(intersection(a, b).box(), (Rect{6, 5, 10, 10}));
        QVERIFY(difference(a, a).isEmpty() && difference(Area(), a).isEmpty() && intersection(a, Area()).isEmpty());
        QVERIFY(std::abs(extentOf(intersection(a, a)) - 100) < 1e-6);
        // Neighbours that share an edge have nothing in common.
        const Area beside = areaOf({rectangle(10, 0, 10, 10)}, FillRule::NonZero);
        QVERIFY(std::abs(extentOf(intersection(a, beside))) < 1e-9);
        QVERIFY(std::abs(extentOf(difference(a, beside)) - 100) < 1e-6);
    }

    void curvesStayCurves()
    {
        const Area disc = areaOf({circle({0, 0}, 10)}, FillRule::NonZero);
        const Area half = intersection(disc, areaOf({rectangle(-20, 0, 40, 20)}, FillRule::NonZero));
        QVERIFY(std::abs(extentOf(half) - 50 * std::numbers::pi) < 0.1);
        QVERIFY2(half.curves() <= 6, qPrintable(QString::number(half.curves())));
        const Area ring = difference(disc, areaOf({circle({0, 0}, 5)}, FillRule::NonZero));
        QVERIFY(std::abs(extentOf(ring) - 75 * std::numbers::pi) < 0.1);
        QCOMPARE(windingAt(ring.loops, {0.1, 0.2}), 0);
        QCOMPARE(windingAt(ring.loops, {7.1, 0.2}), 1);
    }

    /// However much there is to do: it ends when the effort is spent, soon after.
    void effortIsBounded()
    {
        std::mt19937 random(9);
        std::vector<Point> corners;
        for (int i = 0; i < 3000; ++i) {
            const double x = double(random() % 1000), y = double(random() % 1000);
            corners.push_back({x, y});
        }
        AreaEffort little(1'000'000);
        areaOf({polygon(corners)}, FillRule::EvenOdd, &little);
        QVERIFY(little.isSpent());
        AreaEffort enough(1'000'000);
        const Area a = areaOf({rectangle(0, 0, 10, 10)}, FillRule::NonZero, &enough);
        const Area b = areaOf({rectangle(6, 5, 10, 10)}, FillRule::NonZero, &enough);
        QVERIFY(std::abs(sizeOf(intersection(a, b, &enough)) - 20) < 1e-6);
        QVERIFY(std::abs(sizeOf(united(a, b, &enough)) - 180) < 1e-6);
        QVERIFY(std::abs(sizeOf(difference(a, b, &enough)) - 80) < 1e-6);
        QVERIFY(!enough.isSpent() && enough.left() < 1'000'000);
    }

    /// Corners on a coarse grid: nearly every one lies on something.
    void randomOnAGrid()
    {
        std::mt19937 random(3);
        for (int i = 0; i < trials(300, 30'000); ++i) {
            Loops areas[2];
            for (Loops &loops : areas)
                for (unsigned n = 1 + random() % 2; n > 0; --n) {
                    std::vector<Point> corners;
                    for (unsigned k = 2 + random() % 6; k > 0; --k)
                        corners.push_back({double(random() % 6), double(random() % 6)});
                    loops.push_back(polygon(corners));
                }
            const QString problem =
                problemOf(areas[0], FillRule(random() % 2), areas[1], FillRule(random() % 2), random, 6, 0.1);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("trial %1: %2").arg(i).arg(problem)));
        }
    }

    void randomCurves()
    {
        AwkwardStrokes awkward(5);
        std::mt19937 random(4);
        for (int i = 0; i < trials(60, 6'000); ++i) {
            Loops areas[2];
            for (Loops &loops : areas) {
                std::vector<Cubic> loop;
                Point at{50 + awkward.real(-40, 40), 50 + awkward.real(-40, 40)};
                const Point first = at;
                for (int k = 1 + awkward.below(5); k > 0; --k) {
                    const auto c = awkward.curve(at, 40);
                    loop.push_back({c});
                    at = c[3];
                }
                if (at != first)
                    loop.push_back(straightCubic(at, first));
                loops.push_back(loop);
            }
            if (awkward.below(4) == 0)
                areas[1].push_back(areas[0][0]); // They share an edge everywhere.
            const QString problem =
                problemOf(areas[0], FillRule(random() % 2), areas[1], FillRule(random() % 2), random, 100, 0.7);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("trial %1: %2").arg(i).arg(problem)));
        }
    }
};

QTEST_APPLESS_MAIN(TestAreaSets)
#include "test_area_sets.moc"
