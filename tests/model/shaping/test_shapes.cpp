// Outlines of shapes, and strokes along them.
#include "model/shaping/shapes.h"

#include "model/brush/brush.h"
#include "model/brush/brush_width.h"
#include "model/painting/validate.h"

#include <QTest>

#include <random>

using namespace suffuse;

namespace {

/// The area within a closed outline, by the shoelace formula over many points of it.
double areaOf(const std::vector<Cubic> &outline)
{
    double twice = 0;
    constexpr int steps = 400;
    for (const Cubic &curve : outline)
        for (int i = 0; i < steps; ++i) {
            const Point a = curve.at(double(i) / steps), b = curve.at(double(i + 1) / steps);
            twice += a.x * b.y - a.y * b.x;
        }
    return 0.5 * twice;
}

/// How far apart the ends and beginnings of neighbours are, the last and the first one included.
double gapOf(const std::vector<Cubic> &outline)
{
    double gap = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        gap = std::max(gap, length(outline[i].p[3] - outline[(i + 1) % outline.size()].p[0]));
    return gap;
}

constexpr double pi = std::numbers::pi;

} // namespace

class TestShapes : public QObject {
    Q_OBJECT

private slots:
    void rectanglesHaveTheirArea()
    {
        ShapeForm form;
        const auto outline = [&] { return outlineOf(form, {30, 20}, {10, 70}); }; // from any corner to any
        QCOMPARE(outline().size(), std::size_t(4));
        QVERIFY(std::abs(areaOf(outline()) - 1000) < 1e-9);
        form.radius = 5;
        QCOMPARE(outline().size(), std::size_t(8));
        QVERIFY(std::abs(areaOf(outline()) - (1000 - (4 - pi) * 25)) < 0.05);
        form.radius = 1e5; // half of the shorter side
        QCOMPARE(outline().size(), std::size_t(6));
        QVERIFY(std::abs(areaOf(outline()) - (1000 - (4 - pi) * 100)) < 0.2);
        QVERIFY(gapOf(outline()) == 0);
    }

    void ellipsesKeepToTheirEquation()
    {
        ShapeForm form{ShapeKind::Ellipse};
        const std::vector<Cubic> outline = outlineOf(form, {0, 0}, {200, 100});
        QVERIFY(gapOf(outline) == 0);
        for (const Cubic &curve : outline)
            for (int i = 0; i <= 20; ++i) {
                const Point p = curve.at(i / 20.0);
                QVERIFY(std::abs(std::hypot((p.x - 100) / 100, (p.y - 50) / 50) - 1) < 3e-4);
            }
        form.from = 0.3;
        form.sweep = pi;
        QVERIFY(std::abs(areaOf(outlineOf(form, {0, 0}, {200, 100})) - pi * 5000 / 2) < 3);
        form.sweep = 0.5 * pi;
        QVERIFY(std::abs(areaOf(outlineOf(form, {0, 0}, {200, 100})) - pi * 5000 / 4) < 2);
        form.isPie = false; // the triangle is away
        QVERIFY(std::abs(areaOf(outlineOf(form, {0, 0}, {200, 100})) - (pi * 5000 / 4 - 2500)) < 2);
    }

    void polygonsAndStarsHaveTheirCorners()
    {
        ShapeForm form{ShapeKind::Polygon};
        form.corners = 6;
        const Point middle{40, 40}, tip{40, 10};
        QVERIFY(std::abs(areaOf(outlineOf(form, middle, tip)) - 1.5 * std::sqrt(3) * 900) < 1e-9);
        QVERIFY(length(outlineOf(form, middle, tip).front().p[0] - tip) < 1e-12);
        form.kind = ShapeKind::Star;
        form.inner = 0.5;
        const std::vector<Cubic> star = outlineOf(form, middle, tip);
        QCOMPARE(star.size(), std::size_t(12));
        QVERIFY(std::abs(areaOf(star) - 12 * 0.5 * 30 * 15 * std::sin(pi / 6)) < 1e-9);
        QVERIFY(gapOf(star) == 0);
        form.rounding = 1; // no straight part is left
        QCOMPARE(outlineOf(form, middle, tip).size(), std::size_t(12));
        QVERIFY(gapOf(outlineOf(form, middle, tip)) < 1e-12);
    }

    void whatHasNoSizeHasNoOutline()
    {
        ShapeForm form;
        QVERIFY(outlineOf(form, {1, 1}, {1, 5}).empty());
        form.kind = ShapeKind::Ellipse;
        QVERIFY(outlineOf(form, {1, 1}, {5, 1}).empty());
        form.kind = ShapeKind::Star;
        QVERIFY(outlineOf(form, {1, 1}, {1, 1}).empty());
        QVERIFY(strokeAlong({}, builtinBrushes().front(), 7, 0).segments.empty());
    }

    void anyFormIsASoundStroke()
    {
        std::mt19937 random(7);
        const auto between = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
        for (int i = 0; i < 3000; ++i) {
            ShapeForm form;
            form.kind = ShapeKind(i % 4);
            form.radius = between(0, 40);
            form.rounding = between(0, 1);
            form.corners = int(between(3, 12));
            form.inner = between(0.01, 1);
            form.from = between(-7, 7);
            form.sweep = between(0.01, 2 * pi);
            form.isPie = i % 8 < 4;
            const std::vector<Cubic> outline =
                outlineOf(form, {between(-50, 50), between(-50, 50)}, {between(-50, 50), between(-50, 50)});
            QVERIFY(gapOf(outline) < 1e-9);
            const Brush &brush = builtinBrushes()[std::size_t(i) % builtinBrushes().size()];
            const Stroke stroke = strokeAlong(outline, brush, 5, 1'000'000);
            QCOMPARE(problemOf(stroke), QString());
            const Offset first = stroke.segments.front().bezier[0], last = stroke.segments.back().bezier[3];
            QVERIFY(std::hypot(first.x - last.x, first.y - last.y) < 1e-4f);
            QCOMPARE(stroke.segments.front().born, Microseconds(1'000'000));
            QCOMPARE(stroke.segments.back().colour, brush.colour);
        }
    }

    /// Corners are corners, and round places are smooth.
    void nodesHaveTheirKinds()
    {
        ShapeForm form;
        const auto kinds = [&] {
            QString kinds;
            for (const Segment &segment : strokeAlong(outlineOf(form, {0, 0}, {60, 40}), {}, 1, 0).segments)
                kinds += segment.node == NodeKind::Smooth ? 's' : 'c';
            return kinds;
        };
        QCOMPARE(kinds(), QString("cccc"));
        form.radius = 10;
        QCOMPARE(kinds(), QString("ssssssss"));
        form.kind = ShapeKind::Ellipse;
        QCOMPARE(kinds(), QString("ssss"));
        form.sweep = 1.5 * pi;
        QCOMPARE(kinds(), QString("csscc"));
    }
};

QTEST_APPLESS_MAIN(TestShapes)
#include "test_shapes.moc"
