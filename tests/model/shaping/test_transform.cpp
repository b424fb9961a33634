// Affine maps of strokes: curves, spread and density.
#include "model/painting/tensor.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/transform.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

#include <numbers>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// The dry density of a mapped stroke at map(at), as seen before the map, where its spread is even.
double densityAt(const Stroke &stroke, Point at, const Affine &map)
{
    const Affine back = *map.inverse();
    double sum = 0;
    for (const Segment &g : stroke.segments) {
        const Tensor tensor = mapped(tensorOf(g), back);
        const double squared = 4 * tensor.xx * toSeconds(g.driesAt() - g.born); // s²
        const Cubic c = stroke.cubicOf(g);
        const int steps = 400;
        for (int k = 0; k < steps; ++k) {
            const double p = (k + 0.5) / steps;
            const Point d = back(c.at(p)) - at;
            const double weight = g.density / std::abs(map.determinant()) * length(c.derivative(p)) / steps;
            sum += weight * std::exp(-dot(d, d) / squared) / (std::numbers::pi * squared);
        }
    }
    return sum;
}

} // namespace

class TestTransform : public QObject {
    Q_OBJECT

private slots:
    /// A fill that does not spread, as drawings of other programs come in, has no directions to be scaled in.
    void crispFillsStayCrisp()
    {
        AwkwardStrokes random(31);
        Stroke s = random.stroke(4);
        for (const float ratio : {1.0f, 3.0f}) {
            Fill fill;
            fill.diffusion = 0;
            fill.anisotropyRatio = ratio;
            s.fill = fill;
            for (const Affine &map : {Affine::scaling({5, 7}, 1.379, 1.358), Affine::scaling({}, -0.2, 40),
                                      Affine::rotation({1, 2}, 0.7), Affine{1, 0.4, 0.1, 1, {3, 4}}}) {
                const std::optional<Stroke> scaled = tryTransformed(s, map, SpreadRule::Scales);
                QVERIFY(scaled);
                QCOMPARE(scaled->fill->diffusion, 0.0f);
                QCOMPARE(scaled->fill->anisotropyRatio, ratio);
                QCOMPARE(scaled->fill->density, fill.density);
            }
        }
    }

    /// Where paint is laid curves are cut, so that its spread follows their direction; bounds of fills stay whole.
    void outlinesWithoutPaintStayWhole()
    {
        Stroke s;
        s.id = 1;
        Segment arc;
        arc.bezier = {Offset{0, 0}, {0, 40}, {60, 100}, {100, 100}};
        arc.diffusion = 1;
        arc.density = 5;
        s.segments = {arc};
        s.fill = Fill{};
        const Affine uneven = Affine::scaling({}, 3, 0.5);
        QVERIFY(transformed(s, uneven, SpreadRule::Scales).segments.size() > 3);
        s.segments[0].density = 0;
        const Stroke scaled = transformed(s, uneven, SpreadRule::Scales);
        QCOMPARE(scaled.segments.size(), std::size_t(1));
        QCOMPARE(scaled.segments[0].bezier[3].x, 300.0f);
        QVERIFY(!scaled.fill->isIsotropic());
    }

