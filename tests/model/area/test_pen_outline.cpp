// The areas that pens cover: each point of the plane is inside or outside as its distance from the line says.
#include "model/area/boundary.h"
#include "model/area/offset_curve.h"
#include "model/area/pen_outline.h"

#include "tests/model/area/windings.h"
#include "tests/trials.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Loops = std::vector<std::vector<Cubic>>;

double distanceFrom(const std::vector<PenLine> &lines, Point at)
{
    double nearest = HUGE_VAL;
    for (const PenLine &line : lines)
        for (const Cubic &curve : line.curves) {
            Point a = curve.p[0];
            for (int i = 1; i <= 200; ++i) {
                const Point b = curve.at(i / 200.0), along = b - a;
                const double size = dot(along, along);
                const double share = size > 0 ? std::clamp(dot(at - a, along) / size, 0.0, 1.0) : 0;
                nearest = std::min(nearest, length(at - (a + share * along)));
                a = b;
            }
        }
    return nearest;
}

/// The area within loops, by Green's theorem over what boundaryOf finds.
double areaWithin(const Loops &loops)
{
    double area = 0;
    for (const BoundaryArc &part : boundaryOf(loops, FillRule::NonZero).arcs) {
        double below = 0; // ∫ x dy, exact for cubics by three points
        for (const auto &[t, weight] :
             {std::pair{0.1127016653792583, 5.0 / 18}, {0.5, 8.0 / 18}, {0.8872983346207417, 5.0 / 18}})
            below += weight * part.arc.curve.at(t).x * part.arc.curve.derivative(t).y;
        area -= part.enters * below;
    }
    return area;
}

PenLine polyline(const std::vector<Point> &points, bool closed = false)
{
    PenLine line;
    for (std::size_t i = 1; i < points.size(); ++i)
        line.curves.push_back(straightCubic(points[i - 1], points[i]));
    if (closed)
        line.curves.push_back(straightCubic(points.back(), points.front()));
    line.isClosed = closed;
    return line;
}

bool isNear(double a, double b, double tolerance = 1e-6)
{
    if (std::abs(a - b) <= tolerance)
        return true;
    qWarning("%.9g, not %.9g", a, b);
    return false;
}

constexpr double tight = 1e-4;

} // namespace

