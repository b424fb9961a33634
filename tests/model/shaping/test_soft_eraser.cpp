// The soft eraser: where it takes paint away, how much, and what it leaves alone.
#include "model/paint/half_width.h"
#include "model/paint/point_density.h"
#include "model/paint/seen_paint.h"
#include "model/painting/influence.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/soft_eraser.h"
#include "tests/model/awkward_strokes.h"

#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Rows of straight segments to and fro, dry at 10 s: a wash from (0, 0) to (300, 200), at a visible density.
Stroke wash(double spread, double rows = 12)
{
    Stroke stroke;
    stroke.id = 7;
    stroke.style = {StyleKind::Uniform, {1, 0.1f, 0}};
    const double step = 200 / rows;
    std::vector<Point> corners;
    for (int k = 0; k <= int(rows); ++k)
        for (const double x : k % 2 ? std::vector<double>{300, 200, 100, 0} : std::vector<double>{0, 100, 200, 300})
            corners.push_back({x, k * step});
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        Segment s;
        const Point a = corners[k], third = (1.0 / 3) * (corners[k + 1] - a);
        s.bezier = toOffsets({{a, a + third, corners[k + 1] - third, corners[k + 1]}});
        s.bezier[0] = k ? stroke.segments.back().bezier[3] : s.bezier[0];
        s.diffusion = float(spread * spread / 4);
        s.maxAge = 1;
        s.density = float(densityOfPeak(2.2, spread));
        s.born = Microseconds(k) * 20'000;
        stroke.segments.push_back(s);
    }
    return stroke;
}

constexpr Microseconds dry = 10'000'000;