    void evenMapsScaleSpreadAndDensityExactly()
    {
        AwkwardStrokes random(13);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(3);
            const Point fixed = random.point(100);
            const Stroke twice = transformed(s, Affine::scaling(fixed, 2, 2), SpreadRule::Scales);
            const Stroke stays = transformed(s, Affine::scaling(fixed, 2, 2), SpreadRule::Stays);
            const double angle = random.real(-3, 3);
            const Stroke turned = transformed(s, Affine::rotation(fixed, angle), SpreadRule::Scales);
            const Stroke mirrored = transformed(s, Affine::scaling(fixed, -1, 1), SpreadRule::Scales);
            for (std::size_t k = 0; k < 3; ++k) {
                const Segment &a = s.segments[k];
                QCOMPARE(twice.segments[k].diffusion, 4 * a.diffusion);
                QCOMPARE(twice.segments[k].density, 2 * a.density);
                QCOMPARE(twice.segments[k].anisotropyAngle, a.anisotropyAngle);
                QVERIFY(sameValues(stays.segments[k], a));
                QCOMPARE(stays.segments[k].bezier, twice.segments[k].bezier);
                QCOMPARE(turned.segments[k].diffusion, a.diffusion);
                QCOMPARE(turned.segments[k].density, a.density);
                QCOMPARE(mirrored.segments[k].diffusion, a.diffusion);
                if (a.isIsotropic())
                    continue;
                QVERIFY(std::abs(turned.segments[k].anisotropyAngle - (a.anisotropyAngle + angle)) < 1e-5);
                const double straight = mirrored.segments[k].anisotropyAngle + a.anisotropyAngle;
                QVERIFY(std::abs(std::sin(straight)) < 1e-5); // the sum is half a turn
            }
            QVERIFY(largestDifference(mirrored, transformed(mirrored, Affine(), SpreadRule::Scales)) == 0);
            const Stroke back = transformed(mirrored, Affine::scaling(fixed, -1, 1), SpreadRule::Scales);
            QVERIFY(largestDifference(back, s) < 1e-9);
            // Moves leave the segments.
            const Stroke moved = transformed(s, Affine::translation({3, 4}), SpreadRule::Scales);
            QCOMPARE(moved.segments, s.segments);
            QCOMPARE(moved.origin, (s.origin + Point{3, 4}));
        }
    }

    void turningKeepsItsPrecisionAtDeepZoom()
    {
        // A stroke of a millionth of a unit far from the canvas's corner.
        AwkwardStrokes random(14);
        for (int i = 0; i < 100; ++i) {
            Stroke s = random.stroke(3);
            for (Segment &g : s.segments)
                for (Offset &o : g.bezier)
                    o = {o.x * 1e-8f, o.y * 1e-8f};
            const double size = polygonLength(offsetsOf(s.segments[0]));
            const Stroke t = transformed(s, Affine::rotation(s.origin, 1), SpreadRule::Scales);
            const Stroke back = transformed(t, Affine::rotation(s.origin, -1), SpreadRule::Scales);
            QVERIFY(length(back.origin - s.origin) < 1e-12);
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t p = 0; p < 4; ++p)
                    QVERIFY(length((Point() + back.segments[k].bezier[p]) - (Point() + s.segments[k].bezier[p])) <
                            1e-5 * size + resolutionAt(offsetsOf(s.segments[k])));
        }
    }

    void unevenMapsMakeTensorsAndKeepTheAmount()
    {
        AwkwardStrokes random(15);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(3);
            const Affine map = Affine::about(random.point(50), random.real(0.3, 3), random.real(-1, 1),
                                             random.real(-1, 1), random.real(-3, -0.3));
            if (std::abs(map.determinant()) < 0.5)
                continue; // nearly flat: float32 shows in the directions
            std::vector<int> sources;
            const Stroke t = *tryTransformed(s, map, SpreadRule::Scales, &sources);
            QCOMPARE(problemOf(t), QString());
            QCOMPARE(sources.size(), t.segments.size());
            const Affine back = *map.inverse();
            for (std::size_t k = 0; k < t.segments.size(); ++k) {
                const Segment &g = t.segments[k], &source = s.segments[std::size_t(sources[k])];
                const Tensor expected = mapped(tensorOf(source), map), tensor = tensorOf(g);
                const double scale = expected.xx + expected.yy;
                QVERIFY(std::abs(tensor.xx - expected.xx) < 1e-5 * scale);
                QVERIFY(std::abs(tensor.xy - expected.xy) < 1e-5 * scale);
                QVERIFY(std::abs(tensor.yy - expected.yy) < 1e-5 * scale);
                // φ′|dl′| = φ·|det A|·|dl|, within 1 % everywhere, but in what is shorter than the spread.
                const Cubic c = offsetsOf(g);
                double before = 0;
                for (int p = 0; p < 256; ++p)
                    before += length(back.turned(c.at((p + 1) / 256.0) - c.at(p / 256.0)));
                const double s1 = source.spread(source.driesAt()) * std::sqrt(std::min(1.0f, source.anisotropyRatio));
                const double uneven = before < 1.01 * s1 ? 0.07 * s1 / before : 0.01;
                double off = 0;
                for (double p = 1.0 / 64; p < 1; p += 1.0 / 32) {
                    const Point d = c.derivative(p);
                    const double wanted =
                        source.density * std::abs(map.determinant()) * length(back.turned(d)) / length(d);
                    off = std::max(off, std::abs(g.density / wanted - 1));
                }
                QVERIFY2(off < 1.1 * uneven + 0.01 || before < s1 / 64,
                         qPrintable(QStringLiteral("%1/%2: off by %3, length %4, spread %5")
                                        .arg(i)
                                        .arg(k)
                                        .arg(off)
                                        .arg(before)
                                        .arg(s1)));
            }
            QVERIFY(distanceFrom(t, transformed(s, map, SpreadRule::Stays)) < 1e-3);
        }
    }

    /// A bent stroke, mapped unevenly: in few parts, and the dry density is that of the mapped picture.
    void unevenMapsKeepTheDensity_data()
    {
        QTest::addColumn<double>("spread");
        QTest::addColumn<int>("most"); ///< segments of the mapped stroke
        QTest::newRow("wide") << 60.0 << 12;
        QTest::newRow("as the curve bends") << 20.0 << 24;
        QTest::newRow("thin") << 6.0 << 48;
        QTest::newRow("a line") << 0.5 << 400;
    }
    void unevenMapsKeepTheDensity()
    {
        QFETCH(double, spread);
        QFETCH(int, most);
        Stroke s;
        s.id = 1;
        for (const auto &bezier : {std::array<Offset, 4>{{{0, 0}, {0, 44}, {36, 80}, {80, 80}}},
                                   std::array<Offset, 4>{{{80, 80}, {124, 80}, {160, 44}, {160, 0}}}}) {
            Segment g;
            g.bezier = bezier;
            g.diffusion = float(spread * spread / 4);
            s.segments.push_back(g);
        }
        const Affine map = Affine::about({}, 2, 0.3, 0, 1);
        const Stroke t = *tryTransformed(s, map, SpreadRule::Scales);
        QVERIFY2(int(t.segments.size()) <= most, qPrintable(QString::number(t.segments.size())));
        double worst = 0, peak = 0;
        for (int i = -20; i < 220; i += 3)
            for (double aside : {0.0, 0.6 * spread}) {
                // Beside the arc of radius 80 about (80, 0), and beyond its ends.
                const double angle = (i - 100) / 100.0 * 1.6, radius = 80 + aside;
                const Point at{80 + radius * std::sin(angle), radius * std::cos(angle)};
                const double wanted = densityAt(s, at, Affine()), found = densityAt(t, at, map);
                worst = std::max(worst, std::abs(wanted - found));
                peak = std::max(peak, wanted);
            }
        qInfo("spread %g: %zu segments, off by %.3f %% of the peak", spread, t.segments.size(), 100 * worst / peak);
        QVERIFY(worst < 0.006 * peak);
    }

    void mapsThatCannotBeChangeNothing()
    {
        AwkwardStrokes random(16);
        const Stroke s = random.stroke(3);
        for (const Affine &map :
             {Affine::scaling({}, 0, 1), Affine::scaling({}, 1e13, 1e13), Affine::scaling({}, 1e-60, 1),
              Affine::translation({1e13, 0}), Affine{std::nan(""), 0, 0, 1, {}}}) {
            QVERIFY(!tryTransformed(s, map, SpreadRule::Scales));
            QCOMPARE(transformed(s, map, SpreadRule::Scales), s);
        }
        const Affine map = Affine::about({3, 4}, 1, 2, 3, 4), round = *map.inverse() * map;
        QVERIFY(std::abs(round.a - 1) + std::abs(round.b) + std::abs(round.c) + std::abs(round.d - 1) < 1e-14);
        QVERIFY(length(round({5, 6}) - Point{5, 6}) < 1e-12);
        QCOMPARE(map({3, 4}), (Point{3, 4}));
        QCOMPARE(Affine::between(Rect::of(0, 0, 2, 2), Rect::of(1, 1, 4, 6))({2, 1}), (Point{5, 4}));
        QCOMPARE(Affine::rotation({}, std::acos(-1) / 2)({1, 0}), (Point{0, 1}));
    }

    void boxesAreTight()
    {
        AwkwardStrokes random(17);
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(3);
            Rect sampled;
            for (const Segment &g : s.segments)
                for (int k = 0; k <= 2000; ++k)
                    sampled.include(s.cubicOf(g).at(k / 2000.0));
            const Rect box = curveBox(s);
            for (const auto &[a, b] : {std::pair{box.left, sampled.left}, {box.top, sampled.top}})
                QVERIFY(a <= b + 1e-9 && a > b - 1e-3);
            for (const auto &[a, b] : {std::pair{box.right, sampled.right}, {box.bottom, sampled.bottom}})
                QVERIFY(a >= b - 1e-9 && a < b + 1e-3);
        }
    }
};

QTEST_APPLESS_MAIN(TestTransform)
#include "test_transform.moc"