class TestPenOutline : public QObject {
    Q_OBJECT

private slots:
    /// With round joins and caps the area is all that is near enough, whatever the curve does.
    void roundPensReachAllThatIsNear()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(0, 100), share(0, 1);
        for (int trial = 0; trial < trials(60, 2000); ++trial) {
            std::vector<PenLine> lines(1);
            Point at{place(random), place(random)};
            const Point first = at;
            for (int k = 0, curves = 1 + trial % 3; k < curves; ++k) {
                Cubic c{{at,
                         {place(random), place(random)},
                         {place(random), place(random)},
                         {place(random), place(random)}}};
                if (trial % 5 == 1) // a curve that bends at its ends alone
                    c.p[1] = c.p[0] + 0.01 * (c.p[1] - c.p[0]), c.p[2] = c.p[3];
                if (trial % 5 == 2) // a cusp
                    c.p[3] = c.p[0] + Point{20, 0}, c.p[1] = c.p[0] + Point{20, 30}, c.p[2] = c.p[0] + Point{0, 30};
                if (trial % 5 == 3) // a line that turns back
                    c.p[1] = at + 1.5 * (c.p[3] - at), c.p[2] = at - 0.5 * (c.p[3] - at);
                at = c.p[3];
                lines[0].curves.push_back(c);
            }
            if ((lines[0].isClosed = trial % 2 == 1))
                lines[0].curves.push_back(straightCubic(at, first));
            const Pen pen{std::pow(10, -0.5 + 2.2 * share(random)), LineCap::Round, LineJoin::Round, 4, {}, 0};
            const double tolerance = 0.01, half = 0.5 * pen.width;
            const Loops loops = penOutline(lines, pen, tolerance);
            for (int i = 0; i < 400; ++i) {
                const Point p{-20 + 1.4 * place(random), -20 + 1.4 * place(random)};
                const double distance = distanceFrom(lines, p);
                const double slack = tolerance + 5e-4 * half + 0.02;
                if (std::abs(distance - half) <= slack)
                    continue;
                const int winding = windingAt(loops, p, 16);
                QVERIFY2((winding != 0) == (distance < half) && winding >= 0,
                         qPrintable(QStringLiteral("trial %1, (%2, %3): %4 around, distance %5 of %6")
                                        .arg(trial)
                                        .arg(p.x)
                                        .arg(p.y)
                                        .arg(winding)
                                        .arg(distance)
                                        .arg(half)));
            }
        }
    }

    /// A line that takes too much work ends with the effort: one that turns everywhere, and one of too many dashes.
    void effortIsBounded()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(0, 100);
        std::vector<PenLine> lines(1);
        for (int i = 0; i < 10'000; ++i) {
            Cubic curve;
            for (Point &p : curve.p) {
                p.x = place(random);
                p.y = place(random);
            }
            lines[0].curves.push_back(curve);
        }
        AreaEffort effort(1'000'000);
        const Loops part = penOutline(lines, {1e5, LineCap::Butt, LineJoin::Miter, 4, {}, 0}, tight, &effort);
        QVERIFY(effort.isSpent());
        std::size_t curves = 0;
        for (const std::vector<Cubic> &loop : part)
            curves += loop.size();
        QVERIFY2(curves < 100'000, qPrintable(QString::number(curves)));
        AreaEffort forDashes(1'000'000);
        penOutline({polyline({{0, 0}, {90, 0}})}, {1, LineCap::Butt, LineJoin::Miter, 4, {0.001}, 0}, tight,
                   &forDashes);
        QVERIFY(forDashes.isSpent());
        AreaEffort enough(1'000'000);
        QCOMPARE(
            penOutline({polyline({{0, 0}, {90, 0}})}, {1, LineCap::Butt, LineJoin::Miter, 4, {}, 0}, tight, &enough)
                .size(),
            std::size_t(1));
        QVERIFY(!enough.isSpent());
    }

    void joins()
    {
        const std::vector<PenLine> corner{polyline({{0, 0}, {100, 0}, {100, 100}})};
        Pen pen{20, LineCap::Butt, LineJoin::Miter, 4, {}, 0};
        QVERIFY(isNear(areaWithin(penOutline(corner, pen, tight)), 2 * 2000));
        pen.join = LineJoin::Bevel;
        QVERIFY(isNear(areaWithin(penOutline(corner, pen, tight)), 2 * 2000 - 50));
        pen.join = LineJoin::Round;
        QVERIFY(isNear(areaWithin(penOutline(corner, pen, tight)), 2 * 2000 - 100 + 25 * std::numbers::pi, 0.05));
        // At a right angle a miter is √2 as long as the line is wide.
        pen.join = LineJoin::Miter, pen.miterLimit = 1.42;
        QVERIFY(isNear(areaWithin(penOutline(corner, pen, tight)), 2 * 2000));
        pen.miterLimit = 1.41;
        QVERIFY(isNear(areaWithin(penOutline(corner, pen, tight)), 2 * 2000 - 50));
        // A closed line has a join where it began, in whichever direction it runs.
        pen.miterLimit = 4;
        for (const auto &points : {std::vector<Point>{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                                   std::vector<Point>{{0, 0}, {0, 100}, {100, 100}, {100, 0}}})
            QVERIFY(isNear(areaWithin(penOutline({polyline(points, true)}, pen, tight)), 120 * 120 - 80 * 80));
        // Where the line goes back on itself a miter would have no end.
        const std::vector<PenLine> back{polyline({{0, 0}, {100, 0}, {0, 0}})};
        QVERIFY(isNear(areaWithin(penOutline(back, pen, tight)), 2000));
        pen.join = LineJoin::Round;
        QVERIFY(isNear(areaWithin(penOutline(back, pen, tight)), 2000 + 50 * std::numbers::pi, 0.1));
    }

    void caps()
    {
        const std::vector<PenLine> line{polyline({{10, 10}, {40, 50}})};
        Pen pen{10, LineCap::Butt, LineJoin::Miter, 4, {}, 0};
        QVERIFY(isNear(areaWithin(penOutline(line, pen, tight)), 500));
        pen.cap = LineCap::Square;
        QVERIFY(isNear(areaWithin(penOutline(line, pen, tight)), 600));
        pen.cap = LineCap::Round;
        QVERIFY(isNear(areaWithin(penOutline(line, pen, tight)), 500 + 25 * std::numbers::pi, 0.05));
        // Points have caps alone.
        PenLine point;
        point.point = {7, 8};
        QVERIFY(isNear(areaWithin(penOutline({point}, pen, tight)), 25 * std::numbers::pi, 0.05));
        pen.cap = LineCap::Square;
        point.direction = {0.6, 0.8};
        const Loops square = penOutline({point}, pen, tight);
        QVERIFY(isNear(areaWithin(square), 100));
        QVERIFY(windingAt(square, Point{7, 8} + 4.9 * Point{-0.8 + 0.6, 0.6 + 0.8}) != 0);
        pen.cap = LineCap::Butt;
        QVERIFY(penOutline({point}, pen, tight).empty());
        pen.width = 0;
        QVERIFY(penOutline(line, pen, tight).empty());
    }

    void dashes()
    {
        const auto spans = [](const PenLine &line, const std::vector<double> &pattern, double offset) {
            QString text;
            for (const PenLine &dash : dashesOf(line, pattern, offset)) {
                const Point from = dash.curves.empty() ? dash.point : dash.curves.front().p[0];
                const Point to = dash.curves.empty() ? dash.point : dash.curves.back().p[3];
                text += QStringLiteral("%1-%2 ").arg(from.x + from.y).arg(to.x + to.y);
            }
            return text.trimmed();
        };
        const PenLine line = polyline({{0, 0}, {10, 0}, {30, 0}});
        QCOMPARE(spans(line, {4, 2}, 0), QString("0-4 6-10 12-16 18-22 24-28"));
        QCOMPARE(spans(line, {12, 3}, 0), QString("0-12 15-27"));
        QCOMPARE(spans(line, {4, 2}, 1), QString("0-3 5-9 11-15 17-21 23-27 29-30"));
        QCOMPARE(spans(line, {4, 2}, -1), QString("1-5 7-11 13-17 19-23 25-29"));
        QCOMPARE(spans(line, {7}, 0), QString("0-7 14-21 28-30"));
        QCOMPARE(spans(line, {7}, 7), QString("7-14 21-28"));
        QCOMPARE(spans(line, {5, 2, 1}, 0), QString("0-5 7-8 13-15 16-21 23-24 29-30"));
        QCOMPARE(spans(line, {0, 10}, 0), QString("0-0 10-10 20-20 30-30"));
        QCOMPARE(spans(line, {}, 0), QString("0-30"));
        QCOMPARE(spans(line, {0, 0}, 0), QString("0-30"));
        QCOMPARE(spans(line, {100, 1}, 0), QString("0-30"));
        QCOMPARE(spans(line, {1e-9, 1e-9}, 0), QString("0-30")); // too many to be drawn
        // The lengths on the way around a square of 10 by 10; the first and the last dash are one.
        const PenLine square = polyline({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true);
        QCOMPARE(dashesOf(square, {6, 4}, 0).size(), std::size_t(4));
        const std::vector<PenLine> around = dashesOf(square, {6, 4}, 3);
        QCOMPARE(around.size(), std::size_t(4));
        QCOMPARE(around[0].curves.size(), std::size_t(2));
        QVERIFY(length(around[0].curves[0].p[0] - Point{0, 3}) < 1e-9);
        QVERIFY(length(around[0].curves[1].p[3] - Point{3, 0}) < 1e-9 && !around[0].isClosed);
        QVERIFY(dashesOf(square, {50, 4}, 0)[0].isClosed);
    }

    /// Along a quarter of a circle the dashes are as long as their angles say.
    void dashesAlongCurves()
    {
        PenLine quarter;
        quarter.curves = arcAround({0, 0}, {100, 0}, 0.5 * std::numbers::pi);
        const double degree = 100 * std::numbers::pi / 180;
        const std::vector<PenLine> dashes = dashesOf(quarter, {10 * degree, 4 * degree}, 0);
        QCOMPARE(dashes.size(), std::size_t(7));
        for (std::size_t i = 0; i < dashes.size(); ++i) {
            const Point from = dashes[i].curves.front().p[0], to = dashes[i].curves.back().p[3];
            QVERIFY(isNear(std::atan2(from.y, from.x) * 180 / std::numbers::pi, 14.0 * double(i), 0.02));
            QVERIFY(
                isNear(std::atan2(to.y, to.x) * 180 / std::numbers::pi, std::min(90.0, 14.0 * double(i) + 10), 0.02));
        }
    }

    /// A ring's outline has few curves: a circle's offset is a circle.
    void gentleCurvesStayFew()
    {
        PenLine circle;
        circle.curves = arcAround({50, 50}, {80, 50}, 2 * std::numbers::pi);
        circle.isClosed = true;
        const Loops ring = penOutline({circle}, {20, LineCap::Butt, LineJoin::Miter, 4, {}, 0}, 0.01);
        QCOMPARE(ring.size(), std::size_t(2));
        QVERIFY2(ring[0].size() <= 16 && ring[1].size() <= 16, qPrintable(QString::number(ring[0].size())));
        QVERIFY(isNear(areaWithin(ring), std::numbers::pi * (1600 - 400), 2));
    }
};

QTEST_APPLESS_MAIN(TestPenOutline)
#include "test_pen_outline.moc"
