// Cuts through strokes that are filled, against winding numbers counted at points.
#include "model/area/outline.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chain_strokes.h"
#include "model/shaping/erasing/erase.h"
#include "model/shaping/erasing/fill_cut.h"
#include "model/shaping/shapes.h"
#include "tests/model/area/windings.h"
#include "tests/model/awkward_strokes.h"
#include "tests/trials.h"

#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Loops = std::vector<std::vector<Cubic>>;

Stroke polygonStroke(const std::vector<std::vector<Offset>> &loops, bool closes = true)
{
    Stroke stroke;
    stroke.id = 1;
    for (const std::vector<Offset> &loop : loops)
        for (std::size_t k = 0; k + (closes ? 0 : 1) < loop.size(); ++k) {
            const Offset a = loop[k], b = loop[(k + 1) % loop.size()];
            Segment segment;
            segment.bezier = {a, a, b, b};
            segment.node = NodeKind::Corner;
            segment.start = k == 0 && !stroke.segments.empty();
            segment.born = Microseconds(stroke.segments.size());
            stroke.segments.push_back(segment);
        }
    stroke.fill = Fill{};
    return stroke;
}

Stroke rectangle()
{
    return polygonStroke({{{0, 0}, {100, 0}, {100, 60}, {0, 60}}});
}

std::size_t newOnes(const std::vector<int> &sources)
{
    return std::size_t(std::ranges::count(sources, -1));
}

/// The length of the curves that lay paint.
double painted(const Stroke &stroke)
{
    double sum = 0;
    for (const Segment &segment : stroke.segments)
        for (int i = 0; i < 50 && segment.density > 0; ++i)
            sum += length(offsetsOf(segment).at((i + 1) / 50.0) - offsetsOf(segment).at(i / 50.0));
    return sum;
}

/// How often a stroke's outline runs around a point, from the x axis towards the y axis.
int windingIn(const Stroke &stroke, Point at)
{
    return -windingAt(closedOutline(stroke), at - stroke.origin, 100);
}

bool isNear(const Stroke &stroke, Point at, double near)
{
    return distanceTo(closedOutline(stroke), at - stroke.origin) < near;
}

double distanceToPath(const std::vector<Point> &path, Point at)
{
    double least = 1e300;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Point a = path[i == 0 ? 0 : i - 1], along = path[i] - a;
        const double l2 = dot(along, along), t = l2 > 0 ? std::clamp(dot(at - a, along) / l2, 0.0, 1.0) : 0;
        least = std::min(least, length(at - (a + t * along)));
    }
    return least;
}

/// A stroke of one to three awkward chains, some of them closed.
Stroke awkwardOutline(AwkwardStrokes &make, double size)
{
    Stroke stroke;
    stroke.id = 1;
    stroke.origin = make.point(size);
    const int chains = 1 + make.below(3);
    for (int c = 0; c < chains; ++c) {
        Point at = make.point(0.5 * size);
        const Offset begin{float(at.x), float(at.y)};
        Offset from = begin;
        const int count = 1 + make.below(5);
        const bool closes = make.below(2) == 0 && count > 1;
        for (int k = 0; k < count; ++k) {
            Segment segment = make.values(0.02 * size);
            const auto curve = make.curve(Point() + from, size);
            for (std::size_t i = 0; i < 4; ++i)
                segment.bezier[i] = {float(curve[i].x), float(curve[i].y)};
            segment.bezier[0] = from;
            if (closes && k + 1 == count)
                segment.bezier[3] = begin;
            segment.node = NodeKind(make.below(3));
            segment.start = k == 0 && c > 0;
            from = segment.bezier[3];
            stroke.segments.push_back(segment);
        }
    }
    stroke.fill = Fill{};
    return stroke;
}

} // namespace

