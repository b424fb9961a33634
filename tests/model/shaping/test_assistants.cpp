// Assistants: where the points of a stroke are put, and which of them a stroke follows.
#include "model/geometry/assistant.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace suffuse;

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double reach = 20;

Assistant ruler(Point a, Point b)
{
    return {AssistantKind::Ruler, {a, b}};
}

Assistant vanishing(Point at)
{
    return {AssistantKind::VanishingPoint, {at}};
}

Assistant ellipse(AssistantKind kind, Point centre, double a, double b, double angle)
{
    return Assistant{kind, {centre, centre, centre}}.withForm({a, b, angle});
}

/// How far a point is from the ellipse of a track, by its equation: 0 on it.
double offEllipse(const AssistantTrack &track, Point p)
{
    const Point d = p - track.origin;
    return std::hypot(dot(track.along, d) / track.first, cross(track.along, d) / track.second) - 1;
}

/// The nearest of many points of an ellipse, which is no farther than the nearest one of all by their spacing.
double distanceByWalking(const AssistantTrack &track, Point p)
{
    constexpr int steps = 20'000;
    double least = endless;
    for (int i = 0; i < steps; ++i) {
        const double t = 2 * std::numbers::pi * i / steps;
        const Point at = track.origin + track.first * std::cos(t) * track.along +
                         track.second * std::sin(t) * Point{-track.along.y, track.along.x};
        least = std::min(least, length(at - p));
    }
    return least;
}

} // namespace

class TestAssistants : public QObject {
    Q_OBJECT

private slots:
    /// The foot of a normal of the ellipse, and no other point is nearer.
    void nearestPointsOfEllipses_data()
    {
        QTest::addColumn<double>("a");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("angle");
        QTest::newRow("circle") << 100.0 << 100.0 << 0.0;
        QTest::newRow("level") << 200.0 << 80.0 << 0.0;
        QTest::newRow("upright") << 80.0 << 200.0 << 0.0;
        QTest::newRow("turned") << 300.0 << 120.0 << 0.7;
        QTest::newRow("flat") << 500.0 << 2.0 << -2.1;
        QTest::newRow("small") << 1e-3 << 4e-4 << 1.0;
        QTest::newRow("huge") << 1e8 << 3e7 << 1.0;
    }
    void nearestPointsOfEllipses()
    {
        QFETCH(double, a);
        QFETCH(double, b);
        QFETCH(double, angle);
        const auto track = *ellipse(AssistantKind::Ellipse, {12, -7}, a, b, angle).ownTrack();
        const double size = std::max(a, b);
        const Point across{-track.along.y, track.along.x};
        std::mt19937 random(7);
        std::uniform_real_distribution<double> spread(-1.6, 1.6);
        for (int i = 0; i < 200; ++i) {
            double x = spread(random) * size, y = spread(random) * size;
            if (i % 5 == 0) // on the axes, where formulas have their corners
                (i % 2 ? x : y) = 0;
            const Point p = track.origin + x * track.along + y * across;
            const Point at = track.nearest(p);
            QVERIFY(std::abs(offEllipse(track, at)) <= 1e-6);
            const double walked = distanceByWalking(track, p);
            QVERIFY2(length(at - p) <= walked + 1e-6 * size, qPrintable(QString::number(length(at - p) - walked)));
            const Point d = at - track.origin;
            const Point normal =
                (dot(track.along, d) / (a * a)) * track.along + (cross(track.along, d) / (b * b)) * across;
            const double away = length(p - at);
            if (away > 1e-6 * size)
                QVERIFY(std::abs(cross(normal, p - at)) / (length(normal) * away) <= 1e-6);
        }
    }

    void pointsOnAnEllipseStay()
    {
        const auto track = *ellipse(AssistantKind::Ellipse, {500, 400}, 300, 100, 0.4).ownTrack();
        for (int i = 0; i < 100; ++i) {
            const double t = 0.0628 * i;
            const Point p = track.origin + 300 * std::cos(t) * track.along +
                            100 * std::sin(t) * Point{-track.along.y, track.along.x};
            QVERIFY(length(track.nearest(p) - p) <= 1e-6);
        }
    }

