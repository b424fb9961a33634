// Splitting, joining and bending strokes.
#include "model/geometry/bernstein.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/erase.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

#include <set>

using namespace suffuse;
using namespace suffuse::test;

class TestReshape : public QObject {
    Q_OBJECT

private slots:
    void rootsAreFoundToTheLastBits()
    {
        AwkwardStrokes random(1);
        for (int i = 0; i < 2000; ++i) {
            // A polynomial by its roots, of which one lies outside.
            std::array<double, 3> roots{random.real(0, 1), random.real(0, 1), random.real(1.1, 4)};
            std::sort(roots.begin(), roots.end());
            const auto at = [&](double p) { return (p - roots[0]) * (p - roots[1]) * (p - roots[2]); };
            const auto polar = [&](double r, double s, double t) {
                double sum = 0;
                for (const auto &[a, b, c] :
                     {std::array{r, s, t}, {r, t, s}, {s, r, t}, {s, t, r}, {t, r, s}, {t, s, r}})
                    sum += (a - roots[0]) * (b - roots[1]) * (c - roots[2]) / 6;
                return sum;
            };
            const std::array<double, 4> f{polar(0, 0, 0), polar(0, 0, 1), polar(0, 1, 1), polar(1, 1, 1)};
            QVERIFY(std::abs(bernsteinAt(f, 0.3) - at(0.3)) < 1e-14);
            const std::vector<double> found = bernsteinRoots(f);
            if (roots[1] - roots[0] < 1e-4)
                continue;
            QCOMPARE(found.size(), std::size_t(2));
            QVERIFY(std::abs(found[0] - roots[0]) < 1e-15 / (roots[1] - roots[0]));
            QVERIFY(std::abs(found[1] - roots[1]) < 1e-14 / (roots[1] - roots[0]));
        }
        QCOMPARE(bernsteinRoots(std::array{0.0, 0.0, 0.0}).size(), std::size_t(0));
        QCOMPARE(bernsteinRoots(std::array{0.0, 1.0, 0.0}), (std::vector<double>{0, 1}));
        QCOMPARE(bernsteinRoots(std::array{-1.0, 0.0, 1.0}), std::vector<double>{0.5});
        QCOMPARE(bernsteinRoots(std::array{1.0, -1.0, 1.0}).size(), std::size_t(1)); // touches at ½
        QCOMPARE(bernsteinRoots(std::array{1.0, -0.5, 1.0}).size(), std::size_t(0));
    }

    void theNearestPlaceIsNearest()
    {
        AwkwardStrokes random(2);
        for (int i = 0; i < 300; ++i) {
            const Stroke s = random.stroke(1 + random.below(4));
            const Point x = s.origin + random.point(80);
            double distance = -1;
            const CurvePlace place = nearestPlace(s, x, &distance);
            QVERIFY(std::abs(length(s.cubicOf(s.segments[std::size_t(place.segment)]).at(place.p) - x) - distance) <
                    1e-9);
            for (const Segment &g : s.segments)
                for (double p = 0; p <= 1; p += 1.0 / 200)
                    QVERIFY(length(s.cubicOf(g).at(p) - x) >= distance - 1e-9);
        }
    }

    void newNodesLeaveTheCurveAndTheValues()
    {
        AwkwardStrokes random(3);
        for (int i = 0; i < 500; ++i) {
            const Stroke s = random.stroke(1 + random.below(5));
            std::set<CurvePlace> where;
            for (int k = random.below(6); k >= 0; --k)
                where.insert({random.below(int(s.segments.size())), 0.04 * (1 + random.below(24))});
            std::vector<int> sources;
            const std::vector<CurvePlace> places(where.rbegin(), where.rend()); // in any order
            const Stroke t = withNodes(s, places, &sources);
            QCOMPARE(problemOf(t), QString());
            QCOMPARE(t.segments.size(), s.segments.size() + places.size());
            QCOMPARE(sources.size(), t.segments.size());
            QCOMPARE(t.origin, s.origin);
            auto next = where.begin();
            double from = 0;
            for (std::size_t k = 0; k < t.segments.size(); ++k) {
                const int source = sources[k];
                const Segment &before = s.segments[std::size_t(source)];
                QVERIFY(sameValues(t.segments[k], before));
                const bool isLast = k + 1 == sources.size() || sources[k + 1] != source;
                const double to = isLast ? 1 : (next++)->p;
                if (from == 0 && to == 1)
                    QCOMPARE(t.segments[k].bezier, before.bezier);
                for (double p : {0.0, 0.3, 0.7, 1.0})
                    QVERIFY(length(t.cubicOf(t.segments[k]).at(p) - s.cubicOf(before).at(from + p * (to - from))) <
                            3e-5);
                if (k > 0 && sources[k - 1] == source)
                    QCOMPARE(t.segments[k].node, NodeKind::Smooth);
                from = isLast ? 0 : to;
            }
        }
    }

