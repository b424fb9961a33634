// The boundary of what lies inside an outline, against winding numbers counted at points.
#include "model/area/boundary.h"
#include "model/area/outline.h"
#include "model/paint/fill_density.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/fill_cut.h"
#include "tests/model/area/windings.h"
#include "tests/model/awkward_strokes.h"
#include "tests/trials.h"

#include <QElapsedTimer>
#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Loop = std::vector<Cubic>;

Cubic straight(Point a, Point b)
{
    return {{a, a + (1.0 / 3) * (b - a), a + (2.0 / 3) * (b - a), b}};
}

Loop polygon(const std::vector<Point> &corners)
{
    Loop loop;
    for (std::size_t k = 0; k < corners.size(); ++k)
        if (corners[k] != corners[(k + 1) % corners.size()])
            loop.push_back(straight(corners[k], corners[(k + 1) % corners.size()]));
    return loop;
}

Loop rectangle(double x, double y, double width, double height)
{
    return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

Loop reversed(Loop loop)
{
    std::reverse(loop.begin(), loop.end());
    for (Cubic &c : loop)
        std::reverse(c.p.begin(), c.p.end());
    return loop;
}

bool isInside(int winding, FillRule rule)
{
    return rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
}

/// How much of the plane left of a point is entered and not left.
int enteredAt(const AreaBoundary &boundary, Point x)
{
    int entered = 0;
    for (const BoundaryArc &b : boundary.arcs)
        if (b.arc.top() <= x.y && x.y < b.arc.bottom() && b.arc.xAt(x.y) < x.x)
            entered += b.enters;
    return entered;
}

/// Along every vertical line inside begins and ends where arcs cross it or flats lie.
QString problemAlong(const AreaBoundary &boundary, double x, double top, double bottom)
{
    const auto changeTo = [&](double y) {
        int change = 0;
        for (const BoundaryArc &b : boundary.arcs) {
            const double from = std::max(b.arc.top(), top), to = std::min(b.arc.bottom(), y);
            if (to <= from)
                continue;
            const bool leftAtFrom = b.arc.xAt(from) < x, leftAtTo = b.arc.xAt(to) < x;
            change += b.enters * (int(leftAtTo) - int(leftAtFrom));
        }
        for (const BoundaryFlat &f : boundary.flats)
            if (f.y > top && f.y <= y && f.left < x && x <= f.right)
                change += f.jump;
        return change;
    };
    const int before = enteredAt(boundary, {x, top});
    for (int i = 1; i <= 40; ++i) {
        const double y = top + (bottom - top) * i / 40;
        if (const int is = enteredAt(boundary, {x, y}); is != before + changeTo(y))
            return QStringLiteral("%1 %2: %3 and %4").arg(x).arg(y).arg(is).arg(before + changeTo(y));
    }
    return {};
}

QString problemOf(const std::vector<Loop> &loops, std::mt19937 &random, double size, double near)
{
    std::uniform_real_distribution<double> u(-0.05 * size, 1.05 * size);
    for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd}) {
        const AreaBoundary boundary = boundaryOf(loops, rule);
        for (int i = 0; i < 60; ++i) {
            const Point x{u(random), u(random)};
            const int entered = enteredAt(boundary, x);
            if (entered != 0 && entered != 1)
                return QStringLiteral("entered %1 times at %2, %3").arg(entered).arg(x.x).arg(x.y);
            const bool inside = isInside(windingAt(loops, x), rule);
            if (entered != int(inside) && distanceTo(loops, x) > near)
                return QStringLiteral("rule %1: %2 at %3, %4").arg(int(rule)).arg(entered).arg(x.x).arg(x.y);
        }
        for (int i = 0; i < 4; ++i)
            if (const QString problem = problemAlong(boundary, u(random), -1, size + 1); !problem.isEmpty())
                return problem;
    }
    return {};
}

double areaOf(const AreaBoundary &boundary)
{
    double area = 0;
    for (const BoundaryArc &b : boundary.arcs)
        for (int i = 0; i < 1000; ++i) {
            const Point p = b.arc.curve.at((i + 0.5) / 1000), d = b.arc.curve.derivative((i + 0.5) / 1000);
            area -= b.enters * p.x * d.y / 1000;
        }
    return area;
}

} // namespace