    /// A stroke from `start` by way of `now`, and where a later point of it comes.
    void strokesAreLed_data()
    {
        QTest::addColumn<std::vector<Assistant>>("assistants");
        QTest::addColumn<Point>("start");
        QTest::addColumn<Point>("now");
        QTest::addColumn<Point>("later");
        QTest::addColumn<Point>("put");
        using enum AssistantKind;
        using List = std::vector<Assistant>;
        const auto row = [](const char *name, const List &list, Point start, Point now, Point later, Point put) {
            QTest::newRow(name) << list << start << now << later << put;
        };
        const List level{ruler({0, 100}, {300, 100})};
        row("a ruler", level, {50, 108}, {60, 110}, {400, 130}, {400, 100});
        row("backwards", level, {50, 108}, {40, 106}, {10, 130}, {10, 100});
        row("beyond its points", level, {900, 108}, {910, 110}, {950, 130}, {950, 100});
        row("too far from a ruler", level, {50, 130}, {60, 130}, {400, 130}, {400, 130});
        row("across a ruler", level, {50, 105}, {50, 115}, {52, 130}, {52, 130});
        const List parallel{{Parallel, {{0, 0}, {30, 40}}}};
        row("parallel lines", parallel, {500, 100}, {507, 108}, {560, 180}, {560, 180});
        row("beside parallel lines", parallel, {500, 100}, {507, 108}, {600, 100}, {536, 148});
        row("across parallel lines", parallel, {500, 100}, {508, 94}, {600, 100}, {600, 100});
        const List point{vanishing({1000, 200})};
        row("to a vanishing point", point, {0, 0}, {10, 1}, {500, 90}, {498.07692307692, 99.615384615385});
        row("away from it", point, {900, 200}, {890, 201}, {700, 230}, {700, 200});
        row("not to it", point, {0, 200}, {0, 210}, {30, 400}, {30, 400});
        row("out of it", point, {1005, 200}, {1005, 210}, {1005, 400}, {1000, 400}); // near enough: a ray of it
        const List two{vanishing({-1000, 0}), vanishing({1000, 0})};
        row("to the right of two", two, {0, 500}, {9, 496}, {200, 400}, {200, 400});
        row("to the left of two", two, {0, 500}, {-9, 496}, {-200, 400}, {-200, 400});
        const List grid{{Perspective, {{100, 100}, {300, 150}, {300, 250}, {100, 300}}}};
        row("to where the long sides meet", grid, {0, 200}, {10, 201}, {400, 230}, {400, 200});
        row("along the parallel ones", grid, {50, 0}, {51, 10}, {70, 90}, {50, 90});
        const List box{{Perspective, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}}};
        row("a rectangle has none", box, {500, 500}, {510, 502}, {700, 530}, {700, 500});
        const List round{ellipse(Ellipse, {500, 500}, 200, 200, 0)};
        row("an ellipse", round, {500, 290}, {510, 291}, {800, 500}, {700, 500});
        row("not near an ellipse", round, {500, 400}, {510, 400}, {800, 500}, {800, 500});
        const List rings{ellipse(Concentric, {500, 500}, 200, 100, 0)};
        row("a ring elsewhere", rings, {500, 300}, {510, 300}, {1000, 500}, {900, 500});
        row("across a ring", rings, {500, 300}, {500, 310}, {500, 400}, {500, 400});
        const List both{vanishing({1000, 104}), ruler({0, 100}, {300, 100})};
        row("a ruler before lines that are everywhere", both, {50, 108}, {60, 108.4}, {400, 130}, {400, 100});
        row("none", {}, {50, 108}, {60, 108}, {400, 130}, {400, 130});
    }
    void strokesAreLed()
    {
        QFETCH(std::vector<Assistant>, assistants);
        QFETCH(Point, start);
        QFETCH(Point, now);
        QFETCH(Point, later);
        QFETCH(Point, put);
        const auto track = trackOf(assistants, start, now, reach);
        const Point at = track ? track->nearest(later) : later;
        QVERIFY2(length(at - put) <= 1e-6, qPrintable(QString("%1, %2").arg(at.x, 0, 'g', 15).arg(at.y, 0, 'g', 15)));
    }

    /// Whatever is missing or out of hand, a stroke is free, or its points are finite.
    void senselessOnesDoNoHarm()
    {
        using enum AssistantKind;
        const std::vector<std::vector<Point>> some{
            {},
            {{5, 5}},
            {{noNumber, 5}},
            {{5, 5}, {5, 5}},
            {{5, 5}, {endless, 5}},
            {{1e13, 0}, {0, 0}},
            {{5, 5}, {5, 5}, {5, 5}},
            {{5, 5}, {9, 5}, {9, 5}},
            {{5, 5}, {5, 5}, {5, 9}},
            {{5, 5}, {5 + 1e-300, 5}, {5, 5 + 1e-300}},
            {{5, 5}, {1e12, 5}, {5, 6}},
            {{5, 5}, {5, 5}, {5, 5}, {5, 5}},
            {{0, 0}, {10, 0}, {20, 0}, {30, 0}},
            {{0, 0}, {10, 10}, {10, 0}, {0, 10}},
            {{0, 0}, {1e12, 0}, {1e12, 1e-9}, {0, 1e12}},
        };
        const Point places[] = {{5, 5}, {5, 6}, {0, 0}, {10, 0}, {1e11, -1e11}, {noNumber, 0}, {0, endless}};
        for (int kind = 0; kind <= int(Concentric); ++kind)
            for (const std::vector<Point> &points : some)
                for (const Point &start : places)
                    for (const Point &now : places) {
                        const auto track = trackOf({{AssistantKind(kind), points}}, start, now, reach);
                        if (!track)
                            continue;
                        const Point at = track->nearest({7, 8});
                        QVERIFY(std::isfinite(at.x) && std::isfinite(at.y));
                        const Point none = track->nearest({noNumber, 8});
                        QVERIFY(std::isnan(none.x) && none.y == 8);
                    }
        QVERIFY(!Assistant({Ruler, {{0, 0}}}).isSound());
        QVERIFY(!vanishing({noNumber, 0}).isSound());
        QVERIFY(vanishing({1e12, 0}).isSound());
    }

    /// Half axes keep their right angle, and the one that is not dragged its length.
    void pointsOfEllipsesAreDragged()
    {
        const Assistant one = Assistant::between(AssistantKind::Ellipse, {100, 100}, {300, 200});
        QCOMPARE(one.points, (std::vector<Point>{{200, 150}, {300, 150}, {200, 200}}));
        const Assistant turned = one.withPoint(1, {200, 350});
        QVERIFY(std::abs(turned.form().first - 200) < 1e-9 && std::abs(turned.form().second - 50) < 1e-9);
        QVERIFY(length(turned.points[2] - Point{150, 150}) < 1e-9);
        const Assistant wide = one.withPoint(2, {260, 90});
        QCOMPARE(wide.points[2], (Point{200, 90}));
        QCOMPARE(wide.points[1], one.points[1]);
        const Assistant moved = one.withPoint(0, {210, 150});
        QCOMPARE(moved.points, one.movedBy({10, 0}).points);
        const Assistant again = one.withForm(one.form());
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY(length(again.points[i] - one.points[i]) < 1e-9);
    }

    void vanishingPointsOfPerspectives()
    {
        const Assistant grid{AssistantKind::Perspective, {{100, 100}, {300, 150}, {300, 250}, {100, 300}}};
        const std::vector<Point> found = grid.vanishingPoints(); // the upright sides meet nowhere
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(length(found[0] - Point{500, 200}) < 1e-9);
        QVERIFY(Assistant::between(AssistantKind::Perspective, {0, 0}, {50, 20}).vanishingPoints().empty());
    }
};

QTEST_APPLESS_MAIN(TestAssistants)
#include "test_assistants.moc"