std::vector<PenSample> line(Point from, Point to, float pressure = 1, Microseconds time = dry)
{
    std::vector<PenSample> samples;
    for (int i = 0; i <= 40; ++i)
        samples.push_back({from + (i / 40.0) * (to - from), time + i * 16'000, pressure});
    return samples;
}

Stroke erasedBy(const SoftTip &tip, const Stroke &stroke, const std::vector<PenSample> &samples, Microseconds T = dry)
{
    SoftEraser eraser(tip, {std::make_shared<const Stroke>(stroke)}, T);
    for (const PenSample &sample : samples)
        eraser.add(sample);
    eraser.finish();
    return eraser.erased(stroke);
}

double seenAt(const Stroke &stroke, Point point)
{
    return seenPaint(stroke, stroke.driesAt(), point).opacity;
}

/// How far beside the middle of the path from (150, −50) down paint is gone, in steps of half a unit.
double clearedAt(const Stroke &stroke, double y)
{
    double gone = 0;
    while (gone < 100 && seenAt(stroke, {150 + gone, y}) < 0.5)
        gone += 0.5;
    return gone;
}

} // namespace

class TestSoftEraser : public QObject {
    Q_OBJECT

private slots:
    /// At full strength, whatever its softness and however the paint has spread.
    void paintEndsAtTheRadius()
    {
        for (const double spread : {12.0, 25.0})
            for (const double softness : {0.4, 0.6, 1.0, 1.6})
                for (const double radius : {12.0, 25.0}) {
                    const SoftTip tip{radius, softness, 1};
                    const Stroke after = erasedBy(tip, wash(spread), line({150, -60}, {150, 260}));
                    QCOMPARE(problemOf(after), QString());
                    QVERIFY(after.hasErasure());
                    for (const double y : {60.0, 100.0, 140.0}) {
                        const double gone = clearedAt(after, y);
                        QVERIFY2(std::abs(gone - radius) < 0.2 * radius,
                                 qPrintable(QStringLiteral("spread %1, softness %2, radius %3: %4 at %5")
                                                .arg(spread)
                                                .arg(softness)
                                                .arg(radius)
                                                .arg(gone)
                                                .arg(y)));
                    }
                }
    }

    void halfTheStrengthReachesTheMiddle()
    {
        const Stroke before = wash(14);
        const auto density = [](const Stroke &s) { return strokeDensityAt(s, s.driesAt(), {150, 100}); };
        double last = density(before);
        for (const double strength : {0.1, 0.3, 0.6, 1.0}) {
            const Stroke after = erasedBy({20, 0.6, strength}, before, line({150, -60}, {150, 260}));
            QVERIFY(density(after) < last || last == 0);
            last = density(after);
            QCOMPARE(seenAt(after, {150, 100}) > 0.5, strength < 0.5);
        }
        // The pressure of a pen is a share of the strength.
        const Stroke pressed = erasedBy({20, 0.6, 1}, before, line({150, -60}, {150, 260}, 0.3f));
        const Stroke weak = erasedBy({20, 0.6, 0.3}, before, line({150, -60}, {150, 260}));
        QVERIFY(std::abs(density(pressed) - density(weak)) < 0.01);
    }

    /// Half of the strength takes half of what is seen of it, and less takes less.
    void featheredPaintGetsPaler()
    {
        Stroke before = wash(14);
        before.style = {StyleKind::Feathering, {3, 1, 0}};
        const auto seen = [](const Stroke &s) { return seenAt(s, {150, 100}); };
        QVERIFY(seen(before) > 0.8);
        for (const double softness : {0.4, 0.6, 1.0, 1.6}) {
            double last = seen(before);
            for (const double strength : {0.1, 0.25, 0.4, 0.5}) {
                const double now = seen(erasedBy({20, softness, strength}, before, line({150, -60}, {150, 260})));
                QVERIFY2(now < last - 0.01, qPrintable(QString("%1 %2: %3").arg(softness).arg(strength).arg(now)));
                last = now;
            }
            QVERIFY2(last > 0.35 && last < 0.65, qPrintable(QString("%1: %2").arg(softness).arg(last)));
        }
    }

    /// Beyond a half it is the width that grows, evenly.
    void strengthBeyondAHalfIsWidth()
    {
        for (const double softness : {0.6, 1.0})
            for (const double strength : {0.6, 0.8, 1.0}) {
                const double gone =
                    clearedAt(erasedBy({25, softness, strength}, wash(12), line({150, -60}, {150, 260})), 100);
                const double wished = 25 * (2 * strength - 1);
                QVERIFY2(std::abs(gone - wished) < 5,
                         qPrintable(QString("%1 %2: %3").arg(softness).arg(strength).arg(gone)));
            }
    }

    /// Wherever paint is seen, however far from a curve; and nothing is added where none is.
    void itFindsWhatIsSeen()
    {
        Stroke thick = wash(30, 2); // rows 100 apart
        for (Segment &s : thick.segments)
            s.density *= 6;
        QVERIFY(seenAt(thick, {150, 50}) > 0.5);
        const Stroke between = erasedBy({6, 0.6, 1}, thick, line({100, 50}, {200, 50}));
        QVERIFY(between.hasErasure());
        QVERIFY(seenAt(between, {150, 50}) < 0.1);

        const Stroke before = wash(14);
        QCOMPARE(erasedBy({20, 0.6, 1}, before, line({-500, 600}, {900, 700})), before);
        const Stroke across = erasedBy({20, 0.6, 1}, before, line({150, -400}, {150, 600}));
        for (const Segment &s : across.segments)
            if (s.lift)
                QVERIFY(s.bezier[0].y > -100 && s.bezier[0].y < 300); // and no more than it needs
        // Two parts of the path over paint are two chains.
        std::vector<PenSample> twice = line({100, 100}, {100, -200});
        for (const PenSample &sample : line({250, -200}, {250, 100}, 1, dry + 700'000))
            twice.push_back(sample);
        const Stroke parts = erasedBy({10, 0.6, 1}, before, twice);
        QCOMPARE(std::ranges::count_if(parts.segments, [](const Segment &s) { return s.lift && s.start; }), 2);
        QCOMPARE(problemOf(parts), QString());
    }

    void hairlinesAreFound()
    {
        Stroke hair = wash(0.4, 2);
        for (const double x : {37.0, 151.3, 260.0}) {
            const Stroke after = erasedBy({20, 0.6, 1}, hair, line({x, 60}, {x, 140}));
            QVERIFY(after.hasErasure());
            QVERIFY(seenAt(after, {x, 100}) < 0.1);
            QVERIFY(seenAt(after, {x < 150 ? x + 45 : x - 45, 100}) > 0.5);
            QCOMPARE(seenAt(after, {x, 0}), seenAt(hair, {x, 0}));
        }
        QVERIFY(erasedBy({20, 0.6, 1}, hair, {{{150, 100}, dry}}).hasErasure()); // a tap
    }

    void aTapTakesADisc()
    {
        const Stroke after = erasedBy({20, 0.6, 1}, wash(14), {{{150, 100}, dry}, {{150, 100}, dry + 200'000}});
        QVERIFY(after.hasErasure());
        for (const Point way : {Point{1, 0}, Point{0, 1}, Point{-0.7, 0.7}}) {
            QVERIFY(seenAt(after, Point{150, 100} + 14.0 * way) < 0.5);
            QVERIFY(seenAt(after, Point{150, 100} + 27.0 * way) > 0.5);
        }
    }

    /// Rubbing to and fro at full strength: the hole stays as wide as the circle, and nothing is laid down twice.
    void rubbingTakesNoMoreThanThereIs()
    {
        const Stroke before = wash(14);
        std::vector<PenSample> rubbed;
        for (int k = 0; k < 6; ++k)
            for (PenSample sample : line({150, k % 2 ? 190.0 : 10.0}, {150, k % 2 ? 10.0 : 190.0})) {
                sample.time += k * 700'000;
                rubbed.push_back(sample);
            }
        const SoftTip tip{20, 0.6, 1};
        const Stroke once = erasedBy(tip, before, line({150, 10}, {150, 190}));
        const Stroke often = erasedBy(tip, before, rubbed);
        QVERIFY(clearedAt(often, 100) < clearedAt(once, 100) + 5);
        QVERIFY2(often.segments.size() - before.segments.size() < 3 * (once.segments.size() - before.segments.size()),
                 qPrintable(QString::number(often.segments.size())));
        // A weak one takes more each time.
        const SoftTip weak{20, 0.6, 0.3};
        const double first =
            strokeDensityAt(erasedBy(weak, before, line({150, 10}, {150, 190})), 30'000'000, {150, 100});
        const double sixth = strokeDensityAt(erasedBy(weak, before, rubbed), 30'000'000, {150, 100});
        QVERIFY(sixth < 0.8 * first);
    }

    /// What was shown during the drag and what comes of it are one thing: frozen parts do not change.
    void whatWasFoundStays()
    {
        const Stroke before = wash(14);
        SoftEraser eraser({15, 0.6, 1}, {std::make_shared<const Stroke>(before)}, dry);
        std::vector<std::vector<Segment>> shown;
        for (const PenSample &sample : line({20, 20}, {280, 180})) {
            eraser.add(sample);
            shown.push_back(eraser.erased(before).segments);
        }
        eraser.finish();
        const std::vector<Segment> after = eraser.erased(before).segments;
        QVERIFY(after.size() > before.segments.size() + 30);
        constexpr std::size_t tail = 20; // parts that may still change: the knots that a spline looks ahead
        for (const std::vector<Segment> &then : shown) {
            const auto [differs, end] = std::ranges::mismatch(then, after);
            QVERIFY(std::size_t(then.end() - differs) <= tail);
        }
    }

    /// What is painted after the moment is not there, and what is still wet counts as it will be, too.
    void theMomentCounts()
    {
        Stroke stroke = wash(14);
        const Microseconds middle = stroke.segments[24].born;
        const Stroke early = erasedBy({15, 0.6, 1}, stroke, line({150, 150}, {150, 250}, 1, middle), middle);
        QCOMPARE(early, stroke); // the lower rows are not begun
        for (Segment &s : stroke.segments)
            s.maxAge = 100;
        const Microseconds wet = stroke.segments.back().born + 300'000; // of ten times the spread that it will have
        const Stroke after = erasedBy({15, 0.6, 1}, stroke, line({150, -20}, {150, 220}, 1, wet), wet);
        QVERIFY(after.hasErasure());
        QCOMPARE(problemOf(after), QString());
    }

    void anyStrokeStaysSound()
    {
        AwkwardStrokes random(11);
        for (int i = 0; i < 60; ++i) {
            Stroke s = random.chains(1 + random.below(9));
            s.id = 1;
            const double radius = std::exp(random.real(-3, 4));
            const Stroke after = erasedBy(
                {radius, random.real(0.4, 2), random.real(0.05, 1)}, s,
                line(s.origin + random.point(60), s.origin + random.point(60), float(random.real(0, 1)), 90'000'000),
                90'000'000);
            QCOMPARE(problemOf(after), problemOf(s));
            QVERIFY(std::equal(s.segments.begin(), s.segments.end(), after.segments.begin()));
            for (std::size_t k = s.segments.size(); k < after.segments.size(); ++k)
                QVERIFY(after.segments[k].lift);
        }
    }

    /// A fill is seen although its gradient begins transparent, and what bounds it has that colour.
    void gradientsThatBeginTransparent()
    {
        Stroke stroke = test::line({{100, -50}, {200, -50}, {200, 50}, {100, 50}});
        for (Segment &segment : stroke.segments) {
            segment.density = 0;
            segment.colour = {1, 0, 0, 0};
        }
        stroke.style = {StyleKind::Uniform, {0.5f, 0.05f, 0}};
        Fill fill;
        fill.diffusion = 0;
        fill.colour = {1, 0, 0, 0};
        fill.gradient = Gradient{toOffset({100, 0}, stroke.origin), toOffset({101, 0}, stroke.origin), {1, 0, 0, 1}};
        stroke.fill = fill;
        QVERIFY(seenAt(stroke, {150, 0}) > 0.9);
        const Stroke after = erasedBy({10, 0.5, 1}, stroke, line({150, -20}, {150, 20}));
        QVERIFY(after.hasErasure());
        QVERIFY(seenAt(after, {150, 0}) < 0.1);
        QVERIFY(seenAt(after, {190, 0}) > 0.9);
    }

    /// What fades takes its share in the middle of the path, whatever paint there is, and a second pass takes it again.
    void aShareFades()
    {
        for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
            Stroke before = wash(20);
            before.style = kind == StyleKind::Uniform      ? Style{kind, {1, 0.1f, 0}}
                           : kind == StyleKind::Feathering ? Style{kind, {3, 1.2f, 0}}
                                                           : Style{kind, {1, 1, 0.4f}};
            const double was = seenAt(before, {150, 100});
            QVERIFY(was > 0.1);
            for (const double strength : {0.2, 0.5, 0.8, 1.0})
                for (const double softness : {0.4, 0.6, 1.0, 2.0}) {
                    const SoftTip tip{20, softness, strength, SoftWay::Fade};
                    const Stroke once = erasedBy(tip, before, line({150, -60}, {150, 260}));
                    QCOMPARE(problemOf(once), QString());
                    QVERIFY(once.hasFade() && std::ranges::none_of(once.segments, &Segment::lift));
                    const double left = seenAt(once, {150, 100}) / was;
                    QVERIFY2(std::abs(left - (1 - strength)) < 0.01, qPrintable(QString::number(left)));
                    // Half of the strength at most is taken at the radius, and more where it is nearer.
                    QVERIFY(seenAt(once, {170, 100}) / was > 0.49);
                    QVERIFY(seenAt(once, {160, 100}) < seenAt(once, {170, 100}));
                    const Stroke twice = erasedBy(tip, once, line({150, -60}, {150, 260}));
                    QVERIFY(std::abs(seenAt(twice, {150, 100}) / was - left * left) < 0.01);
                    if (strength == 1)
                        QVERIFY(seenAt(once, {150 + 20 - tip.spread(), 100}) <= 1.0 / 1024);
                }
            // Where nothing is left to be seen, nothing is laid.
            const SoftTip whole{20, 0.6, 1, SoftWay::Fade}, small{4, 0.6, 1, SoftWay::Fade};
            const Stroke gone = erasedBy(whole, before, line({150, -60}, {150, 260}));
            QVERIFY(erasedBy(small, gone, line({150, 80}, {150, 120}), gone.driesAt()) == gone);
            QVERIFY(erasedBy(small, before, line({150, 80}, {150, 120}), gone.driesAt()) != before);
        }
    }

    /// The strokes of a wash are one, so one of them carries what fades all, on the whole of the path.
    void aWashFadesOnce()
    {
        Stroke left = wash(20), right = wash(20);
        right.id = 8;
        right.origin = {200, 0};
        left.group = right.group = 2;
        Group inner, outer;
        inner.id = 2, inner.parent = 1;
        outer.id = 1, outer.wash = Wash{left.style, {}};
        const std::vector<PenSample> path = line({20, 100}, {480, 100});
        const SoftTip tip{20, 0.6, 0.5, SoftWay::Fade};
        const auto erasures = [&](const SoftEraser::Washes &washes) {
            const std::vector<StrokePtr> strokes{std::make_shared<const Stroke>(left),
                                                 std::make_shared<const Stroke>(right)};
            SoftEraser eraser(tip, strokes, dry, washes);
            for (const PenSample &sample : path)
                eraser.add(sample);
            eraser.finish();
            return std::pair(eraser.erased(left), eraser.erased(right));
        };
        const auto [alone, beside] = erasures({});
        QVERIFY(alone.hasFade() && beside.hasFade());
        const auto [first, second] = erasures({{1, &outer}, {2, &outer}});
        QVERIFY(first.hasFade() && second == right);
        for (const double x : {60.0, 150.0, 250.0, 350.0, 440.0}) {
            double faded = 0;
            for (const Segment &segment : first.segments)
                if (segment.fade)
                    faded += segmentDensityAt(first, segment, first.driesAt(), {x, 100});
            QVERIFY2(std::abs(faded - std::log(2)) < 0.02, qPrintable(QString::number(faded)));
        }
    }
};

QTEST_APPLESS_MAIN(TestSoftEraser)
#include "test_soft_eraser.moc"