    void aSplitTooNearToANodeIsNone()
    {
        const Stroke s = line({{0, 0}, {10, 0}, {20, 0}});
        for (double p : {0.0, 1e-9, 1.0, 1 - 1e-9, -1.0, 2.0, std::nan("")})
            QCOMPARE(withNodes(s, {{1, p}}), s);
        QCOMPARE(withNodes(s, {{7, 0.5}, {-1, 0.5}}), s);
        QCOMPARE(withNodes(s, {{1, 0.5}, {1, 0.5}, {1, 0.5 + 1e-9}}).segments.size(), std::size_t(3));
        // However near, nothing without length comes out.
        AwkwardStrokes random(4);
        for (int i = 0; i < 300; ++i) {
            const Stroke t = random.stroke(2);
            std::vector<CurvePlace> places;
            for (int k = 0; k < 40; ++k)
                places.push_back({random.below(2), std::pow(random.real(0, 1), 9)});
            const Stroke u = withNodes(t, places);
            QCOMPARE(problemOf(u), QString());
            QVERIFY(std::none_of(u.segments.begin(), u.segments.end(), isPoint));
        }
    }

    void deletingANewNodeRestoresTheCurve()
    {
        AwkwardStrokes random(5);
        for (int i = 0; i < 400; ++i) {
            Stroke s = random.stroke(3);
            s.segments[1].node = s.segments[2].node = NodeKind::Corner; // a symmetric one would become smooth
            std::vector<CurvePlace> places{{1, random.real(0.1, 0.9)}};
            if (i % 2)
                places.push_back({1, random.real(0.1, 0.9)});
            const Stroke t = withNodes(s, places);
            std::vector<int> nodes;
            for (int node = 2; node < 2 + int(t.segments.size() - s.segments.size()); ++node)
                nodes.push_back(node);
            std::vector<int> sources;
            const Stroke u = withoutNodes(t, nodes, &sources);
            QCOMPARE(u.segments.size(), s.segments.size());
            QCOMPARE(sources, (std::vector<int>{0, 1, 1 + int(nodes.size()) + 1}));
            QCOMPARE(u.segments[0], s.segments[0]);
            QCOMPARE(u.segments[2], s.segments[2]);
            QVERIFY(sameValues(u.segments[1], s.segments[1]));
            const double off = std::max(distanceFrom(s, u), distanceFrom(u, s));
            QVERIFY2(off < 2e-3, qPrintable(QStringLiteral("%1: %2").arg(i).arg(off)));
        }
    }

    void deletingNodesKeepsTheShapeAsFarAsOneCubicCan()
    {
        // Two quarters of a circle: the half circle that comes out is nearly round.
        const double k = 0.5522847498;
        Stroke s = line({{100, 0}, {0, 100}, {-100, 0}});
        s.segments[0].bezier = {{{100, 0}, {100, float(100 * k)}, {float(100 * k), 100}, {0, 100}}};
        s.segments[1].bezier = {{{0, 100}, {float(-100 * k), 100}, {-100, float(100 * k)}, {-100, 0}}};
        s.segments[0].density = 4;
        s.segments[1].density = 8;
        const Stroke t = withoutNodes(s, {1});
        QCOMPARE(t.segments.size(), std::size_t(1));
        QVERIFY(distanceFrom(s, t) < 2);
        QVERIFY(std::abs(t.segments[0].density - 6) < 1e-3);
        QVERIFY(std::abs(t.segments[0].bezier[1].x - 100) < 1e-4); // the tangents stay
        QVERIFY(std::abs(t.segments[0].bezier[2].x + 100) < 1e-4);

        // A corner is cut as near as can be; the ends stay.
        const Stroke corner = withoutNodes(line({{0, 0}, {30, 0}, {30, 30}}), {1});
        QCOMPARE(corner.segments.size(), std::size_t(1));
        QCOMPARE(nodePosition(corner, 0), (Point{0, 0}));
        QCOMPARE(nodePosition(corner, 1), (Point{30, 30}));
        QVERIFY(distanceFrom(line({{0, 0}, {30, 0}, {30, 30}}), corner) < 4);
    }