class TestArea : public QObject {
    Q_OBJECT

private slots:
    void outlines()
    {
        Stroke s = line({{0, 0}, {10, 0}, {0, 10}});
        QCOMPARE(closedOutline(s).size(), std::size_t(1));
        QCOMPARE(closedOutline(s)[0].size(), std::size_t(3)); // It is closed.
        QCOMPARE(closedOutline(s)[0].back().p[3], Point());
        appendChain(s, line({{100, 0}, {110, 0}, {120, 0}, {120, 10}}).segments);
        s.segments[3].lift = true;
        const auto loops = closedOutline(s);
        QCOMPARE(loops.size(), std::size_t(2));
        QCOMPARE(loops[1].size(), std::size_t(4)); // A straight line stands for what takes paint away.
        Stroke point = line({{5, 5}, {5, 5}});
        QVERIFY(closedOutline(point).empty());
        s.segments[2].lift = s.segments[4].lift = true;
        QCOMPARE(closedOutline(s).size(), std::size_t(1));
    }

    void simpleOutlinesStayWhole()
    {
        const AreaBoundary boundary = boundaryOf({rectangle(0, 0, 10, 5)}, FillRule::NonZero);
        QCOMPARE(boundary.arcs.size(), std::size_t(2));
        QCOMPARE(boundary.flats.size(), std::size_t(2));
        QCOMPARE(boundary.flats[0], (BoundaryFlat{0, 0, 10, 1}));
        QCOMPARE(boundary.flats[1], (BoundaryFlat{5, 0, 10, -1}));
        // A second one in the first is no boundary, or a hole.
        const std::vector<Loop> same{rectangle(0, 0, 10, 10), rectangle(2, 2, 5, 5)};
        const std::vector<Loop> hole{rectangle(0, 0, 10, 10), reversed(rectangle(2, 2, 5, 5))};
        QCOMPARE(boundaryOf(same, FillRule::NonZero).arcs.size(), std::size_t(2));
        QCOMPARE(boundaryOf(same, FillRule::EvenOdd).arcs.size(), std::size_t(4));
        QCOMPARE(areaOf(boundaryOf(same, FillRule::EvenOdd)), 75.0);
        QCOMPARE(areaOf(boundaryOf(hole, FillRule::NonZero)), 75.0);
    }