class TestFillCut : public QObject {
    Q_OBJECT

private slots:
    void aRectangleFallsIntoTwo()
    {
        std::vector<int> sources;
        const Stroke cut = filledCut(rectangle(), {40, -10}, {40, 80}, &sources);
        QCOMPARE(chainsOf(cut).size(), std::size_t(2));
        QCOMPARE(newOnes(sources), std::size_t(0)); // both close along the cut
        QCOMPARE(cut.segments.size(), std::size_t(6));
        QCOMPARE(problemOf(cut), QString());
        const std::vector<Stroke> halves = strokesOfChains(cut);
        QCOMPARE(halves.size(), std::size_t(2));
        for (const Point at : {Point{5, 5}, Point{39, 30}, Point{20, 55}, Point{41, 30}, Point{95, 55}, Point{60, 5}}) {
            QCOMPARE(windingIn(cut, at), 1);
            QCOMPARE(windingIn(halves[0], at) + windingIn(halves[1], at), 1);
        }
    }

    /// The outline is cut at the same places, wherever it begins.
    void theCornerItBeginsAtDoesNotMatter()
    {
        Stroke turned = rectangle();
        for (int i = 0; i < 4; ++i) {
            const Stroke cut = filledCut(turned, {-10, 20}, {130, 35});
            QCOMPARE(chainsOf(cut).size(), std::size_t(2));
            for (const Chain &chain : chainsOf(cut))
                QCOMPARE(chain.last - chain.first, 2);
            std::rotate(turned.segments.begin(), turned.segments.begin() + 1, turned.segments.end());
        }
        const Stroke diagonal = filledCut(rectangle(), {-50, -30}, {150, 90}); // through two corners
        QCOMPARE(chainsOf(diagonal).size(), std::size_t(2));
        QCOMPARE(diagonal.segments.size(), std::size_t(4));
    }

    void whatTheLineDoesNotGoThroughStays()
    {
        const Stroke s = rectangle();
        QCOMPARE(filledCut(s, {40, -10}, {40, 30}), s); // it ends within
        QCOMPARE(filledCut(s, {40, 10}, {40, 30}), s);
        QCOMPARE(filledCut(s, {-40, -10}, {140, -10}), s);
        QCOMPARE(filledCut(s, {-40, 0}, {140, 0}), s); // along a side
        QVERIFY(filledCutPlaces(s, {40, -10}, {40, 30}).empty());
        QCOMPARE(filledCutPlaces(s, {40, -10}, {40, 80}).size(), std::size_t(2));
    }

