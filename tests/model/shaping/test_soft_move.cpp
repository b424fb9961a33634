// As many nodes as a view needs, and moves that take along what lies near.
#include "model/brush/stroke_builder.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "model/shaping/nodes/reshape.h"
#include "model/shaping/nodes/soft_move.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Nodes = std::vector<int>;

/// A trunk as a hand paints it, upwards in 1.6 seconds; some two hundred segments of a few units each.
Stroke trunk()
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= 200; ++i) {
        const double u = i / 200.0;
        const Point at{300 + 30 * std::sin(5 * u) + 9 * std::sin(17 * u), 620 - 520 * u * (0.4 + 0.6 * u)};
        samples.push_back({at, Microseconds(i) * 8000, float(0.25 + 0.6 * std::sin(3 * u))});
    }
    return *buildStroke(*findBrush("brush-pen"), 1, samples);
}

/// The trunk, and behind it another chain of its first fifty segments, beside it.
Stroke twoTrunks()
{
    Stroke two = trunk();
    std::vector<Segment> other(two.segments.begin(), two.segments.begin() + 50);
    for (Segment &s : other)
        for (Offset &o : s.bezier)
            o.x += 4;
    appendChain(two, std::move(other));
    return two;
}

/// A circle of sixty segments around (0, 0).
Stroke ring()
{
    Stroke stroke;
    stroke.id = 1;
    const auto at = [](int k) {
        const double angle = k % 60 * 0.1047197551196598;
        return Point{100 * std::cos(angle), 100 * std::sin(angle)};
    };
    for (int k = 0; k < 60; ++k) {
        const Point a = at(k), b = at(k + 1), out{-a.y, a.x}, in{-b.y, b.x};
        Segment s;
        s.bezier = toOffsets({{a, a + 0.0349 * out, b - 0.0349 * in, b}});
        if (k > 0)
            s.bezier[0] = stroke.segments.back().bezier[3];
        stroke.segments.push_back(s);
    }
    stroke.segments.back().bezier[3] = stroke.segments.front().bezier[0];
    return stroke;
}

/// The way from a chain's first node to node k of it.
double wayTo(const Stroke &stroke, int first, int k)
{
    double way = 0;
    for (int i = first; i < k; ++i)
        way += arcLength(offsetsOf(stroke.segments[std::size_t(i)]));
    return way;
}

/// The greatest turn at a node or within a segment, radians.
double sharpestTurn(const Stroke &stroke)
{
    double most = 0;
    const auto turn = [&](Point a, Point b) {
        if (a != Point() && b != Point())
            most = std::max(most, std::abs(std::atan2(cross(a, b), dot(a, b))));
    };
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Cubic c = offsetsOf(stroke.segments[k]);
        turn(startDirection(c), c.p[3] - c.p[0]);
        turn(c.p[3] - c.p[0], endDirection(c));
        if (k > 0 && !stroke.beginsChain(k))
            turn(endDirection(offsetsOf(stroke.segments[k - 1])), startDirection(c));
    }
    return most;
}

/// Whether all but the curves is what it was.
bool keepsValues(const Stroke &after, const Stroke &before)
{
    Stroke same = after;
    for (std::size_t k = 0; k < same.segments.size(); ++k)
        same.segments[k].bezier = before.segments[k].bezier;
    return same == before;
}

} // namespace

class TestSoftMove : public QObject {
    Q_OBJECT

private slots:
    void nodesAreAsCoarseAsTheGap()
    {
        const Stroke s = trunk();
        const int n = int(s.segments.size());
        QVERIFY2(n > 180, qPrintable(QString::number(n)));
        for (const double gap : {10.0, 24.0, 60.0, 1000.0}) {
            const std::vector<int> shown = coarseNodes(s, gap);
            QCOMPARE(shown.front(), 0);
            QCOMPARE(shown.back(), n);
            QVERIFY(std::is_sorted(shown.begin(), shown.end()));
            for (std::size_t i = 1; i < shown.size() && gap < 1000; ++i) {
                const double apart = wayTo(s, 0, shown[i]) - wayTo(s, 0, shown[i - 1]);
                QVERIFY2(apart > 0.98 * gap && apart < 3 * gap, qPrintable(QString::number(apart / gap)));
            }
        }
        QCOMPARE(coarseNodes(s, 1000).size(), std::size_t(2));
        QCOMPARE(coarseNodes(s, 0).size(), std::size_t(n + 1));
    }

    void nearerViewsShowTheSameAndMore()
    {
        const Stroke s = twoTrunks();
        std::vector<int> last;
        for (double gap = 400; gap > 0.5; gap /= 1.1) {
            const std::vector<int> now = coarseNodes(s, gap);
            QVERIFY(std::includes(now.begin(), now.end(), last.begin(), last.end()));
            last = now;
        }
        QVERIFY(last.size() > 200);
        QCOMPARE(coarseNodes(s, 1e-6).size(), std::size_t(nodeCount(s)));
    }