    void endNodesGoWithTheirSegments()
    {
        const Stroke s = line({{0, 0}, {10, 0}, {20, 0}, {30, 5}});
        Stroke t = withoutNodes(s, {0, 3});
        QCOMPARE(t.segments, std::vector<Segment>{s.segments[1]});
        QCOMPARE(withoutNodes(s, {0, 1}).segments, std::vector<Segment>{s.segments[2]});
        QCOMPARE(withoutNodes(s, {0, 1, 2}), s); // nothing would be left
        QCOMPARE(withoutNodes(s, {}), s);
        QCOMPARE(withoutNodes(s, {9, -3}), s);
    }

    void aBridgeGoesOnSmoothly()
    {
        AwkwardStrokes random(6);
        for (int i = 0; i < 300; ++i) {
            const Stroke s = random.stroke(5);
            const int first = random.below(5), last = first + random.below(5 - first);
            const Stroke t = withBridge(s, first, last);
            QCOMPARE(problemOf(t), QString());
            if (t == s) // it would be a point
                continue;
            QCOMPARE(t.segments.size(), std::size_t(5 - (last - first)));
            const auto touched = std::size_t(first);
            for (std::size_t k = 0; k < touched; ++k)
                QCOMPARE(t.segments[k], s.segments[k]);
            const std::vector<int> corners = cornersOf(t);
            QVERIFY(first == 0 || std::find(corners.begin(), corners.end(), first) == corners.end());
            QVERIFY(last == 4 || std::find(corners.begin(), corners.end(), first + 1) == corners.end());
            QCOMPARE(nodePosition(t, first), nodePosition(s, first));
            QCOMPARE(nodePosition(t, first + 1), nodePosition(s, last + 1));
        }
        QCOMPARE(withBridge(line({{0, 0}, {9, 0}}), 3, 1), line({{0, 0}, {9, 0}}));
    }