    /// What is cut through two arms has one piece below and two above, and holes stay with what is around them.
    void armsAndHoles()
    {
        const Stroke u = polygonStroke({{{0, 0}, {20, 0}, {20, 60}, {80, 60}, {80, 0}, {100, 0}, {100, 90}, {0, 90}}});
        QCOMPARE(strokesOfChains(filledCut(u, {-10, 30}, {110, 30})).size(), std::size_t(3));
        QCOMPARE(strokesOfChains(filledCut(u, {-10, 30}, {50, 30})).size(), std::size_t(2)); // one arm
        const Stroke ring =
            polygonStroke({{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {{30, 30}, {30, 60}, {60, 60}, {60, 30}}});
        QCOMPARE(strokesOfChains(ring).size(), std::size_t(1));
        QCOMPARE(strokesOfChains(filledCut(ring, {-10, 45}, {110, 45})).size(), std::size_t(2));
        QCOMPARE(strokesOfChains(filledCut(ring, {-10, 45}, {45, 45})).size(), std::size_t(1)); // its wall
        QCOMPARE(strokesOfChains(filledCut(ring, {-10, 15}, {110, 15})).size(), std::size_t(2));
    }

    void anOpenOutlineIsCutThroughWhatClosesIt()
    {
        const Stroke s = polygonStroke({{{0, 0}, {100, 0}, {100, 60}, {0, 60}}}, false);
        const Stroke cut = filledCut(s, {-10, 20}, {110, 20});
        QCOMPARE(chainsOf(cut).size(), std::size_t(2));
        QCOMPARE(strokesOfChains(cut).size(), std::size_t(2));
        QVERIFY(std::abs(painted(cut) - 260) < 1e-3); // what closes it is not painted
    }

    /// Knife, in the plane: each winding number stays, and so does each curve.
    void linesThroughAnything()
    {
        AwkwardStrokes make(firstSeed() + 1);
        for (int trial = 0; trial < trials(300, 10000); ++trial) {
            const double size = std::exp(make.real(-2, 6));
            Stroke stroke = awkwardOutline(make, size);
            Stroke cut = stroke;
            for (int i = 0; i < 3; ++i) {
                const Point a = stroke.origin + make.point(1.5 * size), b = stroke.origin + make.point(1.5 * size);
                cut = filledCut(cut, a, b);
            }
            QVERIFY2(problemOf(cut).isEmpty(), qPrintable(problemOf(cut)));
            QVERIFY(std::abs(painted(cut) - painted(stroke)) < 1e-2 * painted(stroke));
            for (int i = 0; i < 20; ++i) {
                const Point at = stroke.origin + make.point(1.5 * size);
                if (!isNear(cut, at, 0.02 * size))
                    QCOMPARE(windingIn(cut, at), windingIn(stroke, at));
            }
        }
    }

    void placesOfAnything()
    {
        AwkwardStrokes make(firstSeed() + 2);
        for (int trial = 0; trial < trials(300, 10000); ++trial) {
            const double size = std::exp(make.real(-2, 6));
            const Stroke stroke = awkwardOutline(make, size);
            std::vector<CurvePlace> places;
            for (int i = make.below(5); i >= 0; --i)
                places.push_back({make.below(int(stroke.segments.size())), make.below(3) == 0 ? 0 : make.real(0, 1)});
            const Stroke cut = cutInOne(stroke, places);
            QVERIFY2(problemOf(cut).isEmpty(), qPrintable(problemOf(cut)));
            for (int i = 0; i < 20; ++i) {
                const Point at = stroke.origin + make.point(1.5 * size);
                if (!isNear(cut, at, 0.02 * size))
                    QCOMPARE(windingIn(cut, at), windingIn(stroke, at));
            }
        }
        const Stroke cut = cutInOne(rectangle(), {{1, 0}, {2, 0}, {3, 0}, {2, 0.5}});
        QCOMPARE(chainsOf(cut).size(), std::size_t(4));
        QCOMPARE(chainsOf(cutInOne(rectangle(), {{2, 0}})).size(), std::size_t(1)); // It begins there.
    }

    /// Eraser: nothing under the circle, and all beside it as it was, whatever was erased before.
    void pathsThroughAnything()
    {
        AwkwardStrokes make(firstSeed() + 3);
        int longest = 0;
        for (int trial = 0; trial < trials(300, 10000); ++trial) {
            const double size = std::exp(make.real(-2, 6)), radius = size * std::exp(make.real(-3, -0.5));
            const Stroke stroke = awkwardOutline(make, size);
            std::vector<Point> path{stroke.origin + make.point(size)};
            Point step = make.point(radius);
            for (int i = make.below(12); i > 0; --i) {
                if (make.below(3) == 0)
                    step = make.point(radius);
                path.push_back(path.back() + step);
            }
            if (make.below(3) == 0)
                path.push_back(path[path.size() / 2]);
            std::vector<int> sources;
            Stroke left = stroke;
            if (make.below(2) == 0 || path.size() == 1) { // at once, or step by step
                const auto result = filledErased(stroke, path, radius, &sources);
                if (!result)
                    continue;
                QCOMPARE(sources.size(), result->segments.size());
                left = *result;
            } else {
                bool isGone = false;
                for (std::size_t i = 1; i < path.size() && !isGone; ++i) {
                    const auto result = filledErased(left, {path[i - 1], path[i]}, radius);
                    isGone = !result;
                    left = result.value_or(left);
                }
                if (isGone)
                    continue;
            }
            QVERIFY2(problemOf(left).isEmpty(), qPrintable(problemOf(left)));
            longest = std::max(longest, int(left.segments.size()) - int(stroke.segments.size()));
            for (int i = 0; i < 40; ++i) {
                const Point at = i % 2 ? stroke.origin + make.point(1.5 * size)
                                       : path[std::size_t(make.below(int(path.size())))] + make.point(1.5 * radius);
                const double distance = distanceToPath(path, at);
                if (isNear(left, at, 0.005 * size) || std::abs(distance - radius) < 0.01 * radius)
                    continue;
                const int wanted = distance < radius ? 0 : windingIn(stroke, at);
                QVERIFY2(windingIn(left, at) == wanted,
                         qPrintable(QString("trial %1: %2, not %3").arg(trial).arg(windingIn(left, at)).arg(wanted)));
            }
        }
        qInfo("at most %d segments more", longest);
    }

    void aHoleAndAStraightDrag()
    {
        const Stroke s = rectangle();
        std::vector<int> sources;
        auto hole = filledErased(s, {{50, 30}}, 10, &sources);
        QVERIFY(hole);
        QCOMPARE(hole->segments.size(), std::size_t(8)); // four arcs
        QCOMPARE(newOnes(sources), std::size_t(4));
        QCOMPARE(strokesOfChains(*hole).size(), std::size_t(1));
        QCOMPARE(filledErased(*hole, {{50, 30}}, 10), hole); // what is gone is gone
        Stroke dragged = s;
        for (double x = -20; x < 120; x += 4)
            dragged = *filledErased(dragged, {{x, 30}, {x + 4, 30}}, 10);
        QCOMPARE(strokesOfChains(dragged).size(), std::size_t(2));
        QCOMPARE(windingIn(dragged, {50, 30}), 0);
        QCOMPARE(windingIn(dragged, {50, 15}), 1);
        QCOMPARE(windingIn(dragged, {50, 45}), 1);
        QVERIFY(!filledErased(s, {{0, 30}, {100, 30}}, 40));
        QCOMPARE(filledErased(s, {{200, 30}}, 40), std::optional(s));
    }

    /// A fill that comes later keeps its outline.
    void whatIsFilledLater()
    {
        Stroke s = rectangle();
        Fill fill = *s.fill;
        fill.born = 5'000'000;
        s.fill = fill;
        const auto left = erasedInOne(s, {{50, 0}}, 10, nullptr, 1'000'000);
        QVERIFY(left);
        QCOMPARE(chainsOf(*left).size(), std::size_t(1));
        QVERIFY(std::abs(painted(*left) - 300) < 1e-3);
        QCOMPARE(windingIn(*left, {50, 3}), 1);
        QCOMPARE(windingIn(*erasedInOne(s, {{50, 0}}, 10), {50, 3}), 0);
    }

    void segmentsThatAreDeletedLeaveStraightLines()
    {
        const Stroke s = rectangle();
        auto left = withoutSegments(s, {1});
        QVERIFY(left);
        QCOMPARE(chainsOf(*left).size(), std::size_t(1));
        QCOMPARE(left->segments.size(), std::size_t(3));
        QCOMPARE(windingIn(*left, {95, 30}), 1); // The side was straight.
        left = withoutSegments(s, {0, 2});
        QCOMPARE(windingIn(*left, {50, 30}), 1);
        left = withoutSegments(s, {0, 1});
        QCOMPARE(windingIn(*left, {80, 10}), 0);
        QCOMPARE(windingIn(*left, {20, 50}), 1);
        QVERIFY(!withoutSegments(s, {0, 1, 2, 3}));
    }
};

QTEST_APPLESS_MAIN(TestFillCut)
#include "test_fill_cut.moc"