    /// Shapes that touch, share edges and lie on each other.
    void touching_data()
    {
        QTest::addColumn<QVector<QVector<QPointF>>>("loops");
        QTest::addColumn<double>("nonZero");
        QTest::addColumn<double>("evenOdd");
        using Points = QVector<QVector<QPointF>>;
        const QVector<QPointF> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, back{{0, 4}, {4, 4}, {4, 0}, {0, 0}};
        QTest::newRow("one twice") << Points{square, square} << 16.0 << 0.0;
        QTest::newRow("there and back") << Points{square, back} << 0.0 << 0.0;
        QTest::newRow("three times") << Points{square, square, back} << 16.0 << 16.0;
        QTest::newRow("side by side") << Points{square, {{4, 0}, {8, 0}, {8, 4}, {4, 4}}} << 32.0 << 32.0;
        QTest::newRow("side by side, against") << Points{square, {{4, 4}, {8, 4}, {8, 0}, {4, 0}}} << 32.0 << 32.0;
        QTest::newRow("part of an edge") << Points{square, {{4, 1}, {8, 1}, {8, 3}, {4, 3}}} << 24.0 << 24.0;
        QTest::newRow("corner on corner") << Points{square, {{4, 4}, {8, 4}, {8, 8}, {4, 8}}} << 32.0 << 32.0;
        QTest::newRow("corner on edge") << Points{square, {{4, 2}, {8, 0}, {8, 4}}} << 24.0 << 24.0;
        QTest::newRow("inside, sharing an edge") << Points{square, {{0, 1}, {2, 1}, {2, 3}, {0, 3}}} << 16.0 << 12.0;
        QTest::newRow("hole, sharing an edge") << Points{square, {{0, 3}, {2, 3}, {2, 1}, {0, 1}}} << 12.0 << 12.0;
        QTest::newRow("bow tie") << Points{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}} << 8.0 << 8.0;
        QTest::newRow("line") << Points{{{0, 0}, {4, 4}}} << 0.0 << 0.0;
        QTest::newRow("spike") << Points{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {-5, 2}, {0, 2}}} << 16.0 << 16.0;
        QTest::newRow("crossing at a corner") << Points{{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}} << 8.0 << 8.0;
        QTest::newRow("pentagram") << Points{{{0, -10},
                                              {5.877852522924731, 8.090169943749475},
                                              {-9.510565162951535, -3.090169943749474},
                                              {9.510565162951535, -3.090169943749474},
                                              {-5.877852522924731, 8.090169943749475}}}
                                   << 112.256994144896 << 77.5677;
    }
    void touching()
    {
        QFETCH(QVector<QVector<QPointF>>, loops);
        QFETCH(double, nonZero);
        QFETCH(double, evenOdd);
        std::vector<Loop> outline;
        for (const auto &loop : loops) {
            std::vector<Point> corners;
            for (const QPointF &p : loop)
                corners.push_back({p.x(), p.y()});
            outline.push_back(polygon(corners));
        }
        QVERIFY2(std::abs(areaOf(boundaryOf(outline, FillRule::NonZero)) - nonZero) < 1e-4,
                 qPrintable(QString::number(areaOf(boundaryOf(outline, FillRule::NonZero)))));
        QVERIFY2(std::abs(areaOf(boundaryOf(outline, FillRule::EvenOdd)) - evenOdd) < 1e-4,
                 qPrintable(QString::number(areaOf(boundaryOf(outline, FillRule::EvenOdd)))));
    }

    /// Corners on a coarse grid: nearly every one lies on something.
    void randomOnAGrid()
    {
        std::mt19937 random(3);
        for (int i = 0; i < trials(1000, 90'000); ++i) {
            std::vector<Loop> loops;
            for (unsigned n = 1 + random() % 3; n > 0; --n) {
                std::vector<Point> corners;
                for (unsigned k = 2 + random() % 7; k > 0; --k)
                    corners.push_back({double(random() % 6), double(random() % 6)});
                loops.push_back(polygon(corners));
            }
            const QString problem = problemOf(loops, random, 6, 0.1);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("trial %1: %2").arg(i).arg(problem)));
        }
    }

    void randomCurves()
    {
        AwkwardStrokes awkward(5);
        std::mt19937 random(4);
        for (int i = 0; i < trials(300, 18'000); ++i) {
            std::vector<Loop> loops;
            for (int n = 1 + awkward.below(2); n > 0; --n) {
                Loop loop;
                Point at{50 + awkward.real(-40, 40), 50 + awkward.real(-40, 40)};
                const Point first = at;
                for (int k = 1 + awkward.below(6); k > 0; --k) {
                    const auto c = awkward.curve(at, 40);
                    loop.push_back({c});
                    at = c[3];
                }
                if (at != first)
                    loop.push_back(straight(at, first));
                loops.push_back(loop);
                if (awkward.below(4) == 0)
                    loops.push_back(awkward.below(2) ? loop : reversed(loop));
            }
            const QString problem = problemOf(loops, random, 100, 0.7);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("trial %1: %2").arg(i).arg(problem)));
        }
    }

    /// The pieces of cut fills lie on each other along the cuts, in single precision: lines that are nearly one cross
    /// at any place, and cubics that stand for straight lines bend both ways.
    void piecesOfCutFills()
    {
        AwkwardStrokes awkward(7);
        std::mt19937 random(6);
        for (int i = 0; i < trials(300, 18'000); ++i) {
            Stroke s = line({});
            s.fill = Fill{};
            for (int n = 1 + awkward.below(3); n > 0; --n) {
                Stroke chain;
                Point at{awkward.real(0, 100), awkward.real(0, 100)};
                for (int k = 2 + awkward.below(5); k > 0; --k) {
                    const Point b{awkward.real(0, 100), awkward.real(0, 100)},
                        c{awkward.real(0, 100), awkward.real(0, 100)};
                    const Point to{awkward.real(0, 100), awkward.real(0, 100)};
                    Segment g;
                    g.bezier = n % 2 ? toOffsets(straight(at, to)) : toOffsets(Cubic{{at, b, c, to}});
                    if (!chain.segments.empty())
                        g.bezier[0] = chain.segments.back().bezier[3];
                    g.density = 0;
                    chain.segments.push_back(g);
                    at = to;
                }
                appendChain(s, chain.segments);
            }
            for (int k = 0; k < 3; ++k) {
                const double from = awkward.real(-20, 120), to = awkward.real(-20, 120);
                s = filledCut(s, {-20, from}, {120, to});
            }
            const QString problem = problemOf(closedOutline(s), random, 100, 1e-4);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("trial %1: %2").arg(i).arg(problem)));
        }
    }

    /// An arc far from an edit keeps its bits.
    void editsAreLocal()
    {
        std::vector<Point> corners;
        for (int k = 0; k < 400; ++k)
            corners.push_back({100 * std::cos(k * 0.0157) * (1 + 0.1 * (k % 3)), 100 * std::sin(k * 0.0157)});
        const AreaBoundary before = boundaryOf({polygon(corners)}, FillRule::NonZero);
        corners[100] = corners[100] + Point{3, 4};
        const AreaBoundary after = boundaryOf({polygon(corners)}, FillRule::NonZero);
        std::size_t gone = 0;
        for (const BoundaryArc &b : before.arcs)
            gone += std::find(after.arcs.begin(), after.arcs.end(), b) == after.arcs.end();
        QVERIFY2(gone <= 8, qPrintable(QString::number(gone)));
    }

    void manySegments()
    {
        std::mt19937 random(8);
        std::uniform_real_distribution<double> u(-1, 1);
        Loop walk;
        Point at{500, 500};
        for (int k = 0; k < 20'000; ++k) {
            const Point to = at + Point{4 * u(random), 4 * u(random)};
            walk.push_back(straight(at, to));
            at = to;
        }
        walk.push_back(straight(at, {500, 500}));
        QElapsedTimer timer;
        timer.start();
        const AreaBoundary boundary = boundaryOf({walk}, FillRule::NonZero);
        qInfo("%d arcs in %d ms", int(boundary.arcs.size()), int(timer.elapsed()));
        for (int i = 0; i < 200; ++i) {
            const Point x{500 + 200 * u(random), 500 + 200 * u(random)};
            QCOMPARE(enteredAt(boundary, x), int(windingAt({walk}, x) != 0));
        }
    }

    /// Wide arcs lie over narrow ones, and steep ones beside ones that are nearly level.
    void arcsOfAllWidths()
    {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> u(0, 1);
        for (int turn = 0; turn < 6; ++turn) {
            Loop walk;
            Point at{50, 50};
            for (int k = 0; k < 300; ++k) {
                const double size = std::exp2(-10 * u(random)), bend = size * 100 * u(random);
                const auto near = [&](Point p) {
                    return p + Point{bend * (u(random) - 0.5), bend * (u(random) - 0.5)};
                };
                const Point to = at + size * (Point{100 * u(random), 100 * u(random)} - at);
                walk.push_back({{at, near(at), near(to), to}});
                at = to;
            }
            walk.push_back(straight(at, {50, 50}));
            QCOMPARE(problemOf({walk}, random, 100, 1e-3), QString());
        }
    }

    void chordsTellWhereArcsLie()
    {
        std::mt19937 random(10);
        std::uniform_real_distribution<double> u(0, 1);
        int told = 0;
        for (int i = 0; i < 20'000; ++i) {
            const double far = i % 3 == 0 ? 1e9 : 0, height = std::exp2(-30 * u(random));
            std::array<double, 2> x{u(random), u(random)}, y{height * u(random), height * u(random)};
            std::ranges::sort(x), std::ranges::sort(y);
            const RisingArc arc{
                {{Point{far, far}, {far + x[0], far + y[0]}, {far + x[1], far + y[1]}, {far + 1, far + height}}}};
            const double level = arc.top() + (arc.bottom() - arc.top()) * u(random), near = 1e-3 * u(random);
            const Point p{far + 1.2 * u(random) - 0.1, level};
            const int side = arc.bottom() > arc.top() ? ArcChord(arc).sideOf(p.x, p.y, near) : 0;
            told += side != 0;
            if (side < 0)
                QVERIFY(arc.xAt(level) < p.x - near);
            if (side > 0)
                QVERIFY(arc.xAt(level) > p.x + near);
        }
        QVERIFY(told > 20'000 / 10);
    }

    /// What lies in a window is found without what lies elsewhere: the cost of a click is that of what is clicked on.
    void aWindowSeesTheSameLoops()
    {
        std::mt19937 random(12);
        std::uniform_real_distribution<double> u(-1, 1);
        Stroke walk = line({{0, 0}, {1, 1}});
        walk.segments.clear();
        Point at{0, 0};
        Segment segment = line({{0, 0}, {1, 1}}).segments.front();
        for (int k = 0; k < 4000; ++k) {
            const Point to = 0.99 * at + Point{20 * u(random), 20 * u(random)};
            const Cubic c = straight(at, to);
            for (std::size_t i = 0; i < 4; ++i)
                segment.bezier[i] = {float(c.p[i].x), float(c.p[i].y)};
            walk.segments.push_back(segment);
            at = Point() + segment.bezier[3];
        }
        Fill fill;
        fill.density = 1, fill.maxAge = 1, fill.diffusion = 1;
        walk.fill = fill;
        const std::vector<Loop> loops = closedOutline(walk);
        const DensityOfFill whole(walk, 10'000'000);
        for (int i = 0; i < 10; ++i) {
            const Point middle{100 * u(random), 100 * u(random)};
            const Rect window = Rect{middle.x, middle.y, middle.x, middle.y}.grown(10);
            const std::vector<Loop> shortened = shortenedAround(window, loops);
            QVERIFY(shortened.empty() || shortened[0].size() < loops[0].size() / 4);
            for (int k = 0; k < 10; ++k) {
                const Point x = middle + Point{10 * u(random), 10 * u(random)};
                QCOMPARE(windingAt(shortened, x, 1), windingAt(loops, x, 1));
            }
            // Both are right to about a thousandth.
            QVERIFY(std::abs(DensityOfFill(walk, 10'000'000, middle)(middle).density - whole(middle).density) < 2e-3);
        }
    }
};

QTEST_GUILESS_MAIN(TestArea)
#include "test_area.moc"