    void reversingTwiceIsNothing()
    {
        AwkwardStrokes random(7);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(1 + random.below(6));
            const Stroke r = reversed(s);
            QCOMPARE(problemOf(r), QString());
            QCOMPARE(reversed(r), s);
            const int n = int(s.segments.size());
            for (int node = 0; node <= n; ++node) {
                QCOMPARE(nodePosition(r, node), nodePosition(s, n - node));
                QCOMPARE(nodeKind(r, node), nodeKind(s, n - node));
                QCOMPARE(handlePosition(r, node, true), handlePosition(s, n - node, false));
            }
            for (int k = 0; k < n; ++k)
                QCOMPARE(r.segments[std::size_t(k)].born, s.segments[std::size_t(n - 1 - k)].born);
        }
    }

    void joiningAfterCuttingIsTheSame()
    {
        AwkwardStrokes random(8);
        for (int i = 0; i < 300; ++i) {
            const Stroke s = random.stroke(1 + random.below(4));
            const CurvePlace place{random.below(int(s.segments.size())), random.real(0.05, 0.95)};
            const std::vector<Stroke> parts = cutAt(s, {place});
            QCOMPARE(parts.size(), std::size_t(2));
            const Stroke whole = withNodes(s, {place});
            Stroke front = *joined(parts[0], true, parts[1], false);
            QCOMPARE(front.segments.size(), whole.segments.size());
            QCOMPARE(largestDifference(front, whole), 0.0);
            // Whichever end comes to whichever: the same curve.
            const Stroke back = *joined(parts[1], false, parts[0], true);
            QCOMPARE(largestDifference(back, whole), 0.0);
            const Stroke turned = *joined(reversed(parts[0]), false, reversed(parts[1]), true);
            QCOMPARE(largestDifference(reversed(turned), whole), 0.0);
            const Stroke half = *joined(parts[0], true, reversed(parts[1]), true);
            QCOMPARE(largestDifference(half, whole), 0.0);
        }
    }

    void endsApartAreBridged()
    {
        Stroke a = line({{0, 0}, {10, 0}}), b = line({{30, 0}, {40, 0}});
        b.origin = {0, 0.5};
        b.style = {StyleKind::Feathering, {1, 2, 0}};
        a.segments[0].density = 3;
        b.segments[0].density = 5;
        const Stroke t = *joined(a, true, b, false);
        QCOMPARE(problemOf(t), QString());
        QCOMPARE(t.segments.size(), std::size_t(3));
        QCOMPARE(t.segments[1].density, 3.0f);
        QCOMPARE(t.segments[2].density, 5.0f);
        QCOMPARE(t.styleOf(t.segments[2]), b.style);
        QCOMPARE(t.styleOf(t.segments[1]), a.style);
        QCOMPARE(nodePosition(t, 2), (Point{30, 0.5}));
        QVERIFY(cornersOf(t).empty());
        // To the start: a keeps its direction, and the bridge has its values.
        const Stroke u = *joined(b, false, a, true);
        QCOMPARE(u.segments.size(), std::size_t(3));
        QCOMPARE(u.segments[1].density, 5.0f);
        QCOMPARE(nodePosition(u, 3), (Point{40, 0.5}));
        QVERIFY(!closed(*closed(a)));
        QCOMPARE(nodePosition(*closed(a), 2), nodePosition(a, 0));
        // What float32 cannot hold at that origin.
        Stroke far = line({{0, 0}, {1e-3, 0}});
        far.origin = {1e9, 1e9};
        QVERIFY(!joined(a, true, far, false));
    }

    void nodesMoveWithTheirHandles()
    {
        const Stroke s = line({{0, 0}, {10, 0}, {20, 0}});
        const Stroke t = withNodeMoved(s, {1}, {0, 4});
        QCOMPARE(nodePosition(t, 1), (Point{10, 4}));
        QCOMPARE(*handlePosition(t, 1, true) - nodePosition(t, 1), *handlePosition(s, 1, true) - nodePosition(s, 1));
        QCOMPARE(t.segments[0].bezier[1], s.segments[0].bezier[1]);
        QCOMPARE(nodePosition(t, 0), nodePosition(s, 0));
        // All of them: the origin alone.
        const Stroke all = withNodeMoved(s, {0, 1, 2}, {1, 2});
        QCOMPARE(all.segments, s.segments);
        QCOMPARE(all.origin, (Point{1, 2}));
        // A segment cannot be made to vanish.
        Stroke drawnIn = s;
        drawnIn.segments[1].bezier = {{{10, 0}, {10, 0}, {20, 0}, {20, 0}}};
        const Stroke snapped = withNodeMoved(drawnIn, {2}, {-10, 0});
        QVERIFY(!isPoint(snapped.segments[1]));
        QVERIFY(length(nodePosition(snapped, 2) - Point{10, 0}) < 1e-4);
        QCOMPARE(withNodeMoved(s, {1}, {1e13, 0}), s);
    }

    void handlesKeepTheirNodesKind()
    {
        AwkwardStrokes random(9);
        for (int i = 0; i < 300; ++i) {
            for (NodeKind kind : {NodeKind::Smooth, NodeKind::Symmetric, NodeKind::Corner}) {
                Stroke s = withNodeKind(random.stroke(3), {1, 2}, kind);
                QCOMPARE(problemOf(s), QString());
                const int node = 1 + random.below(2);
                const bool after = random.below(2);
                const Point to = nodePosition(s, node) + random.point(20);
                const Stroke t = withHandleMoved(s, node, after, to);
                QCOMPARE(nodeKind(t, node), kind);
                QVERIFY(length(*handlePosition(t, node, after) - to) < 1e-4);
                const Point own = *handlePosition(t, node, after) - nodePosition(t, node);
                const Point other = *handlePosition(t, node, !after) - nodePosition(t, node);
                const Point before = *handlePosition(s, node, !after) - nodePosition(s, node);
                if (kind == NodeKind::Corner)
                    QCOMPARE(other, before);
                else
                    QVERIFY(std::abs(cross(own, other)) < 1e-4 * (length(own) + 1) && dot(own, other) <= 1e-4);
                if (kind == NodeKind::Smooth)
                    QVERIFY(std::abs(length(other) - length(before)) < 1e-4);
                if (kind == NodeKind::Symmetric)
                    QVERIFY(std::abs(length(other) - length(own)) < 1e-4);
                QCOMPARE(withHandleMoved(s, 3, true, to), s); // no handle there
            }
        }
    }

    void whatBreaksIsACornerWhateverIsStored()
    {
        Stroke corner = line({{0, 0}, {30, 0}, {30, 30}});
        for (const NodeKind stored : {NodeKind::Smooth, NodeKind::Symmetric, NodeKind::Corner}) {
            corner.segments[1].node = stored;
            QCOMPARE(nodeKind(corner, 1), NodeKind::Corner);
            const Stroke moved = withHandleMoved(corner, 1, true, {50, 20});
            QCOMPARE(*handlePosition(moved, 1, false), *handlePosition(corner, 1, false));
            const Stroke bent = withCurveDragged(corner, 1, 0.5, {10, 0});
            QCOMPARE(bent.segments[0], corner.segments[0]);
        }
    }

    void kindsMakeHandlesCollinearWhereTheyAreNot()
    {
        const Stroke corner = line({{0, 0}, {30, 0}, {30, 30}});
        QCOMPARE(cornersOf(corner), std::vector<int>{1});
        const Stroke smooth = withNodeKind(corner, {1}, NodeKind::Smooth);
        QVERIFY(cornersOf(smooth).empty());
        QCOMPARE(nodeKind(smooth, 1), NodeKind::Smooth);
        const Point out = unit(*handlePosition(smooth, 1, true) - nodePosition(smooth, 1));
        QVERIFY(length(out - Point{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-6);
        QCOMPARE(smooth.segments[0].bezier[1], corner.segments[0].bezier[1]);
        // Where they are in line, nothing but the kind changes.
        const Stroke flat = line({{0, 0}, {30, 0}, {60, 0}});
        Stroke again = withNodeKind(flat, {1}, NodeKind::Symmetric);
        again.segments[1].node = flat.segments[1].node;
        QCOMPARE(again, flat);
        // Handles that are drawn in come out.
        Stroke drawnIn = flat;
        drawnIn.segments[0].bezier[2] = drawnIn.segments[0].bezier[3];
        drawnIn.segments[1].bezier[1] = drawnIn.segments[1].bezier[0];
        const Stroke out2 = withNodeKind(drawnIn, {1}, NodeKind::Smooth);
        QCOMPARE(*handlePosition(out2, 1, true), (Point{40, 0}));
        QCOMPARE(*handlePosition(out2, 1, false), (Point{20, 0}));
        QCOMPARE(withNodeKind(flat, {0, 2, 5}, NodeKind::Corner), flat); // ends have none
    }

    void theCurveFollowsTheHand()
    {
        AwkwardStrokes random(10);
        for (int i = 0; i < 300; ++i) {
            Stroke s = random.stroke(3);
            const double p = random.real(0, 1);
            const Point by = random.point(10);
            const Stroke t = withCurveDragged(s, 1, p, by);
            const Point moved = t.cubicOf(t.segments[1]).at(p) - s.cubicOf(s.segments[1]).at(p);
            QVERIFY(length(moved - by) < 1e-4);
            if (p > 0.125) // nearer to it the node comes along, or the curve would swing out far beyond the hand
                QCOMPARE(nodePosition(t, 1), nodePosition(s, 1));
            if (p < 0.875)
                QCOMPARE(nodePosition(t, 2), nodePosition(s, 2));
            for (double q = 0; q <= 1; q += 0.05) {
                const Point there = t.cubicOf(t.segments[1]).at(q) - s.cubicOf(s.segments[1]).at(q);
                QVERIFY(length(there) <= 2 * length(by) + 1e-4);
            }
            if (nodeKind(s, 1) == NodeKind::Corner && p > 0.125)
                QCOMPARE(t.segments[0], s.segments[0]);
        }
    }
};

QTEST_APPLESS_MAIN(TestReshape)
#include "test_reshape.moc"
