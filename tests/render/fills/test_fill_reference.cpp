// The reference's fills, against closed forms and plain sums.
#include "render/reference/fill_source.h"
#include "tests/render/filled.h"

using namespace suffuse;
using namespace suffuse::test;
using reference::FillSample;
using reference::FillSource;

namespace {

const View plain = View::ofArea(Rect::of(0, 0, 100, 80), 100, 80);
constexpr Microseconds dry = 1'000'000;

FillSource sourceOf(const Stroke &stroke, const View &view = plain)
{
    return FillSource(stroke, dry, view, 6.5);
}

double edge(double x, double from, double to, double s)
{
    return 0.5 * (std::erf((x - from) / s) - std::erf((x - to) / s));
}

/// The density of a filled rectangle.
double ofRectangle(const Rect &r, Point x, double s)
{
    return edge(x.x, r.left, r.right, s) * edge(x.y, r.top, r.bottom, s);
}

Rect common(const Rect &a, const Rect &b)
{
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

} // namespace

class TestFillReference : public QObject {
    Q_OBJECT

private slots:
    void rectangles_data()
    {
        QTest::addColumn<double>("spread");
        for (const double s : {0.5, 3.0, 20.0, 400.0})
            QTest::addRow("%g", s) << s;
    }
    void rectangles()
    {
        QFETCH(double, spread);
        const Rect a = Rect::of(20, 10, 40, 30), b = Rect::of(45, 25, 30, 45);
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> u(-0.2, 1.2);
        for (const bool reversed : {false, true})
            for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd}) {
                Stroke s = emptyFill(1, spread, {});
                addRectangle(s, a);
                addRectangle(s, b, reversed);
                changeFill(s, [&](Fill &f) { f.rule = rule, f.density = 3; });
                const FillSource source = sourceOf(s);
                const bool twice = rule == FillRule::EvenOdd || reversed;
                for (int i = 0; i < 200; ++i) {
                    const Point x{100 * u(random), 80 * u(random)};
                    const double sp = std::sqrt(4 * double(s.fill->diffusion));
                    const double wanted = 3 * (ofRectangle(a, x, sp) + ofRectangle(b, x, sp) -
                                               (twice ? 2 : 1) * ofRectangle(common(a, b), x, sp));
                    QVERIFY2(std::abs(source.at(x).density - wanted) < 3e-11,
                             qPrintable(QStringLiteral("%1").arg(source.at(x).density - wanted)));
                }
            }
    }

    /// Sides that are nearly level go far aside while they rise by little.
    void nearlyLevelSides()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        for (int i = 0; i < 60; ++i) {
            const double slope = std::pow(10, -1 - 5 * u(random)) * (random() % 2 ? 1 : -1), s = 0.7 + 3 * u(random);
            Stroke stroke = emptyFill(1, s, {});
            const Point on{50, 30 + 20 * u(random)};
            addPolygon(stroke, {{-400, on.y - 450 * slope}, {500, on.y + 450 * slope}, {500, 900}, {-400, 900}});
            const FillSource source = sourceOf(stroke);
            const double spread = std::sqrt(4 * double(stroke.fill->diffusion));
            const Cubic side = offsetsOf(stroke.segments[0]); // where float32 puts it
            for (int k = 0; k < 20; ++k) {
                const double x = 100 * u(random), off = 3 * (u(random) - 0.5);
                double low = 0, high = 1;
                for (int halving = 0; halving < 60; ++halving)
                    (side.at(0.5 * (low + high)).x < x ? low : high) = 0.5 * (low + high);
                const Point way = side.derivative(low);
                const double wanted = 0.5 * std::erfc(-off * way.x / (length(way) * spread));
                const double found = source.at({x, side.at(low).y + off}).density;
                QVERIFY2(std::abs(found - wanted) < 1e-6,
                         qPrintable(QStringLiteral("%1 %2: %3").arg(slope).arg(off).arg(found - wanted)));
            }
        }
    }

    void turnedAndMirrored()
    {
        Stroke s = emptyFill(1, 4, {});
        const Rect r = Rect::of(20, 10, 40, 30);
        addRectangle(s, r);
        const View view{{50, 40}, 3, 0.7, true, 300, 240};
        const FillSource source = sourceOf(s, view);
        for (const Point x : {Point{20, 10}, Point{30, 38}, Point{61, 12}, Point{40, 25}})
            QVERIFY(std::abs(source.at(view.toPixels(x)).density - ofRectangle(r, x, 4)) < 1e-11);
    }

    /// The gradient is the density's, and the place the mean of what comes to a point: of a linear ramp over all the
    /// plane it would be the ramp.
    void gradients()
    {
        std::mt19937_64 random(7);
        for (int i = 0; i < 30; ++i) {
            Stroke s = randomFill(random, 1, 100, 80, 5);
            changeFill(s, [](Fill &f) { f.gradient = {{-500, 0}, {700, 50}, {}}; });
            const FillSource source = sourceOf(s);
            const Point x{50, 40};
            const double h = 1e-4;
            const double dx = (source.at(x + Point{h, 0}).density - source.at(x - Point{h, 0}).density) / (2 * h);
            const double dy = (source.at(x + Point{0, h}).density - source.at(x - Point{0, h}).density) / (2 * h);
            QVERIFY2(std::abs(source.at(x).gradient.x - dx) < 1e-7 && std::abs(source.at(x).gradient.y - dy) < 1e-7,
                     qPrintable(QStringLiteral("%1 %2 %3 %4")
                                    .arg(source.at(x).gradient.x)
                                    .arg(dx)
                                    .arg(source.at(x).gradient.y)
                                    .arg(dy)));
        }
        Stroke s = emptyFill(1, 6, {});
        addRectangle(s, Rect::of(-1000, -1000, 3000, 3000));
        changeFill(s, [](Fill &f) { f.gradient = {{10, 0}, {90, 40}, {}}; });
        const FillSource source = sourceOf(s);
        QVERIFY(std::abs(source.at({10, 0}).place) < 1e-10 && std::abs(source.at({50, 20}).place - 0.5) < 1e-10);
        QCOMPARE(source.at({0, 0}).place, 0.0);
    }

    /// Against the sum over a fine grid of points, inside by the sign of an implicit function.
    void curvesAndTensors()
    {
        for (const bool tensor : {false, true}) {
            Stroke s = emptyFill(1, 5, {});
            addEllipse(s, {50, 40}, 30, 18);
            addEllipse(s, {55, 42}, 10, 9, true);
            if (tensor)
                changeFill(s, [](Fill &f) { f.anisotropyRatio = 4, f.anisotropyAngle = 0.5f; });
            const FillSource source = sourceOf(s);
            const double along = std::cos(0.5), across = std::sin(0.5), ratio = tensor ? 4 : 1;
            for (const Point x : {Point{50, 22}, Point{55, 42}, Point{64, 45}, Point{83, 40}, Point{30, 30}}) {
                double sum = 0;
                const double step = 0.05;
                for (double py = 0.5 * step; py < 80; py += step)
                    for (double px = 0.5 * step; px < 100; px += step) {
                        const auto in = [&](double cx, double cy, double rx, double ry) {
                            return std::hypot((px - cx) / rx, (py - cy) / ry) < 1;
                        };
                        if (!in(50, 40, 30, 18) || in(55, 42, 10, 9))
                            continue;
                        const double u = along * (px - x.x) + across * (py - x.y);
                        const double v = along * (py - x.y) - across * (px - x.x);
                        sum += std::exp(-(u * u / ratio + v * v) / 25);
                    }
                sum *= step * step / (std::numbers::pi * 25 * std::sqrt(ratio));
                // Four cubics miss a circle by up to 2.7e-4 of its radius.
                QVERIFY2(std::abs(source.at(x).density - sum) < 1.5e-3,
                         qPrintable(QStringLiteral("%1 %2").arg(source.at(x).density).arg(sum)));
            }
        }
    }

    void crispIsCoverage()
    {
        Stroke s = emptyFill(1, 1e-4, {});
        addPolygon(s, {{10.25, 10.5}, {20.75, 10.5}, {20.75, 30.125}, {10.25, 30.125}});
        addPolygon(s, {{40, 10}, {60, 30}, {40, 30}});
        const FillSource source = sourceOf(s);
        QVERIFY(source.crisp());
        const auto covered = [&](double x, double y) { return source.covered({x, y}, 1); };
        QVERIFY(std::abs(covered(10.5, 20.5) - 0.75) < 1e-6);
        QVERIFY(std::abs(covered(10.5, 10.5) - 0.375) < 1e-6);
        QVERIFY2(std::abs(covered(15.5, 30.5) - 0.125) < 1e-6, "in the middle of a level edge");
        QVERIFY(std::abs(covered(20.5, 30.5) - 0.75 * 0.125) < 1e-6);
        QVERIFY(std::abs(covered(45.5, 15.5) - 0.5) < 1e-6);
        QCOMPARE(covered(15.5, 15.5), 1.0);
        QCOMPARE(covered(30.5, 15.5), 0.0);
        QVERIFY(std::abs(source.covered({10.25, 20}, 0.5) - 0.5) < 1e-6);
    }

    void nothingIsNothing()
    {
        Stroke s = emptyFill(1, 5, {});
        addPolygon(s, {{10, 10}, {60, 40}});           // there and back
        addPolygon(s, {{30, 30}, {30, 30}});           // a point
        addPolygon(s, {{10, 70}, {90, 70}, {50, 70}}); // a line
        const FillSource source = sourceOf(s);
        for (const Point x : {Point{10, 10}, Point{35, 25}, Point{50, 70}})
            QVERIFY(source.at(x).density < 1e-7); // Points a third of the way are rounded to float.
    }
};

QTEST_GUILESS_MAIN(TestFillReference)
#include "test_fill_reference.moc"