    void aBendLeavesMostOfThem()
    {
        const Stroke s = trunk();
        const Stroke bent = SoftMove(s, Nodes{100}, 150).by({40, 10});
        const std::vector<int> before = coarseNodes(s, 24), after = coarseNodes(bent, 24);
        std::vector<int> both;
        std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(both));
        QVERIFY2(3 * both.size() >= 2 * before.size(),
                 qPrintable(QString("%1 of %2").arg(both.size()).arg(before.size())));
    }

    void endsAndCornersAreAlwaysAmongThem()
    {
        Stroke s = twoTrunks();
        s.segments[77].node = NodeKind::Corner;
        const std::vector<int> shown = coarseNodes(s, 60);
        const int n = int(s.segments.size());
        for (const int node : {0, 77, n - 50, n, n + 1})
            QVERIFY(std::binary_search(shown.begin(), shown.end(), node));
        QVERIFY(shown.size() < 25);
        QVERIFY(isCrowded(s, {40, 0.5}, 24, 150));
        QVERIFY(!isCrowded(s, {40, 0.5}, 0.01, 150));
    }

    void aNodeBendsTheTrunkWithoutAKnob()
    {
        const Stroke s = trunk();
        const Stroke bent = SoftMove(s, Nodes{100}, 150).by({60, 0});
        QCOMPARE(problemOf(bent), QString());
        QVERIFY(keepsValues(bent, s));
        QVERIFY(length(nodePosition(bent, 100) - nodePosition(s, 100) - Point{60, 0}) < 1e-3);
        QVERIFY(cornersOf(bent).size() <= cornersOf(s).size());
        QVERIFY2(sharpestTurn(bent) < 0.2, qPrintable(QString::number(sharpestTurn(bent))));
        const Stroke knob = SoftMove(s, Nodes{100}, 0).by({60, 0});
        QVERIFY(knob == withNodeMoved(s, {100}, {60, 0})); // a reach of zero
        QVERIFY(sharpestTurn(knob) > 1);
        double last = 60;
        for (int k = 100; k <= int(s.segments.size()); ++k) { // it fades, and ends at the reach
            const double moved = nodePosition(bent, k).x - nodePosition(s, k).x;
            QVERIFY(moved <= last + 1e-3);
            QCOMPARE(std::abs(moved) < 1e-4, wayTo(s, 100, k) >= 150);
            last = moved;
        }
    }

    void severalNodesTakeWhatLiesBetween()
    {
        const Stroke s = trunk();
        const Stroke bent = SoftMove(s, Nodes{80, 120}, 100).by({50, 0});
        for (int k = 80; k <= 120; ++k) {
            const double moved = nodePosition(bent, k).x - nodePosition(s, k).x;
            QVERIFY(moved > 20 && moved < 50.001);
        }
        QVERIFY(sharpestTurn(bent) < 0.3);
        std::vector<int> all;
        for (int k = 0; k < nodeCount(s); ++k)
            all.push_back(k);
        const Stroke moved = SoftMove(s, all, 100).by({5, 6});
        QVERIFY(moved.origin != s.origin && moved.segments == s.segments);
    }

    /// A drag in the upper part of a trunk leaves its foot and its top.
    void endsMayStay()
    {
        const Stroke s = chainOnly(twoTrunks(), chainsOf(twoTrunks()).front());
        const int n = int(s.segments.size());
        const auto moved = [&](int node, double reach, SoftMove::Ends ends) {
            const Stroke bent = SoftMove(s, Nodes{node}, reach, ends).by({30, 0});
            return std::pair(length(nodePosition(bent, 0) - nodePosition(s, 0)),
                             length(nodePosition(bent, n) - nodePosition(s, n)));
        };
        double way = 0; // to the start
        int node = 0;
        for (; way < 60; ++node)
            way += arcLength(offsetsOf(s.segments[std::size_t(node)]));
        QVERIFY(moved(node, 150, SoftMove::Ends::Follow).first > 1);
        QCOMPARE(moved(node, 150, SoftMove::Ends::Stay).first, 0.0);
        QVERIFY(moved(node, 4.5 * way, SoftMove::Ends::Stay).first > 1); // very near, it follows
        QCOMPARE(moved(n, 150, SoftMove::Ends::Stay).second, 30.0);      // moved itself
        const Stroke bent = SoftMove(s, Nodes{node}, 150, SoftMove::Ends::Stay).by({30, 0});
        QVERIFY(length(nodePosition(bent, node) - nodePosition(s, node) - Point{30, 0}) < 1e-3);
        const Stroke free = SoftMove(s, Nodes{node}, 150).by({30, 0});
        for (int k = node; k < n; ++k) // Towards the far end nothing is different.
            QVERIFY(length(nodePosition(bent, k) - nodePosition(free, k)) < 1e-3);
        const CurvePlace place{node, 0.5};
        const Point at = s.cubicOf(s.segments[std::size_t(node)]).at(0.5);
        const Stroke curve = SoftMove(s, place, 150, SoftMove::Ends::Stay).by({20, 5});
        QVERIFY(length(curve.cubicOf(curve.segments[std::size_t(node)]).at(0.5) - at - Point{20, 5}) < 1e-3);
        QCOMPARE(nodePosition(curve, 0), nodePosition(s, 0));
    }

    void chainsAreApart()
    {
        const Stroke s = twoTrunks();
        const int n = int(s.segments.size()), second = n - 50;
        const Stroke bent = SoftMove(s, Nodes{second + 25}, 100).by({30, 0});
        for (int k = 0; k < second; ++k)
            QVERIFY(bent.segments[std::size_t(k)] == s.segments[std::size_t(k)]);
        QVERIFY(!(bent.segments[std::size_t(second)] == s.segments[std::size_t(second)]));
        // The end of the first chain, whose node stands last.
        const Stroke end = SoftMove(s, Nodes{n + 1}, 100).by({30, 0});
        QVERIFY(length(nodePosition(end, n + 1) - nodePosition(s, n + 1) - Point{30, 0}) < 1e-3);
        for (int k = second; k < n; ++k)
            QVERIFY(end.segments[std::size_t(k)] == s.segments[std::size_t(k)]);
        const Stroke curve = SoftMove(s, CurvePlace{second - 1, 0.9}, 100).by({30, 0});
        for (int k = second; k < n; ++k)
            QVERIFY(curve.segments[std::size_t(k)] == s.segments[std::size_t(k)]);
    }

    void closedChainsStayClosed()
    {
        const Stroke s = ring();
        for (const int node : {0, 2, 58, 60}) {
            const Stroke bent = SoftMove(s, Nodes{node}, 80).by({25, 5});
            QVERIFY(bent.segments.front().bezier[0] == bent.segments.back().bezier[3]);
            QVERIFY(!(bent.segments[1] == s.segments[1]) && !(bent.segments[58] == s.segments[58]));
            QVERIFY(dot(endDirection(offsetsOf(bent.segments.back())), startDirection(offsetsOf(bent.segments[0]))) >
                    0.99);
        }
        for (const CurvePlace place : {CurvePlace{0, 0.02}, CurvePlace{59, 0.99}}) {
            for (const double reach : {0.0, 80.0}) {
                const Stroke bent = SoftMove(s, place, reach).by({10, 5});
                QVERIFY(bent.segments.front().bezier[0] == bent.segments.back().bezier[3]);
            }
        }
    }

    void theCurveFollowsThePointerExactly()
    {
        AwkwardStrokes random(21);
        const Stroke many = trunk(), two = twoTrunks(), round = ring();
        for (int i = 0; i < 2000; ++i) {
            const Stroke &s = i % 3 == 0 ? many : i % 3 == 1 ? two : round;
            const CurvePlace place{random.below(int(s.segments.size())), random.real(0, 1)};
            const double reach = i % 4 == 0 ? 0 : random.real(0, 300);
            const Point by = random.point(400);
            const Point to = s.cubicOf(s.segments[std::size_t(place.segment)]).at(place.p) + by;
            const Stroke bent = SoftMove(s, place, reach).by(by);
            QCOMPARE(problemOf(bent), QString());
            QVERIFY(keepsValues(bent, s));
            double distance = 0;
            nearestPlace(bent, to, &distance);
            QVERIFY2(distance < 1e-3, qPrintable(QString::number(distance)));
        }
    }

    void noPartOfABendGoesBeyondThePointer()
    {
        const Stroke s = trunk();
        for (int k = 3; k < int(s.segments.size()) - 3; k += 7)
            for (const double p : {0.01, 0.3, 0.97}) {
                const Stroke bent = SoftMove(s, CurvePlace{k, p}, 150).by({-46, 0}); // 46 pixels made a hairpin of 150
                double farthest = 0;
                for (std::size_t i = 0; i < s.segments.size(); ++i)
                    for (double q = 0; q <= 1; q += 0.25)
                        farthest = std::max(
                            farthest, length(bent.cubicOf(bent.segments[i]).at(q) - s.cubicOf(s.segments[i]).at(q)));
                QVERIFY2(farthest < 46.5, qPrintable(QString::number(farthest)));
                QVERIFY(sharpestTurn(bent) < 0.2);
            }
    }

    void awkwardStrokesStayWhole()
    {
        AwkwardStrokes random(22);
        for (int i = 0; i < 400; ++i) {
            const Stroke s = random.stroke(1 + random.below(8));
            std::vector<int> nodes;
            for (int k = 0; k < nodeCount(s); ++k)
                if (random.below(3) == 0)
                    nodes.push_back(k);
            const Stroke moved = SoftMove(s, nodes, random.real(0, 50)).by(random.point(30));
            QCOMPARE(problemOf(moved), QString());
            QVERIFY(keepsValues(moved, Stroke(s)) || moved.origin != s.origin);
            const std::vector<int> shown = coarseNodes(s, random.real(0, 40));
            QVERIFY(std::is_sorted(shown.begin(), shown.end()) && shown.back() < nodeCount(s));
            QCOMPARE(problemOf(SoftMove(s, CurvePlace{0, random.real(0, 1)}, 20).by(random.point(30))), QString());
        }
    }
};

QTEST_APPLESS_MAIN(TestSoftMove)
#include "test_soft_move.moc"
